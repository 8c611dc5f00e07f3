package daphnis.analysis.neighbour

import daphnis.analysis.correlation.PairCorrelation
import daphnis.analysis.insitu.State
import kotlin.math.PI
import kotlin.math.acos

/** Which particles count as neighbours of one. */
public sealed class Neighbours {
    /** How far candidates may be, in a first attempt. */
    internal abstract fun reach(state: State): Double

    /**
     * How many of the candidates, [distances] in ascending order, are neighbours; −1 where it takes more candidates.
     *
     * @param size number of candidates
     */
    internal abstract fun count(distances: DoubleArray, size: Int, dimensions: Int): Int

    /** All whose centres are up to [distance] away. */
    public class Within(public val distance: Double) : Neighbours() {
        init {
            require(distance > 0 && distance.isFinite()) { "neighbours up to $distance away; it must be positive" }
        }

        override fun reach(state: State): Double = distance

        override fun count(distances: DoubleArray, size: Int, dimensions: Int): Int {
            var n = 0
            while (n < size && distances[n] <= distance) n++
            return n
        }
    }

    /**
     * The nearest ones that fill the whole solid angle around a particle (SANN; van Meel, Filion, Valeriani & Frenkel
     * 2012, J. Chem. Phys. 136, 234107): the least m for which Σ (1 − r_j/r_{m+1}) over the nearest m comes to 2. Of
     * discs Σ acos(r_j/r_{m+1}) comes to π. It has no parameter; a particle may be a neighbour of one that is not its
     * own.
     */
    public object SolidAngle : Neighbours() {
        private const val FIRST = 2.0

        override fun reach(state: State): Double {
            val p = state.population
            val largest = (0 until p.size).maxOfOrNull { if (state.isParticle(it)) p.radius[it] else 0.0 } ?: 0.0
            val particles = (0 until p.size).count { state.isParticle(it) }
            val d = state.dimensions
            val box = state.boundary.box
            val room = if (d == 2) box.length(0) * box.length(1) else box.volume
            // So that some twenty are there as a rule, or as near as spheres come.
            val spacing = Math.pow(room / maxOf(1, particles), 1.0 / d)
            return maxOf(2 * FIRST * largest * (if (d == 2) 1.0 else 0.85), spacing * (if (d == 2) 2.2 else 1.75))
        }

        override fun count(distances: DoubleArray, size: Int, dimensions: Int): Int {
            for (m in dimensions until size) {
                val next = distances[m]
                var sum = 0.0
                for (j in 0 until m) sum += if (dimensions == 2) acos(distances[j] / next) else 1 - distances[j] / next
                if (sum >= if (dimensions == 2) PI else 2.0) return m
            }
            return -1
        }
    }

    public companion object {
        /**
         * Those within the first minimum of g(r), as [states] show it on average: where the mean of three bins of a
         * twentieth of a diameter is lowest between the highest peak, within 1.5 mean diameters, and 2.2, or half the
         * shortest edge.
         *
         * @throws IllegalArgumentException for no state, or an edge below 3.9 diameters
         */
        @JvmStatic
        public fun toFirstMinimum(vararg states: State): Within {
            require(states.isNotEmpty()) { "no state to see the first minimum of g(r) in" }
            val p = states[0].population
            val diameter = 2 * (0 until p.size).filter { states[0].isParticle(it) }.map { p.radius[it] }.average()
            val farthest = minOf(FARTHEST * diameter, states.minOf { PairCorrelation.farthest(it.boundary) })
            require(farthest >= NEAREST * diameter) {
                "the first minimum of g(r) is sought up to ${FARTHEST * diameter}; " +
                    "the box, by half its shortest edge, has room for $farthest"
            }
            val pairs = PairCorrelation(farthest, (farthest / diameter * BINS).toInt().coerceAtLeast(3))
            val g = DoubleArray(pairs.bins)
            for (state in states) for ((bin, value) in pairs.of(state).withIndex()) g[bin] += value
            val mean = DoubleArray(g.size) {
                if (it == 0 ||
                    it == g.size - 1
                ) {
                    Double.NaN
                } else {
                    g[it - 1] + g[it] + g[it + 1]
                }
            }
            val peak = (1 until g.size - 1).filter { pairs.centre(it) < PEAK * diameter }.maxBy { mean[it] }
            val least = (peak until g.size - 1).minBy { mean[it] }
            return Within(pairs.centre(least))
        }

        private const val FARTHEST = 2.2
        private const val NEAREST = 1.95
        private const val PEAK = 1.5
        private const val BINS = 20
    }
}
