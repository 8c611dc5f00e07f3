package daphnis.analysis.wave

import daphnis.analysis.statistics.BlockAverage
import kotlin.math.atan2
import kotlin.math.ln

/**
 * How fast a mode grows, and with what frequency, from its amplitudes by period ([WaveAmplitudes]).
 *
 * The time of growth ends when the amplitude has come to [TOP] of the largest, the median of five periods taken, or
 * with the run where it has not stopped to grow. It begins when it was last at [FLOOR] times its least before that.
 * Over that time both waves are fitted by growth which the motion of particles drives and which comes to an end as in
 * Landau's equation ([DrivenWaves]), without that end where the run ends before it and it is not told. So the rate s is
 * that of small amplitudes, although the fit needs no time without saturation. Where there is no growth over [FEWEST]
 * periods by a factor of e or more, and by three errors, a straight line is fitted to ln A over all periods, with the
 * noise of [LevelNoise]. That factor counts from period [SETTLING] on, since a run that starts evenly spread fills with
 * noise first, and the mode must be coherent with epicycles ([WaveAmplitudes.LEAST_COHERENCE]): harmonics of a wave are
 * not.
 *
 * @property rate s, per unit of time
 * @property rateError one standard error; NaN for too few periods
 * @property frequency in radians per unit of time, over the same periods: what [DrivenWaves] turn by
 * @property frequencyError one standard error; both are NaN for a mode that is not coherent
 * @property isGrowing whether growth was found
 * @property first period with which the time fitted begins, [last] with which it ends
 */
public class WaveGrowth private constructor(
    public val rate: Double,
    public val rateError: Double,
    public val frequency: Double,
    public val frequencyError: Double,
    public val isGrowing: Boolean,
    public val first: Int,
    public val last: Int,
) {
    public companion object {
        /** Periods below which nothing is fitted. */
        public const val FEWEST: Int = 8

        /** Periods in which noise fills a run that starts evenly spread. */
        private const val SETTLING = 4
        private const val TOP = 0.7
        private const val FLOOR = 1.5
        private const val SIGNIFICANT = 3.0
        private const val HALF_WIDTH = 2

        /** Of [waves]; null for fewer than [FEWEST] periods, or amplitudes that are 0. */
        @JvmStatic
        public fun of(waves: WaveAmplitudes): WaveGrowth? {
            val n = waves.size
            if (n < FEWEST) return null
            val logarithms = DoubleArray(n) { ln(waves.coherentSpeed(it)) }
            if (logarithms.any { !it.isFinite() }) return null
            val (first, last) = window(logarithms)
            if (last - first + 1 >= FEWEST && gain(logarithms, first, last) >= 1 && isCoherent(waves, first, last)) {
                val found = grown(waves, logarithms, first, last)
                if (found != null) return made(waves, found.rate, found.rateError, true, first, last, found)
            }
            val (rate, error) = line(logarithms) ?: return null
            val turning = if (isCoherent(waves, 0, n - 1)) driven(waves, 0, n - 1, false, 0.0) else null
            return made(waves, rate, error, false, 0, n - 1, turning)
        }

        /** Growth beyond doubt; where it is not over, nothing tells how it will end. */
        private fun grown(waves: WaveAmplitudes, logarithms: DoubleArray, first: Int, last: Int): DrivenWaves.Found? {
            val half = maxOf(FEWEST / 2, (last - first + 1) / 2)
            val slope = (logarithms[first + half - 1] - logarithms[first]) / (half - 1)
            val isOver = last < logarithms.lastIndex
            return sequenceOf(true, false).filter { it || !isOver }.mapNotNull { driven(waves, first, last, it, slope) }
                .firstOrNull { it.rate > SIGNIFICANT * it.rateError }
        }

        private fun driven(waves: WaveAmplitudes, first: Int, last: Int, ends: Boolean, slope: Double) = waves.phases()
            .let { (it[last] - it[first]) / (last - first) }
            .let { DrivenWaves(waves.amplitudes(first, last)).fit(ends, slope, it) }

        private fun made(
            waves: WaveAmplitudes,
            rate: Double,
            error: Double,
            isGrowing: Boolean,
            first: Int,
            last: Int,
            found: DrivenWaves.Found?,
        ) = WaveGrowth(
            rate / waves.period,
            error / waves.period,
            waves.kappa - (found?.turning ?: Double.NaN) / waves.period,
            (found?.turningError ?: Double.NaN) / waves.period,
            isGrowing,
            first,
            last,
        )

        private fun isCoherent(waves: WaveAmplitudes, first: Int, last: Int) =
            waves.coherence(first..last) >= WaveAmplitudes.LEAST_COHERENCE

        /** By how much the logarithm rises in the time of growth, above the noise that a run fills with at first. */
        private fun gain(logarithms: DoubleArray, first: Int, last: Int): Double {
            val filled = if (first < SETTLING) smooth(logarithms)[SETTLING] else Double.NEGATIVE_INFINITY
            return logarithms[last] - maxOf(logarithms[first], filled)
        }

        /** Medians of five periods, of fewer at the ends. */
        private fun smooth(logarithms: DoubleArray) = DoubleArray(logarithms.size) {
            val from = maxOf(0, it - HALF_WIDTH)
            val to = minOf(logarithms.size, it + HALF_WIDTH + 1)
            logarithms.copyOfRange(from, to).also { part -> part.sort() }[(to - from) / 2]
        }

        /** First and last period of the time of growth. */
        private fun window(logarithms: DoubleArray): Pair<Int, Int> {
            val smooth = smooth(logarithms)
            val most = smooth.max()
            val reached = smooth.indexOfFirst { it > most + ln(TOP) }
            val summit = smooth.indexOfFirst { it == most }
            val isOver = reached < smooth.size - FEWEST || summit < smooth.size - 2 * HALF_WIDTH
            val last = if (isOver) reached else smooth.lastIndex
            val floor = (0..last).minOf { smooth[it] } + ln(FLOOR)
            return (0..last).last { it == 0 || smooth[it] <= floor } to last
        }

        /** Slope of a line through [y], per number, and its standard error; the noise may fall as amplitudes grow. */
        private fun line(y: DoubleArray): Pair<Double, Double>? {
            val middle = (y.size - 1) / 2.0
            val columns = listOf(DoubleArray(y.size) { 1.0 }, DoubleArray(y.size) { it - middle })
            return LevelNoise.likeliest(y) { it.step(y, columns) }?.let { it.parameters[1] to it.errors[1] }
        }
    }
}

