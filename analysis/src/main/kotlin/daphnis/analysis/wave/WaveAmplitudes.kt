package daphnis.analysis.wave

import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.wave.ModeQuantity
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * A mode of a ring as two waves, one that goes outward and one that goes inward, by epicyclic periods.
 *
 * Epicycles turn the vector (v_x, (2Ω/κ) v_y) clockwise, so v_x + i (2Ω/κ) v_y of a wave exp(±ikx) turns as exp(−iωt)
 * with ω near κ. Hence (v_x,m + i (2Ω/κ) v_y,m)/2 is the wave that goes outward, and the conjugate of
 * (v_x,m − i (2Ω/κ) v_y,m)/2 the one that goes inward, at every instant, for travelling and for standing waves. Both
 * are multiplied by exp(iκt) and averaged over each period. So what does not oscillate with a frequency near κ, as most
 * of the noise of the particles' own motion, falls out, and nearly all of the harmonics of a steep wave, near 2 κ. A
 * wave whose frequency is 1.2 κ loses 6 % of its amplitude.
 *
 * @property start time at which the first period begins
 * @property period 2π/κ
 * @property kappa κ
 */
public class WaveAmplitudes private constructor(
    public val start: Double,
    public val period: Double,
    public val kappa: Double,
    private val outward: Array<DoubleArray>,
    private val inward: Array<DoubleArray>,
    private val squares: DoubleArray,
    private val powers: DoubleArray,
) {
    /** Number of periods. */
    public val size: Int get() = outward[0].size

    /** The middle of period [k]. */
    public fun time(k: Int): Double = start + (k + 0.5) * period

    /** Mean square of v_x in the wave that goes outward, in period [k]; of what is coherent with exp(−iκt). */
    public fun outward(k: Int): Double = square(outward, k)

    /** Mean square of v_x in the wave that goes inward, in period [k]; of what is coherent with exp(−iκt). */
    public fun inward(k: Int): Double = square(inward, k)

    /** Root mean square over the box and period [k] of that part of v_x which is coherent with exp(−iκt). */
    public fun coherentSpeed(k: Int): Double = sqrt(outward(k) + inward(k))

    /** Root mean square of v_x over the box and period [k], with all that the mode has. */
    public fun rmsSpeed(k: Int): Double = sqrt(squares[k])

    /** Part of the power of both velocities in the given [periods] that is coherent with exp(−iκt), from 0 to 1. */
    public fun coherence(periods: Iterable<Int>): Double =
        periods.sumOf { outward(it) + inward(it) } / periods.sumOf { powers[it] }

    /** Amplitudes of both waves, outward and inward, in the periods [first] to [last]: real and imaginary parts. */
    internal fun amplitudes(first: Int, last: Int): List<Array<DoubleArray>> = listOf(outward, inward).map { wave ->
        Array(2) { wave[it].copyOfRange(first, last + 1) }
    }

    /**
     * Real and imaginary part of Σ b* b' over both waves, b and b' the amplitudes of period [k] and of the next: its
     * argument is the angle by which they turn against exp(−iκt).
     */
    internal fun turn(k: Int): DoubleArray {
        val sum = DoubleArray(2)
        for (wave in listOf(outward, inward)) {
            sum[0] += wave[0][k] * wave[0][k + 1] + wave[1][k] * wave[1][k + 1]
            sum[1] += wave[0][k] * wave[1][k + 1] - wave[1][k] * wave[0][k + 1]
        }
        return sum
    }

    /** Phase of both waves against exp(−iκt), in radians, continued from period to period; 0 at the first. */
    internal fun phases(): DoubleArray {
        val phases = DoubleArray(size)
        for (k in 1 until size) phases[k] = phases[k - 1] + turn(k - 1).let { atan2(it[1], it[0]) }
        return phases
    }

    public companion object {
        /** Rows in a period below which nothing is said. */
        public const val FEWEST_ROWS: Int = 4

        /** Coherence below which a mode is no epicyclic wave: it has no frequency, no direction and no growth. */
        public const val LEAST_COHERENCE: Double = 0.5

        /**
         * Of mode [m] of [table] in a ring of [frequencies], by whole periods from the first row on; null where there
         * is none, or one with fewer than [FEWEST_ROWS] rows.
         */
        @JvmStatic
        public fun of(table: ModesTable, m: Int, frequencies: OrbitalFrequencies): WaveAmplitudes? {
            val x = table.real(ModeQuantity.VELOCITY_X, m) to table.imaginary(ModeQuantity.VELOCITY_X, m)
            val y = table.real(ModeQuantity.VELOCITY_Y, m) to table.imaginary(ModeQuantity.VELOCITY_Y, m)
            return of(table.times, x, y, frequencies)
        }

        /** The same of real and imaginary parts of the modes [x] and [y] of both velocities at [times]. */
        internal fun of(
            times: DoubleArray,
            x: Pair<DoubleArray, DoubleArray>,
            y: Pair<DoubleArray, DoubleArray>,
            frequencies: OrbitalFrequencies,
        ): WaveAmplitudes? {
            val kappa = frequencies.kappa
            val period = 2 * PI / kappa
            if (times.size < FEWEST_ROWS) return null
            val periods = floor((times.last() - times.first()) / period * (1 + ROUNDING)).toInt()
            if (periods < 1) return null
            val outward = Array(2) { DoubleArray(periods) }
            val inward = Array(2) { DoubleArray(periods) }
            val squares = DoubleArray(periods)
            val powers = DoubleArray(periods)
            val count = IntArray(periods)
            val factor = 2 * frequencies.omega / kappa
            for (row in times.indices) {
                val k = floor((times[row] - times.first()) / period * (1 + ROUNDING)).toInt()
                if (k >= periods) break
                count[k]++
                val c = cos(kappa * times[row]) / 2
                val s = sin(kappa * times[row]) / 2
                val square = x.first[row] * x.first[row] + x.second[row] * x.second[row]
                val along = y.first[row] * y.first[row] + y.second[row] * y.second[row]
                squares[k] += square / 2
                powers[k] += (square + factor * factor * along) / 4
                // v_x + i f v_y, and the conjugate of v_x − i f v_y.
                add(outward, k, x.first[row] - factor * y.second[row], x.second[row] + factor * y.first[row], c, s)
                add(inward, k, x.first[row] + factor * y.second[row], factor * y.first[row] - x.second[row], c, s)
            }
            if (count.any { it < FEWEST_ROWS }) return null
            for (part in listOf(*outward, *inward, squares, powers)) {
                for (k in part.indices) part[k] /= count[k].toDouble()
            }
            return WaveAmplitudes(times.first(), period, kappa, outward, inward, squares, powers)
        }

        /** Of the amplitudes of [waves] by period, as [amplitudes] gives them, with nothing that is not coherent. */
        internal fun of(waves: List<Array<DoubleArray>>, frequencies: OrbitalFrequencies): WaveAmplitudes {
            val (outward, inward) = waves
            val squares = DoubleArray(outward[0].size) { square(outward, it) + square(inward, it) }
            val period = 2 * PI / frequencies.kappa
            return WaveAmplitudes(0.0, period, frequencies.kappa, outward, inward, squares, squares)
        }

        private fun square(wave: Array<DoubleArray>, k: Int) = (wave[0][k] * wave[0][k] + wave[1][k] * wave[1][k]) / 2

        private fun add(to: Array<DoubleArray>, k: Int, re: Double, im: Double, c: Double, s: Double) {
            to[0][k] += re * c - im * s
            to[1][k] += re * s + im * c
        }

        /** A row at the end of a period may fall short of it by this. */
        private const val ROUNDING = 1e-9
    }
}
