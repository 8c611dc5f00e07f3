package daphnis.analysis.order

import daphnis.analysis.insitu.State
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import kotlin.math.sqrt

/** The key by which particles are put into radial order. */
public enum class RadialKey {
    /** Radial position x. */
    X,

    /** Radial position of the guiding centre, X = 4x + 2 v_y/Ω; needs Hill's frame. */
    GUIDING_CENTRE,

    /** Distance from the planet's axis, which is at x = −[RadialOrder.planetDistance]. */
    DISTANCE,
}

/**
 * The order of a population by radial distance, without moving the population. Kept from call to call: a population
 * that is nearly in its previous order is sorted in one pass. Otherwise the keys go through a radix sort, linear in N.
 * Particles with equal keys are in the order of their ids, so the result does not depend on the order of the arrays.
 *
 * @param planetDistance distance of the frame's origin from the planet, for [RadialKey.DISTANCE]
 * @param loop threads to use
 */
public class RadialOrder @JvmOverloads constructor(
    public val planetDistance: Double = Double.NaN,
    private val loop: RangeLoop = InlineLoop,
) {
    /** Index in the population by rank, innermost first; the first [size] entries. */
    public var order: IntArray = IntArray(0)
        private set

    /** Number of particles. */
    public var size: Int = 0
        private set

    private var keys = LongArray(0)
    private var spareKeys = LongArray(0)
    private var spareOrder = IntArray(0)
    private var lastIds = IntArray(0)

    /** Whether the last sort started from the previous order. */
    public var wasNearlySorted: Boolean = false
        private set

    /**
     * Sorts the particles of [state] by [key].
     *
     * @throws IllegalArgumentException for a guiding centre without Hill's frame, or a distance without
     *   [planetDistance]
     */
    public fun sort(state: State, key: RadialKey): RadialOrder {
        val p = state.population
        val orbits = state.frequencies
        require(key != RadialKey.GUIDING_CENTRE || orbits != null) { "order by guiding centre needs Hill's frame" }
        require(key != RadialKey.DISTANCE || planetDistance.isFinite()) {
            "order by distance needs the distance of the planet"
        }
        size = p.size
        reserve()
        beginWithLastOrder(p)
        loop.run(size) { _, from, to ->
            for (rank in from until to) {
                keys[rank] =
                    sortable(value(p, order[rank], key, orbits))
            }
        }
        wasNearlySorted = insert()
        if (!wasNearlySorted) radix()
        orderTies(p)
        lastIds = IntArray(size) { p.id[order[it]] }
        return this
    }

    /** Rank by index in the population. Allocates. */
    public fun ranks(): IntArray = IntArray(size).also { for (rank in 0 until size) it[order[rank]] = rank }

    private fun value(p: Population, k: Int, key: RadialKey, orbits: OrbitalFrequencies?): Double = when (key) {
        RadialKey.X -> p.x[k]
        RadialKey.GUIDING_CENTRE -> orbits!!.guidingX(p.x[k], p.vy[k])
        RadialKey.DISTANCE -> sqrt((p.x[k] + planetDistance) * (p.x[k] + planetDistance) + p.y[k] * p.y[k])
    }

    /** A number whose order as a long is that of [v] as a double; −0 and 0 are the same. */
    private fun sortable(v: Double): Long {
        val bits = (v + 0.0).toRawBits()
        return bits xor ((bits shr 63) ushr 1)
    }

    private fun reserve() {
        if (order.size >= size) return
        keys = LongArray(size)
        spareKeys = LongArray(size)
        spareOrder = IntArray(size)
        // Last, since its length says how many there is room for: an allocation before it may have failed.
        order = IntArray(size)
    }

    private fun beginWithLastOrder(p: Population) {
        if (lastIds.size != size) {
            for (k in 0 until size) order[k] = k
            return
        }
        for (rank in 0 until size) {
            val k = p.indexOf(lastIds[rank])
            if (k < 0) {
                for (index in 0 until size) order[index] = index
                return
            }
            order[rank] = k
        }
    }

    /** Insertion sort, abandoned after a few moves per particle. @return whether it was completed */
    private fun insert(): Boolean {
        var moves = MOVES_A_PARTICLE * size
        for (k in 1 until size) {
            val key = keys[k]
            if (keys[k - 1] <= key) continue
            val index = order[k]
            var place = k
            while (place > 0 && keys[place - 1] > key) {
                keys[place] = keys[place - 1]
                order[place] = order[place - 1]
                place--
            }
            keys[place] = key
            order[place] = index
            moves -= k - place
            if (moves < 0) return false
        }
        return true
    }

    /**
     * From the lowest digit to the highest, each pass stable; parts of the array are counted and moved by different
     * threads.
     */
    private fun radix() {
        val parts = loop.workers
        val counts = Array(parts) { IntArray(1 shl DIGIT) }
        var shift = 0
        while (shift < Long.SIZE_BITS) {
            val s = shift
            loop.run(parts, 1) { _, from, to -> for (part in from until to) count(counts[part], part, parts, s) }
            if (startPlaces(counts)) {
                loop.run(parts, 1) { _, from, to -> for (part in from until to) move(counts[part], part, parts, s) }
                keys = spareKeys.also { spareKeys = keys }
                order = spareOrder.also { spareOrder = order }
            }
            shift += DIGIT
        }
    }

    private fun count(counts: IntArray, part: Int, parts: Int, shift: Int) {
        counts.fill(0)
        for (k in share(part, parts) until share(part + 1, parts)) counts[digit(keys[k], shift)]++
    }

    /** Turns counts into places. @return false if all have the same digit */
    private fun startPlaces(counts: Array<IntArray>): Boolean {
        var place = 0
        for (d in 0 until (1 shl DIGIT)) {
            val before = place
            for (part in counts.indices) place += counts[part][d].also { counts[part][d] = place }
            if (place - before == size) return false
        }
        return true
    }

    private fun move(places: IntArray, part: Int, parts: Int, shift: Int) {
        for (k in share(part, parts) until share(part + 1, parts)) {
            val place = places[digit(keys[k], shift)]++
            spareKeys[place] = keys[k]
            spareOrder[place] = order[k]
        }
    }

    private fun share(part: Int, parts: Int) = (size.toLong() * part / parts).toInt()

    /** The highest digit contains the sign, inverted so that negative numbers come first. */
    private fun digit(key: Long, shift: Int): Int =
        ((key xor Long.MIN_VALUE) ushr shift).toInt() and ((1 shl DIGIT) - 1)

    private fun orderTies(p: Population) {
        var from = 0
        while (from < size) {
            var to = from + 1
            while (to < size && keys[to] == keys[from]) to++
            if (to - from > 1) {
                val tied =
                    LongArray(to - from) { (p.id[order[from + it]].toLong() shl 32) or order[from + it].toLong() }
                tied.sort()
                for (k in tied.indices) order[from + k] = tied[k].toInt()
            }
            from = to
        }
    }

    private companion object {
        const val DIGIT = 11
        const val MOVES_A_PARTICLE = 8L
    }
}
