package daphnis.analysis.correlation

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.sqrt

/**
 * How many independent states a series of maps is worth. The correlation between states some places apart is measured
 * on all lags of their autocorrelations together, the centre left out. So it is known much better than from the one
 * number of each state whose error is wanted. It is summed up to five times the correlation time (Wolff 2004, Comput.
 * Phys. Commun. 156, 143), and freed of the bias that the measured mean brings.
 */
internal class IndependentStates(maps: List<DoubleArray>) {
    private val states = maps.size

    /** States over their integrated autocorrelation time; at most their number, NaN for fewer than two. */
    val number: Double = if (states < 2) Double.NaN else number(maps)

    private fun number(maps: List<DoubleArray>): Double {
        val centre = maps[0].size / 2
        val mean = DoubleArray(maps[0].size) { l -> maps.sumOf { it[l] } / states }
        val covariance = DoubleArray(states)
        for (apart in 0 until states) {
            var sum = 0.0
            for (k in 0 until states - apart) {
                val (a, b) = maps[k] to maps[k + apart]
                for (l in mean.indices) if (l != centre) sum += (a[l] - mean[l]) * (b[l] - mean[l])
            }
            covariance[apart] = sum / (states - apart)
        }
        if (!(covariance[0] > 0)) return states.toDouble()
        return states / integrated(covariance)
    }

    /** 1 + 2 Σ ρ over a window that is five times as long; at least 1. */
    private fun integrated(covariance: DoubleArray): Double {
        var time = 1.0
        // The measured mean takes a share time/n of the variance from every covariance: found by iteration.
        repeat(ITERATIONS) {
            val share = covariance[0] * minOf(time / states, MOST_SHARE)
            val variance = covariance[0] + share
            var sum = 1.0
            var apart = 1
            while (apart < states / 2 && apart <= WINDOW * sum) {
                val correlation = (covariance[apart] + share) / variance
                if (correlation <= 0) break
                sum += 2 * correlation * (1 - apart.toDouble() / states)
                apart++
            }
            time = sum
        }
        return time
    }

    /**
     * [mean] with the error of the average of the jackknife [pseudovalues], one of each state; without one for fewer
     * than sixteen states, or when they are worth fewer than eight. The numbers may be slower than the maps, most of
     * which is noise: then the states are worth what the numbers themselves show.
     */
    fun average(mean: Double, pseudovalues: DoubleArray): BlockAverage {
        val centre = pseudovalues.average()
        val variance = pseudovalues.sumOf { (it - centre) * (it - centre) } / states
        val isKnown = states >= BlockAverage.FEWEST_NUMBERS && number >= BlockAverage.FEWEST_INDEPENDENT
        if (!isKnown) return BlockAverage(mean, Double.NaN, states, number)
        val own = worth(BlockAverage.of(pseudovalues), variance)
        // Only where it is clear: what one series shows is known to two fifths, and the lower of two is low on average.
        val worth = if (own < number / CLEARLY) own else number
        return BlockAverage(mean, sqrt(variance / (worth - 1)), states, worth)
    }

    /**
     * How many numbers of the [variance] have the error of [series]: what is slow in them counts by its part of the
     * variance, not by its correlation time alone.
     */
    private fun worth(series: BlockAverage, variance: Double): Double = when {
        !series.isLevelled -> BlockAverage.FEWEST_INDEPENDENT
        series.error == 0.0 -> number
        else -> variance / (series.error * series.error) + 1
    }

    private companion object {
        const val WINDOW = 2.5
        const val CLEARLY = 2.0
        const val ITERATIONS = 4
        const val MOST_SHARE = 0.5
    }
}
