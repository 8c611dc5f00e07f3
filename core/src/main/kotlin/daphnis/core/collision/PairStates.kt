package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.population.Bonds
import daphnis.core.population.SphereColumns
import daphnis.core.potential.Edge
import daphnis.core.potential.PairInteractions
import daphnis.core.potential.PairState
import daphnis.core.space.Images
import kotlin.math.max
import kotlin.math.sqrt

/**
 * The states of all [PairInteractions] in one table, by number. The first are those of pairs that are far away, one for
 * each interaction; for [Bonds] all of them are [Bonds.UNBOUND]. The others are numbered through all interactions, so
 * the number alone says what the state is. Immutable.
 */
internal class PairStates(private val interactions: PairInteractions) {
    private val kinds = interactions.all
    private val offsets = IntArray(kinds.size)
    private val all: List<PairState>

    init {
        val bound = ArrayList<PairState>()
        for ((kind, its) in kinds.withIndex()) {
            offsets[kind] = kinds.size - 1 + bound.size
            bound += its?.states.orEmpty().drop(1)
        }
        all = kinds.map { it?.states?.first() ?: HARD } + bound
    }

    private val kindOf = IntArray(all.size) { state ->
        if (state < kinds.size) state else kinds.indices.last { offsets[it] < state }
    }

    /** The number of state [own] of [kind]. */
    private fun number(kind: Int, own: Int) = if (own == 0) kind else offsets[kind] + own

    private val inner = DoubleArray(all.size) { all[it].inner?.ratio ?: 0.0 }
    private val outer = DoubleArray(all.size) { all[it].outer?.ratio ?: Double.POSITIVE_INFINITY }
    private val innerCost = DoubleArray(all.size) { all[it].inner?.cost ?: 0.0 }
    private val outerCost = DoubleArray(all.size) { all[it].outer?.cost ?: 0.0 }
    private val innerNext = IntArray(all.size) { state -> number(kindOf[state], all[state].inner?.next ?: 0) }
    private val outerNext = IntArray(all.size) { state -> number(kindOf[state], all[state].outer?.next ?: 0) }
    private val isContact = BooleanArray(all.size) { all[it].inner?.isContact ?: false }

    /** Potential energy by number. */
    private val energy = DoubleArray(all.size) { all[it].energy }

    /** [PairInteractions.place] by the numbers of two materials, and of those of which nothing is said. */
    private val materials = interactions.materials + 1
    private val places = IntArray(materials * materials) { interactions.place(it / materials, it % materials) }

    private val chains = interactions.chains

    /** The state of neighbours in a chain. */
    private val tied = kinds.indexOf(chains?.tether)

    /** The largest distance of an edge over the sum of the radii. */
    val reach: Double = interactions.reach

    /** Whether no spheres pass through one another. */
    val areHard: Boolean = interactions.areHard

    /** The number of the state of the pair in the slots [first] and [second], of [a] and [b]. */
    fun of(a: StepRows, first: Int, b: StepRows, second: Int): Int {
        if (chains != null && chains.areTied(a.id[first], b.id[second])) return tied
        val state = Bonds.state(a.bonds[first], b.id[second])
        return if (state != Bonds.UNBOUND) state else far(material(a, first), material(b, second))
    }

    private fun far(first: Int, second: Int) = places[first * materials + second]

    private fun material(rows: StepRows, slot: Int) =
        if (rows.hasMaterials) minOf(rows.material[slot].toInt(), materials - 1) else materials - 1

    /**
     * The time, from the start of the step, at which a pair in [state] comes to an edge, for rows that begin at entry [p]
     * of [a] and entry [q] of [b]. As [daphnis.core.collision.contactTime] it is the same from either side.
     */
    fun time(state: Int, a: DoubleArray, p: Int, b: DoubleArray, q: Int, image: Int, images: Images): Double {
        relativeMotion(a, p, b, q, image, images) { t, dx, dy, dz, ux, uy, uz ->
            val along = dx * ux + dy * uy + dz * uz
            val speed2 = ux * ux + uy * uy + uz * uz
            val distance2 = dx * dx + dy * dy + dz * dz
            return t + wait(state, a[p + RADIUS] + b[q + RADIUS], distance2, along, speed2)
        }
    }

