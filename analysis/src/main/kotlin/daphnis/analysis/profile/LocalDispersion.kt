package daphnis.analysis.profile

import daphnis.analysis.insitu.PooledMeasure
import daphnis.analysis.insitu.State
import daphnis.analysis.insitu.forEachPair
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The thermal part of the velocity dispersion: what is left between near neighbours, without the motion that they
 * share, such as that of a wave or of a forced epicycle. As a [PooledMeasure] it gives [COLUMNS].
 *
 * Half the mean square of the difference of two velocities, the imposed flow taken out of both, is the variance around
 * any mean that both have. It is taken of pairs by their distance d in the x-y plane, up to [reach], weighted by both
 * masses, in bins of equal width in d². A smooth flow adds to it a series in d², so the value at d = 0 of the parabola
 * in d² that fits best is free of it as long as [reach] is shorter than about a third of the wavelength. It depends
 * neither on a choice of slabs nor, but for its error, on the number of particles.
 *
 * | column | what |
 * |---|---|
 * | pairs | pairs in one state |
 * | c_xx, c_yy, c_zz | ⟨c_a²⟩ by mass, c around the mean of the near neighbours |
 * | c2 | the sum of the three |
 *
 * NaN for fewer than [FEWEST_PAIRS] pairs in all states together.
 *
 * @param reach largest distance of a pair, a length
 * @property isAlongX whether distances are those along x alone, for patches so thin along y that flows vary along x only
 */
public class LocalDispersion @JvmOverloads constructor(public val reach: Double, public val isAlongX: Boolean = false) :
    PooledMeasure {
    init {
        require(reach > 0 && reach.isFinite()) { "pairs up to $reach; it must be > 0" }
    }

    /** By bin: pairs, Σ w, and for each axis Σ w Δ²/2. */
    override fun sums(state: State): DoubleArray {
        val p = state.population
        val sums = DoubleArray(BINS * WIDTH)
        if (p.size == 0) return sums
        val w = Array(3) { axis -> DoubleArray(p.size) { state.againstFlow(it, axis) } }
        fun add(i: Int, j: Int, square: Double) {
            val bin = (square / (reach * reach) * BINS).toInt()
            if (bin >= BINS) return
            val weight = p.mass[i] * p.mass[j]
            sums[bin * WIDTH]++
            sums[bin * WIDTH + WEIGHT] += weight
            for (axis in 0..2) {
                val d = w[axis][i] - w[axis][j]
                sums[bin * WIDTH + SQUARE + axis] += weight * d * d / 2
            }
        }
        if (isAlongX) {
            forEachAlongX(state, ::add)
        } else {
            // All spheres above and below are near, unless space goes on there.
            forEachPair(state, reach, inPlane = !state.boundary.hasImages(2), ::add)
        }
        return sums
    }

    /** Calls [add] with the pairs of particles whose x differ by less than [reach], through the faces too. */
    private inline fun forEachAlongX(state: State, add: (Int, Int, Double) -> Unit) {
        val x = state.population.x
        val order = x.indices.filter { state.isParticle(it) }.sortedBy { x[it] }.toIntArray()
        val length = if (state.boundary.hasImages(0)) state.boundary.box.length(0) else Double.POSITIVE_INFINITY
        for (a in order.indices) {
            for (step in 1 until order.size) {
                val isBeyond = a + step >= order.size
                if (isBeyond && length.isInfinite()) break
                val i = order[a]
                val j = order[(a + step) % order.size]
                val distance = if (isBeyond) x[j] - x[i] + length else x[j] - x[i]
                if (distance >= reach) break
                add(i, j, distance * distance)
            }
        }
    }

    override fun finish(sums: DoubleArray, states: Int): DoubleArray {
        val pairs = (0 until BINS).sumOf { sums[it * WIDTH] }
        val result = DoubleArray(COLUMNS.size) { Double.NaN }
        result[0] = pairs / states
        if (pairs < FEWEST_PAIRS) return result
        for (axis in 0..2) result[1 + axis] = maxOf(0.0, atContact(sums, axis))
        result[C2] = result[1] + result[2] + result[3]
        return result
    }

    /** The value at 0 of the parabola through the means of the bins. */
    private fun atContact(sums: DoubleArray, axis: Int): Double {
        // Normal equations of 1, u, u², with u = d²/reach² in the middle of a bin.
        val m = Array(TERMS) { DoubleArray(TERMS + 1) }
        for (bin in 0 until BINS) {
            val weight = sums[bin * WIDTH + WEIGHT]
            val u = (bin + 0.5) / BINS
            val powers = doubleArrayOf(1.0, u, u * u)
            for (a in 0 until TERMS) {
                for (b in 0 until TERMS) m[a][b] += weight * powers[a] * powers[b]
                m[a][TERMS] += powers[a] * sums[bin * WIDTH + SQUARE + axis]
            }
        }
        return first(m)
    }

    /** The first unknown of the equations [m], positive definite; solved from the last one down. */
    private fun first(m: Array<DoubleArray>): Double {
        for (last in TERMS - 1 downTo 1) {
            if (abs(m[last][last]) == 0.0) return Double.NaN
            for (a in 0 until last) {
                val part = m[a][last] / m[last][last]
                for (b in 0..TERMS) m[a][b] -= part * m[last][b]
            }
        }
        return m[0][TERMS] / m[0][0]
    }

    public companion object {
        /**
         * One with the [reach] of [state]; where the patch has no room for it along y, as thin ones of waves, along x
         * alone. Null for fewer than two particles.
         */
        @JvmStatic
        public fun fitting(state: State): LocalDispersion? {
            val wanted = wanted(state)
            val box = state.boundary.box
            val isAlongX = box.length(0) >= THIN * box.length(1) &&
                (state.boundary.meanFlow?.normalAxis ?: 0) == 0 &&
                MOST_OF_EDGE * box.length(1) < minOf(wanted, MOST_OF_EDGE * box.length(0))
            val found = if (isAlongX) minOf(wanted, MOST_OF_EDGE * box.length(0)) else reach(state)
            return if (found > 0) LocalDispersion(found, isAlongX) else null
        }

        @JvmField
        public val COLUMNS: List<String> = listOf("pairs", "c_xx", "c_yy", "c_zz", "c2")

        /** See [LocalDispersion]. */
        public const val FEWEST_PAIRS: Int = 100
        private const val BINS = 12
        private const val WIDTH = 5
        private const val WEIGHT = 1
        private const val SQUARE = 2
        private const val C2 = 4
        private const val TERMS = 3
        private const val DIAMETERS = 3
        private const val NEIGHBOURS = 12.0
        private const val MOST_OF_EDGE = 0.25

        /** Edge along x over that along y from which a patch may be too thin for pairs in the plane. */
        private const val THIN = 4

        /**
         * A distance for [state]: three mean diameters, or as far as a particle has twelve neighbours, but not above a
         * quarter of the shorter edge of the patch. NaN for fewer than two particles.
         */
        @JvmStatic
        public fun reach(state: State): Double {
            val box = state.boundary.box
            return minOf(wanted(state), MOST_OF_EDGE * minOf(box.length(0), box.length(1)))
        }

        private fun wanted(state: State): Double {
            val p = state.population
            val particles = (0 until p.size).filter { state.isParticle(it) }
            if (particles.size < 2) return Double.NaN
            val diameters = DIAMETERS * 2 * particles.sumOf { p.radius[it] } / particles.size
            val far = sqrt(NEIGHBOURS * state.area / (PI * particles.size))
            return maxOf(diameters, far)
        }
    }
}
