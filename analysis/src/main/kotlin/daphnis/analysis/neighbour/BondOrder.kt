package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import kotlin.math.PI
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * Bond order of the particles of a state in space (Steinhardt, Nelson & Ronchetti 1983, Phys. Rev. B 28, 784): with
 * q_lm the mean of Y_lm over the directions of the neighbours, q_l = (4π/(2l + 1) Σ_m |q_lm|²)^½, which is 0.19 (l = 4)
 * and 0.575 (l = 6) in a face-centred cubic crystal and smaller in a fluid.
 *
 * Arrays are by index in the population, NaN for bodies and for particles without a neighbour. Neighbours that are each
 * on the other's list count as [lists] has them.
 *
 * @throws IllegalArgumentException for discs, which have [HexaticOrder]
 */
public class BondOrder(state: State, private val lists: NeighbourLists) {
    private val size = state.population.size

    init {
        require(state.dimensions == 3) { "discs have six-fold order in the plane, not in space" }
        require(lists.size == size) { "neighbours of ${lists.size} spheres; the state has $size" }
    }

    private val four = harmonics(4)
    private val six = harmonics(6)

    /**
     * q₄ and, averaged over the particle and its neighbours, q̄₄ (Lechner & Dellago 2008, J. Chem. Phys. 129, 114707).
     */
    public val q4: DoubleArray = lengths(four, 4)
    public val averagedQ4: DoubleArray by lazy { lengths(averaged(four, 4), 4) }

    /** q₆ and q̄₆. */
    public val q6: DoubleArray = lengths(six, 6)
    public val averagedQ6: DoubleArray by lazy { lengths(averaged(six, 6), 6) }

    /** w₆ over (Σ |q_6m|²)^{3/2}: −0.0132 for fcc, −0.0124 for hcp, 0.0132 for bcc of 14 neighbours. */
    public val w6: DoubleArray by lazy {
        val y = Harmonics(6)
        DoubleArray(size) { i ->
            val square = square(six, 6, i, i)
            if (square > 0) y.third(six, i * width(6)) / square.pow(1.5) else Double.NaN
        }
    }

    /**
     * Σ_m q_6m(i) q*_6m(j) over the lengths of both: how alike the surroundings of [i] and [j] are oriented, up to 1.
     */
    public fun likeness(i: Int, j: Int): Double =
        square(six, 6, i, j) / sqrt(square(six, 6, i, i) * square(six, 6, j, j))

    /**
     * Which particles are in solid-like surroundings (ten Wolde, Ruiz-Montero & Frenkel 1996, J. Chem. Phys. 104,
     * 9932): of their neighbours [least] at least have a [likeness] above [threshold].
     */
    @JvmOverloads
    public fun solidLike(threshold: Double = LIKE, least: Int = CONNECTIONS): BooleanArray = BooleanArray(size) { i ->
        (0 until lists.count(i)).count { likeness(i, lists.neighbour(i, it)) > threshold } >= least
    }

    private fun width(l: Int) = 2 * (l + 1)

    private fun harmonics(l: Int): DoubleArray {
        val y = Harmonics(l)
        val all = DoubleArray(size * width(l))
        for (i in 0 until size) {
            val n = lists.count(i)
            for (k in 0 until n) {
                val dx = lists.component(i, k, 0)
                val dy = lists.component(i, k, 1)
                val dz = lists.component(i, k, 2)
                y.add(dx, dy, dz, sqrt(dx * dx + dy * dy + dz * dz), all, i * width(l))
            }
            for (m in 0 until width(l)) all[i * width(l) + m] /= n.toDouble()
        }
        return all
    }

    private fun averaged(q: DoubleArray, l: Int): DoubleArray {
        val all = DoubleArray(q.size)
        for (i in 0 until size) {
            val n = lists.count(i)
            for (m in 0 until width(l)) {
                var sum = q[i * width(l) + m]
                for (k in 0 until n) sum += q[lists.neighbour(i, k) * width(l) + m]
                all[i * width(l) + m] = sum / (n + 1)
            }
        }
        return all
    }

    private fun lengths(q: DoubleArray, l: Int) =
        DoubleArray(size) { sqrt(4 * PI / (2 * l + 1) * square(q, l, it, it)) }

    /** Re Σ over all m of q_lm(i) q*_lm(j): those of ±m tell the same. */
    private fun square(q: DoubleArray, l: Int, i: Int, j: Int): Double {
        val a = i * width(l)
        val b = j * width(l)
        var sum = q[a] * q[b] / 2
        for (m in 2 until width(l)) sum += q[a + m] * q[b + m]
        return 2 * sum
    }

    public companion object {
        /** Likeness above which two neighbours are connected. */
        public const val LIKE: Double = 0.7

        /** Connections of a solid-like particle. */
        public const val CONNECTIONS: Int = 7
    }
}

/**
 * Six-fold order of discs (Nelson & Halperin 1979, Phys. Rev. B 19, 2457): ψ₆ is the mean of exp(6iθ) over the
 * directions θ of the neighbours. Arrays are by index in the population, NaN for bodies and without a neighbour.
 *
 * @throws IllegalArgumentException for spheres in space
 */
public class HexaticOrder(private val state: State, lists: NeighbourLists) {
    init {
        require(state.dimensions == 2) { "spheres in space have bond order, not six-fold order in a plane" }
        require(lists.size == state.population.size) {
            "neighbours of ${lists.size} discs; the state has ${state.population.size}"
        }
    }

    /** Re ψ₆, and Im ψ₆ in [imaginary]. */
    public val real: DoubleArray = DoubleArray(lists.size)
    public val imaginary: DoubleArray = DoubleArray(lists.size)

    init {
        for (i in 0 until lists.size) {
            val n = lists.count(i)
            for (k in 0 until n) {
                val angle = 6 * Math.atan2(lists.component(i, k, 1), lists.component(i, k, 0))
                real[i] += Math.cos(angle)
                imaginary[i] += Math.sin(angle)
            }
            real[i] /= n.toDouble()
            imaginary[i] /= n.toDouble()
        }
    }

    /** |ψ₆|. */
    public val modulus: DoubleArray = DoubleArray(lists.size) { Math.hypot(real[it], imaginary[it]) }

    /** |⟨ψ₆⟩| over all discs: 1 in one crystal, 0 where orientations differ. */
    public val ofAll: Double = run {
        val counted = modulus.indices.filter { !modulus[it].isNaN() }
        Math.hypot(counted.sumOf { real[it] }, counted.sumOf { imaginary[it] }) / counted.size
    }
}
