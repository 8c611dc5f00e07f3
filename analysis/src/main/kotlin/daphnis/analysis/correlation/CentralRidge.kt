package daphnis.analysis.correlation

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.hypot
import kotlin.math.pow
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * The direction of the central ridge of a surface density's autocorrelation A(Δ): that along which the mean of A, from
 * the middle to a quarter of the patch, is largest. It is there for wakes that do not repeat, too, which have no
 * [WavePattern]; it says nothing about a spacing. Errors are those of [WavePattern].
 *
 * @property pitch angle in radians between the orbit (y) and the ridge, in (−π/2, π/2]; trailing, which leans backward
 *   outward, positive
 * @property contrast mean of A along the ridge over the scatter that the same mean has by chance
 */
public class CentralRidge private constructor(public val pitch: BlockAverage, public val contrast: Double) {
    public companion object {
        /** Standard deviations of chance by which the ridge must stand above the median of all directions. */
        public const val LEAST_CONTRAST: Double = 8.0

        /** The mean along the ridge over that of the median direction. */
        public const val LEAST_RATIO: Double = 1.5
        private const val FEWEST_LAGS = 6
        private const val DIRECTIONS = 180
        private const val NARROW = 4

        /** Cells around the middle that are left out, gradually. */
        private const val MIDDLE = 2.0

        /**
         * The ridge in autocorrelations of [SurfaceMap], one of each state in order of time, of lags up to [lagX] and
         * [lagY] cells of [dx] × [dy]; null where no direction stands out from chance and from all others.
         */
        @JvmStatic
        public fun of(maps: List<DoubleArray>, lagX: Int, lagY: Int, dx: Double, dy: Double): CentralRidge? {
            if (maps.isEmpty() || lagX < FEWEST_LAGS || lagY < FEWEST_LAGS) return null
            val size = (2 * lagX + 1) * (2 * lagY + 1)
            for (map in maps) require(map.size == size) { "a map has ${map.size} lags; it must have $size" }
            val lines = Lines(lagX, lagY, dx, dy)
            val total = DoubleArray(size)
            for (map in maps) for (k in 0 until size) total[k] += map[k]
            val along = lines.means(DoubleArray(size) { total[it] / maps.size })
            val best = along.indices.maxByOrNull { along[it] } ?: return null
            val median = along.sorted()[DIRECTIONS / 2]
            val chance = lines.scatter(DoubleArray(size) { total[it] / maps.size })
            val contrast = (along[best] - median) / chance
            if (!(contrast >= LEAST_CONTRAST && along[best] >= LEAST_RATIO * median)) return null
            val pitch = lines.top(along, best)
            val n = maps.size
            val pitches = DoubleArray(if (n > 1) n else 0) { k ->
                val without = lines.means(DoubleArray(size) { (total[it] - maps[k][it]) / (n - 1) })
                // The same axis half a turn on is the same axis.
                val change = lines.top(without, lines.climb(without, best)) - pitch
                pitch - (n - 1) * (change - PI * Math.rint(change / PI))
            }
            val of = if (n > 1) IndependentStates(maps).average(pitch, pitches) else BlockAverage(pitch, Double.NaN, n)
            return CentralRidge(of, contrast)
        }
    }

    /** Means of a map along lines through its middle. */
    private class Lines(private val lagX: Int, private val lagY: Int, private val dx: Double, private val dy: Double) {
        private val width = 2 * lagY + 1
        private val cell = maxOf(dx, dy)
        private val reach = minOf(lagX * dx, lagY * dy) / 2

        /**
         * By direction, of each lag: a triangle along the line times a Gaussian of one cell across it, which hides from
         * the means how the line lies to the lattice. The middle, which is the noise of counting, is left out. Their
         * sum is 1.
         */
        private val weights = Array(DIRECTIONS) { weights(angle(it)) }

        private fun angle(direction: Int) = PI * (direction + 0.5) / DIRECTIONS - PI / 2

        private fun weights(pitch: Double): DoubleArray {
            val weight = DoubleArray((2 * lagX + 1) * width) {
                val x = (it / width - lagX) * dx
                val y = (it % width - lagY) * dy
                val along = abs(y * cos(pitch) - x * sin(pitch))
                val across = (x * cos(pitch) + y * sin(pitch)) / cell
                val middle = exp(-(hypot(x, y) / (MIDDLE * cell)).pow(4))
                if (along >= reach) 0.0 else (1 - middle) * (1 - along / reach) * exp(-across * across / 2)
            }
            val sum = weight.sum()
            return DoubleArray(weight.size) { weight[it] / sum }
        }

        fun means(map: DoubleArray) = DoubleArray(DIRECTIONS) { d ->
            val weight = weights[d]
            var sum = 0.0
            for (k in map.indices) sum += weight[k] * map[k]
            sum
        }

        /** Of the mean along a line, from the lags beyond the reach of lines; a lag and its mirror count as one. */
        fun scatter(map: DoubleArray): Double {
            val far = map.indices.filter {
                abs(it / width - lagX) * dx > reach || abs(it % width - lagY) * dy > reach
            }
            return sqrt(far.sumOf { map[it] * map[it] } / far.size * 2 * weights[0].sumOf { it * it })
        }

        /** From the direction [start] to the next that is higher than its neighbours. */
        fun climb(means: DoubleArray, start: Int): Int {
            var at = start
            while (true) {
                val next = listOf(at, at + 1, at - 1).map { Math.floorMod(it, DIRECTIONS) }.maxByOrNull { means[it] }!!
                if (next == at) return at
                at = next
            }
        }

        /** Pitch at the top of the parabola that fits the means around [best] best. */
        fun top(means: DoubleArray, best: Int): Double {
            fun mean(d: Int) = means[Math.floorMod(best + d, DIRECTIONS)]
            // Orthogonal polynomials over −NARROW..NARROW: 1, d, d² − mean of d².
            val all = -NARROW..NARROW
            val square = all.sumOf { it * it }.toDouble()
            val middle = square / (2 * NARROW + 1)
            val slope = all.sumOf { it * mean(it) } / square
            val bend =
                all.sumOf { (it * it - middle) * mean(it) } / all.sumOf { (it * it - middle) * (it * it - middle) }
            val shift = if (bend < 0) (-slope / (2 * bend)).coerceIn(-1.0 * NARROW, 1.0 * NARROW) else 0.0
            val pitch = angle(best) + shift * PI / DIRECTIONS
            return pitch - PI * Math.rint(pitch / PI)
        }
    }
}
