package daphnis.analysis.occultation

import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.statistics.OfMeans
import kotlin.math.exp
import kotlin.math.pow

/**
 * Moments of the light in the footprints of light curves, one of each state in order of time, around the mean over all
 * of them, and how far they remember along the path. Light is in units of that without a patch.
 *
 * Each is a function of sums over the footprints. Its error is that of the jackknife pseudovalues over the states
 * ([BlockAverage]). Of fewer than [BlockAverage.FEWEST_NUMBERS] states it is that of the last one alone, over pieces of
 * several neighbouring tracks each, where that has as many tracks: an upper bound, as if all states were the same.
 *
 * @param lags of the autocorrelation in footprints, at most, and no more than half a track: beyond that a path through
 *   a periodic patch comes to where it began
 * @property unocculted mean number of photons per footprint where nothing is in the way; null for light without noise
 */
public class ScanStatistics @JvmOverloads constructor(
    private val lags: Int = LAGS,
    public val unocculted: Double? = null,
) {
    init {
        require(lags >= 0) { "$lags lags; it must be at least 0" }
    }

    /** Of each state. */
    private val states = ArrayList<DoubleArray>()

    /** Of pieces of the last state. */
    private var pieces: List<DoubleArray> = emptyList()

    /** About the mean: moments around it lose no digits. */
    private var centre = Double.NaN
    private var shortest = Int.MAX_VALUE

    /** Distance between footprints along the path, of the last state. */
    public var step: Double = Double.NaN
        private set

    /** Takes in the light curve of one more state. */
    public fun add(curve: LightCurve) {
        val tracks = curve.transmission
        if (centre.isNaN()) centre = tracks.sumOf { it.sum() } / curve.size
        step = curve.step
        shortest = minOf(shortest, tracks[0].size)
        val count = minOf(PIECES, tracks.size)
        pieces = List(count) { k ->
            val sums = DoubleArray(FIRST_LAG + 2 * lags)
            for (t in k * tracks.size / count until (k + 1) * tracks.size / count) add(tracks[t], sums)
            sums
        }
        states += DoubleArray(pieces[0].size) { k -> pieces.sumOf { it[k] } }
    }

    private fun add(track: DoubleArray, sums: DoubleArray) {
        sums[0] += track.size.toDouble()
        for (i in track.indices) {
            val d = track[i] - centre
            sums[1] += d
            sums[2] += d * d
            sums[3] += d * d * d
            sums[4] += d * d * d * d
        }
        for (lag in 1..minOf(lags, track.size - 1)) {
            var sum = 0.0
            for (i in 0 until track.size - lag) sum += (track[i] - centre) * (track[i + lag] - centre)
            sums[FIRST_LAG + 2 * (lag - 1)] += (track.size - lag).toDouble()
            sums[FIRST_LAG + 2 * (lag - 1) + 1] += sum
        }
    }

    /** States so far. */
    public val size: Int get() = states.size

    /** Lags that [autocorrelation] has, in footprints: 0 until this. */
    public val lagCount: Int get() = if (states.isEmpty()) 0 else minOf(lags, shortest / 2) + 1

    /** ⟨T⟩. */
    public fun mean(): BlockAverage = average { centre + it[1] / it[0] }

    /** Of the light as it is seen, noise of photons included. */
    public fun variance(): BlockAverage = average { variance(it) }

    /** The variance without that of the photons, which is the mean over [unocculted]. */
    public fun excessVariance(): BlockAverage = average { excess(it) }

    /** Third moment over the variance to the power 3/2, noise included; 0 for a Gaussian. NaN without a variance. */
    public fun skewness(): BlockAverage = average {
        val (m1, m2, m3) = listOf(it[1] / it[0], it[2] / it[0], it[3] / it[0])
        (m3 - 3 * m1 * m2 + 2 * m1 * m1 * m1) / variance(it).pow(1.5)
    }

    /** Excess kurtosis: fourth moment over the squared variance, less 3, noise included; 0 for a Gaussian. */
    public fun kurtosis(): BlockAverage = average {
        val m1 = it[1] / it[0]
        val fourth = it[4] / it[0] - 4 * m1 * it[3] / it[0] + 6 * m1 * m1 * it[2] / it[0] - 3 * m1 * m1 * m1 * m1
        fourth / (variance(it) * variance(it)) - 3
    }

    /**
     * Covariance of footprints [lag] places apart over the excess variance: 1 at lag 0. NaN at others where noise of
     * photons leaves no excess variance.
     */
    public fun autocorrelation(lag: Int): BlockAverage {
        require(lag in 0 until lagCount) { "lag is $lag; it must be in 0 until $lagCount" }
        return average { correlation(it, lag) }
    }

    /**
     * Distance along the path at which the autocorrelation falls to 1/e, on straight lines between footprints. Of
     * footprints longer than what lies in their way it is 1 − 1/e of their length. NaN where the longest lag is still
     * above.
     */
    public fun autocorrelationLength(): BlockAverage = average { sums ->
        var before = 1.0
        for (lag in 1 until lagCount) {
            val now = correlation(sums, lag)
            if (now <= FALLEN) return@average (lag - 1 + (before - FALLEN) / (before - now)) * step
            before = now
        }
        Double.NaN
    }

    private fun variance(sums: DoubleArray): Double {
        val mean = sums[1] / sums[0]
        return sums[2] / sums[0] - mean * mean
    }

    private fun excess(sums: DoubleArray) =
        variance(sums) - (unocculted?.let { (centre + sums[1] / sums[0]) / it } ?: 0.0)

    private fun correlation(sums: DoubleArray, lag: Int): Double {
        if (lag == 0) return 1.0
        val mean = sums[1] / sums[0]
        val at = FIRST_LAG + 2 * (lag - 1)
        val excess = excess(sums)
        return if (excess > 0) (sums[at + 1] / sums[at] - mean * mean) / excess else Double.NaN
    }

    private fun average(function: OfMeans): BlockAverage {
        if (states.isEmpty()) return BlockAverage(Double.NaN, Double.NaN, 0, 0.0)
        val ofStates = BlockAverage.of(columns(states), function)
        if (states.size >= BlockAverage.FEWEST_NUMBERS) return ofStates
        val ofPieces = BlockAverage.of(columns(pieces), function)
        return BlockAverage(ofStates.mean, ofPieces.error, ofPieces.count, ofPieces.independent)
    }

    private fun columns(rows: List<DoubleArray>) = Array(rows[0].size) { k -> DoubleArray(rows.size) { rows[it][k] } }

    private companion object {
        const val LAGS = 64

        /** Pieces of a state. */
        const val PIECES = 32

        /** Where the sums of lag 1 are: the number of its pairs, then their products; those of longer lags behind. */
        const val FIRST_LAG = 5
        val FALLEN = exp(-1.0)
    }
}
