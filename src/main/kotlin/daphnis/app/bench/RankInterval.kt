package daphnis.app.bench

import kotlin.math.floor
import kotlin.math.sqrt

/**
 * How many times as large the numbers of one sample are as those of another, without an assumption on how they are
 * distributed: the interval that belongs to the rank sum test of Mann and Whitney (Hodges & Lehmann 1963, doi
 * 10.1214/aoms/1177704172). Single outliers do not move it.
 *
 * @property low the ratio is less than this with a probability of at most [ERROR]
 * @property high the same on the other side
 */
internal class RankInterval private constructor(val low: Double, val high: Double) {
    companion object {
        /** On each side. */
        const val ERROR = 0.05
        private const val ERROR_SIGMAS = 1.6449
        private const val MOST_EXACT = 400
        private const val ROUND_OFF = 1e-12

        /** All ratios of one of [new] and one of [old], ascending. */
        fun ratios(new: List<Double>, old: List<Double>): List<Double> =
            new.flatMap { a -> old.map { b -> a / b } }.sorted()

        /** Null where the samples are so small that any order of them is likely, and where one is a single number. */
        fun of(new: List<Double>, old: List<Double>): RankInterval? {
            if (new.size < 2 || old.size < 2) return null
            val outside = outside(new.size, old.size)
            if (outside == 0) return null
            val ratios = ratios(new, old)
            return RankInterval(ratios[outside - 1], ratios[ratios.size - outside])
        }

        /** Which ratio from either end bounds the interval; 0 for none. */
        private fun outside(m: Int, n: Int): Int {
            if (m * n.toLong() > MOST_EXACT) {
                val pairs = m.toDouble() * n
                return floor(pairs / 2 - ERROR_SIGMAS * sqrt(pairs * (m + n + 1) / 12)).toInt()
            }
            var sum = 0.0
            return chances(m, n).indexOfFirst { chance ->
                sum += chance
                sum > ERROR + ROUND_OFF
            }
        }

        /** The chance of each value of the statistic U, from 0 to m n, when both samples are of one kind. */
        private fun chances(m: Int, n: Int): DoubleArray {
            // By the size of the first sample; each pass makes the second one larger by one.
            val rows = Array(m + 1) { doubleArrayOf(1.0) }
            for (j in 1..n) {
                for (i in 1..m) {
                    val (fewer, same) = rows[i - 1] to rows[i]
                    // The largest of all is of the first sample, and above all j of the second; or of the second.
                    rows[i] = DoubleArray(i * j + 1) { u ->
                        val first = if (u >= j) fewer.getOrElse(u - j) { 0.0 } * i else 0.0
                        (first + same.getOrElse(u) { 0.0 } * j) / (i + j)
                    }
                }
            }
            return rows[m]
        }
    }
}