/** Frequency and direction of a mode over a time in which it neither grows nor falls. */
public object WaveAverages {
    /**
     * Mean frequency over the periods of [waves] from the time [from] on, in radians per unit of time: the angle by
     * which the amplitudes turn from period to period, weighted by their squares. Frequencies are told apart within
     * κ/2 of κ. Mean NaN where less than [WaveAmplitudes.LEAST_COHERENCE] of the power is coherent, as of harmonics.
     */
    @JvmStatic
    public fun frequency(waves: WaveAmplitudes, from: Double): BlockAverage {
        if (!isCoherent(waves, from)) return NONE
        val turns = (0 until waves.size - 1).filter { waves.start + it * waves.period >= from }.map { waves.turn(it) }
        val columns = Array(2) { part -> DoubleArray(turns.size) { turns[it][part] } }
        return BlockAverage.of(columns) { waves.kappa - atan2(it[1], it[0]) / waves.period }
    }

    /**
     * (A² outward − A² inward)/(A² outward + A² inward): 1 for waves that go outward, 0 for standing ones. Mean NaN
     * where [frequency] has none.
     */
    @JvmStatic
    public fun direction(waves: WaveAmplitudes, from: Double): BlockAverage {
        if (!isCoherent(waves, from)) return NONE
        val periods = averaged(waves, from)
        val columns = arrayOf(
            DoubleArray(periods.size) { waves.outward(periods[it]) },
            DoubleArray(periods.size) { waves.inward(periods[it]) },
        )
        return BlockAverage.of(columns) { (it[0] - it[1]) / (it[0] + it[1]) }
    }

    private val NONE = BlockAverage(Double.NaN, Double.NaN, 0)

    private fun averaged(waves: WaveAmplitudes, from: Double) =
        (0 until waves.size).filter { waves.start + it * waves.period >= from }

    private fun isCoherent(waves: WaveAmplitudes, from: Double) =
        waves.coherence(averaged(waves, from)) >= WaveAmplitudes.LEAST_COHERENCE
}
