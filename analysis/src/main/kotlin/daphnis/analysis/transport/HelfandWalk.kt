package daphnis.analysis.transport

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.run.TransportColumns
import daphnis.core.run.TransportColumns.COLLISIONS
import daphnis.core.run.TransportColumns.MASS
import daphnis.core.run.TransportColumns.PARTICLES
import daphnis.core.run.TransportColumns.TIME
import daphnis.core.table.Column
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.max
import kotlin.math.sqrt

/**
 * What Einstein's and Helfand's formulas have in common: evenly spaced rows of a [TransportTable] of a gas at rest, and
 * how fast an integral of a flux walks away over them.
 *
 * @property rows how many rows are even, from the first on
 * @property step from row to row
 * @param rate collisions of a particle in a unit of time
 * @property temperature ⟨c²⟩/3
 */
internal class HelfandWalk private constructor(
    private val table: TransportTable,
    val rows: Int,
    val step: Double,
    private val rate: Double,
    private val temperature: Double,
) {
    /** kT. */
    val thermal: Double get() = table[MASS][0] / table[PARTICLES][0] * temperature

    /** Length of time of all rows. */
    val duration: Double get() = step * (rows - 1)

    /** Σ of the [jumped] since the first row, and the integral of the [carried], by row. */
    fun integral(jumped: Column, carried: DoubleArray?): DoubleArray {
        val jumps = table[jumped]
        var sum = 0.0
        return DoubleArray(rows) {
            if (it > 0 && carried != null) sum += (carried[it] + carried[it - 1]) / 2 * step
            jumps[it] - jumps[0] + sum
        }
    }

    /**
     * Half of the lag in rows: of [freeTimes] mean free times, or the time in which a sphere of thermal speed crosses
     * [CROSSINGS] times its [diameter], if that is longer. Null where there are no rows enough.
     */
    fun half(freeTimes: Double, diameter: Double): Int? {
        val longest = max(freeTimes / rate, CROSSINGS * diameter / sqrt(temperature))
        return if (longest / step < rows) ceil(longest / step / 2).toInt() else null
    }

    /**
     * Slope of ⟨(G(t + s) − G(t))²⟩ between the lags [half] and twice that, on average over the [walks] and all t; null
     * where there are too few blocks of time.
     */
    fun slope(walks: List<DoubleArray>, half: Int): BlockAverage? {
        val origins = rows - 2 * half
        val blocks = origins / (2 * half)
        if (blocks < FEWEST_BLOCKS) return null
        val slopes = DoubleArray(blocks) { b ->
            val begin = (origins.toLong() * b / blocks).toInt()
            val end = (origins.toLong() * (b + 1) / blocks).toInt()
            (begin until end).sumOf { i -> walks.sumOf { rise(it, i, half) } } / (walks.size * (end - begin))
        }
        return BlockAverage.of(slopes) * (1 / (half * step))
    }

    /** The square over the lag 2[half] less the mean of those over its two halves. */
    private fun rise(g: DoubleArray, from: Int, half: Int): Double {
        val first = g[from + half] - g[from]
        val second = g[from + 2 * half] - g[from + half]
        return (first + second) * (first + second) - (first * first + second * second) / 2
    }

    companion object {
        /** Of a lag in times in which a sphere of thermal speed crosses its diameter. */
        private const val CROSSINGS = 2.0

        /** Most mean free times from row to row. */
        private const val WIDEST = 0.5
        private const val UNEVEN = 1e-6
        private const val FEWEST_BLOCKS = 2

        /** Of [table]; null where rows are too few, too far apart or not even, or without collisions. */
        fun of(table: TransportTable): HelfandWalk? {
            val rows = evenRows(table[TIME])
            if (rows < 2) return null
            val step = (table[TIME][rows - 1] - table[TIME][0]) / (rows - 1)
            val collisions = table[COLLISIONS][rows - 1] - table[COLLISIONS][0]
            val rate = 2 * collisions / table[PARTICLES][0] / (step * (rows - 1))
            val temperature = listOf("xx", "yy", "zz").sumOf { table[TransportColumns.moment(it)].average() } / 3
            val isUsable = rate > 0 && temperature > 0 && rate * step <= WIDEST
            return if (isUsable) HelfandWalk(table, rows, step, rate, temperature) else null
        }

        /** How many rows from the first on are as far apart as the first two, if these are all, or all but the last. */
        private fun evenRows(time: DoubleArray): Int {
            if (time.size < 2) return 0
            val step = time[1] - time[0]
            val uneven = (1 until time.size).firstOrNull { abs(time[it] - time[it - 1] - step) > UNEVEN * step }
            return if (uneven == null) {
                time.size
            } else if (uneven == time.size - 1) {
                uneven
            } else {
                0
            }
        }
    }
}