    /**
     * Time until a pair in [state] at distance² [d2], with the product [b] of distance and velocity and velocity² [a],
     * comes to an edge; ≥ 0, [NEVER], or NaN if unknown. [contact] is the sum of the radii.
     *
     * That the two are on the wrong side of an edge by round-off does no harm: at the inner edge they come to it at
     * once if they approach, at the outer one if they recede (Bannerman et al. 2014, arXiv 1211.6718).
     */
    fun wait(state: Int, contact: Double, d2: Double, b: Double, a: Double): Double {
        val far = outer[state] * contact
        // Of a pair in a box of more than twice the reach, another image is beyond the outer edge.
        if (d2 > far * far * BEYOND) return NEVER
        if (!(b >= 0.0) && inner[state] > 0) {
            val near = inner[state] * contact
            val c = d2 - near * near
            if (c <= 0.0) return 0.0
            val discriminant = b * b - a * c
            if (!(discriminant < 0.0)) return waitUntilRoot(b, c, discriminant)
        }
        return if (far == Double.POSITIVE_INFINITY) NEVER else waitUntilOutside(a, b, d2 - far * far)
    }

    /** The larger root of a t² + 2 b t + c = 0, or 0 if that is past; where there is none, when the two are closest to it. */
    private fun waitUntilOutside(a: Double, b: Double, c: Double): Double {
        if (c >= 0.0 && b >= 0.0) return 0.0
        if (a == 0.0) return NEVER
        val root = sqrt(max(0.0, b * b - a * c))
        return if (b > 0.0) -c / (root + b) else (root - b) / a
    }

    /** Whether a pair in [state] at distance² [d2] has come to its outer edge, rather than to the inner one. */
    fun isOuter(state: Int, contact: Double, d2: Double): Boolean {
        val far = outer[state] * contact
        if (far == Double.POSITIVE_INFINITY) return false
        val d = sqrt(d2)
        return far - d < d - inner[state] * contact
    }

    /** Whether the inner edge of [state] is where surfaces meet. */
    fun isContact(state: Int): Boolean = isContact[state]

    /** What passing the edge of [state] costs two spheres of the radii [r1] and [r2], see [Edge.cost]. */
    fun cost(state: Int, isOuter: Boolean, r1: Double, r2: Double): Double {
        if (!isOuter) return innerCost[state]
        val size = all[state].size ?: return outerCost[state]
        return outerCost[state] * size.factor(r1, r2)
    }

    /** The state beyond the edge of [state]. */
    fun next(state: Int, isOuter: Boolean): Int = if (isOuter) outerNext[state] else innerNext[state]

    /** Potential energy of a pair in [state]. */
    fun energy(state: Int): Double = energy[state]

    /** Half the potential energy of the pairs of the sphere at index [k] of [spheres]. */
    fun share(spheres: SphereColumns, k: Int): Double {
        val list = spheres.bonds[k]
        var sum = 0.0
        for (at in list.indices step 2) sum += energy[list[at + 1]]
        return 0.5 * sum
    }

    /** The pair in the slots [first] and [second] of [rows] is in [state] from now on. */
    fun put(rows: StepRows, first: Int, second: Int, state: Int) {
        val kept = if (state < kinds.size) Bonds.UNBOUND else state
        rows.bonds[first] = Bonds.with(rows.bonds[first], rows.id[second], kept)
        rows.bonds[second] = Bonds.with(rows.bonds[second], rows.id[first], kept)
    }

    /** Whether the spheres with these ids are neighbours in a chain. */
    fun areTied(first: Int, second: Int): Boolean = chains?.areTied(first, second) ?: false

    /**
     * The state, as [Bonds] have it, of two spheres of the materials [first] and [second] of whose past nothing is known,
     * at distance² [d2] for the sum [contact] of their radii.
     */
    fun firstState(first: Int, second: Int, contact: Double, d2: Double): Int {
        var state = far(minOf(first, materials - 1), minOf(second, materials - 1))
        while (!isContact[state] && inner[state] > 0 && d2 < inner[state] * contact * (inner[state] * contact)) {
            state = innerNext[state]
        }
        return if (state < kinds.size) Bonds.UNBOUND else state
    }

    /** The same of two that are bound, where surfaces that meet bind them; [Bonds.UNBOUND] where they do not. */
    fun boundState(first: Int, second: Int, contact: Double, d2: Double): Int {
        val far = far(minOf(first, materials - 1), minOf(second, materials - 1))
        val state = if (isContact[far]) innerNext[far] else far
        val edge = outer[state] * contact
        return if (state < kinds.size || d2 > edge * edge * BEYOND) Bonds.UNBOUND else state
    }

    private companion object {
        val HARD = PairState(0.0, Edge.contact(0), null)

        /** Room for rounding, and far less than the distance of another image. */
        const val BEYOND = 1 + 1e-6
    }
}
