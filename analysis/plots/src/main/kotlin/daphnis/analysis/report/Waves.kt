package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.wave.ModesTable
import daphnis.analysis.wave.WaveAmplitudes
import daphnis.analysis.wave.WaveAverages
import daphnis.analysis.wave.WaveGrowth
import daphnis.core.wave.ModeQuantity
import kotlin.math.PI

/**
 * What modes.csv tells of the waves of a ring.
 *
 * @property table of the run
 * @param from averages begin at this time
 * @param amplitudes of modes 1, 2, …
 */
internal class Waves private constructor(
    val table: ModesTable,
    private val from: Double,
    private val amplitudes: List<WaveAmplitudes>,
) {
    /** Numbers of the modes. */
    val modes: IntRange = 1..table.modes

    /** Number of whole periods, and their length. */
    val periods: Int = amplitudes[0].size
    val period: Double = amplitudes[0].period

    private val growths by lazy { amplitudes.map { WaveGrowth.of(it) } }

    fun amplitude(m: Int): WaveAmplitudes = amplitudes[m - 1]

    fun wavelength(m: Int): Double = 2 * PI / table.wavenumber(m)

    fun growth(m: Int): WaveGrowth? = growths[m - 1]

    fun frequency(m: Int): BlockAverage = WaveAverages.frequency(amplitude(m), from)

    fun direction(m: Int): BlockAverage = WaveAverages.direction(amplitude(m), from)

    /** Period of the strongest mode of the time averaged. */
    val wavePeriod: Double by lazy {
        frequency(strongest).mean.let { if (it > 0) 2 * PI / it else period }
    }

    /** The mode that grows last, of several to the end of the run the strongest there; null where none grows. */
    val growsLast: Int? by lazy {
        val growing = modes.filter { growth(it)?.isGrowing == true }
        growing.maxWithOrNull(compareBy({ growth(it)!!.last }, { amplitude(it).rmsSpeed(periods - 1) }))
    }

    /** The end of period [k]. */
    fun endOf(k: Int): Double = table.times.first() + period * (k + 1)

    /** Mean square over the box of mode [m] of [quantity], by row: half the square of its amplitude. */
    fun square(quantity: ModeQuantity, m: Int): DoubleArray {
        val re = table.real(quantity, m)
        val im = table.imaginary(quantity, m)
        return DoubleArray(re.size) { (re[it] * re[it] + im[it] * im[it]) / 2 }
    }

    /** Root mean square of mode [m] of [quantity] over the box and the time averaged. */
    fun rms(quantity: ModeQuantity, m: Int): BlockAverage {
        val first = table.times.indexOfFirst { it >= from }.let { if (it < 0) table.size else it }
        return BlockAverage.of(square(quantity, m).copyOfRange(first, table.size)).root()
    }

    /** The same from the time [begin] until [end], without an error; NaN without rows. */
    fun rms(quantity: ModeQuantity, m: Int, begin: Double, end: Double): Double {
        val square = square(quantity, m)
        val rows = table.times.indices.filter { table.times[it] >= begin && table.times[it] < end }
        return Math.sqrt(rows.sumOf { square[it] } / rows.size)
    }

    /** The strongest mode of the time averaged, by the waves' v_x. */
    val strongest: Int by lazy {
        val start = table.times.first()
        strongestOf((0 until periods).filter { start + period * it >= from }.ifEmpty { listOf(periods - 1) })
    }

    /** The strongest mode in period [k]. */
    fun strongest(k: Int): Int = modes.maxBy { amplitude(it).rmsSpeed(k) }

    /**
     * The strongest mode before all modes together come to a tenth of the most that they have, of those that grow where
     * there are any: noise may be stronger in others.
     */
    val first: Int by lazy {
        val power = DoubleArray(periods) { k -> modes.sumOf { m -> amplitude(m).rmsSpeed(k).let { it * it } } }
        val end = maxOf(1, power.indexOfFirst { it > power.max() * EARLY })
        strongestOf((0 until end).toList(), modes.filter { growth(it)?.isGrowing == true }.ifEmpty { modes })
    }

    private fun strongestOf(all: List<Int>, among: Iterable<Int> = modes) = among.maxBy { m ->
        all.sumOf { k -> amplitude(m).rmsSpeed(k).let { it * it } }
    }

    companion object {
        private const val EARLY = 0.1

        /** Of [input], with averages that begin at [from]; null where it tells of no waves. */
        fun of(input: AnalysisInput, from: Double): Waves? {
            val table = input.modes ?: return null
            val frequencies = input.frequencies ?: return null
            val all = (1..table.modes).map { WaveAmplitudes.of(table, it, frequencies) ?: return null }
            return Waves(table, from, all)
        }
    }
}
