package daphnis.analysis.wave

import daphnis.analysis.table.NumberColumns
import daphnis.core.format.FormatException
import daphnis.core.run.ModeColumns
import daphnis.core.table.Column
import daphnis.core.wave.ModeQuantity
import java.nio.file.Path

/**
 * A run's `modes.csv` by mode: each number as a series in time. What the modes are is said by
 * [daphnis.core.wave.ModeSums].
 *
 * @property modes number of modes beside mode 0
 * @property times of the states, ascending, in the run's units
 */
public class ModesTable private constructor(
    public val modes: Int,
    public val times: DoubleArray,
    private val columns: Map<String, DoubleArray>,
) {
    /** Number of states. */
    public val size: Int get() = times.size

    /** k_m, per unit of length. */
    public fun wavenumber(m: Int): Double = columns.getValue(ModeColumns.WAVENUMBER.name)[m]

    /** Real part of mode [m] of [quantity], by state; of mode 0 the mean. */
    public fun real(quantity: ModeQuantity, m: Int): DoubleArray = series(ModeColumns.real(quantity), m)

    /** Imaginary part of mode [m] of [quantity], by state. */
    public fun imaginary(quantity: ModeQuantity, m: Int): DoubleArray = series(ModeColumns.imaginary(quantity), m)

    private fun series(column: Column, m: Int): DoubleArray {
        require(m in 0..modes) { "mode $m; there are $modes" }
        val all = columns.getValue(column.name)
        return DoubleArray(size) { all[it * (modes + 1) + m] }
    }

    public companion object {
        /**
         * Reads [path]. A last state that is cut short, as of a run that goes on, is left out. There may be none.
         *
         * @throws FormatException when it is no such file; the message names file and line
         */
        @JvmStatic
        public fun read(path: Path): ModesTable {
            val columns = NumberColumns.read(path, ModeColumns)
            val mode = columns.getValue(ModeColumns.MODE.name)
            val time = columns.getValue(ModeColumns.TIME.name)
            val second = (1 until mode.size).firstOrNull { mode[it] == 0.0 } ?: mode.size
            val width = maxOf(2, second)
            for (k in mode.indices) {
                val isRight = mode[k] == (k % width).toDouble() && time[k] == time[k - k % width]
                if (!isRight) {
                    val expected = "mode ${k % width} of one state"
                    throw FormatException("$path:${k + 2}: is of mode ${mode[k]}; it must be of $expected")
                }
            }
            val states = mode.size / width
            return ModesTable(width - 1, DoubleArray(states) { time[it * width] }, columns)
        }
    }
}
