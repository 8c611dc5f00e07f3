package daphnis.analysis.transport

import daphnis.analysis.table.NumberColumns
import java.nio.file.Path

/** The rows of a run's `transport.csv` as columns, in order of time. */
public class TransportTable private constructor(private val columns: Map<String, DoubleArray>) {
    /** Number of rows. */
    public val size: Int get() = columns.getValue("time").size

    /** Column [name] of the file. */
    public operator fun get(name: String): DoubleArray = columns.getValue(name)

    /** Whether the file has a column [name]. */
    public operator fun contains(name: String): Boolean = name in columns

    /** The rows from [time] on. */
    public fun from(time: Double): TransportTable {
        val first = this["time"].indexOfFirst { it >= time }.let { if (it < 0) size else it }
        return TransportTable(columns.mapValues { it.value.copyOfRange(first, size) })
    }

    public companion object {
        private val NEEDED =
            listOf("time", "particles", "mass", "c_xx", "c_yy", "c_zz", "c_xy", "scale_height", "collisions", "dissipated", "virial_xy")

        /**
         * Reads [path]; a last line that is cut short, as of a run that goes on, is left out.
         *
         * @throws daphnis.core.format.FormatException when it is no such file
         */
        public fun read(path: Path): TransportTable = TransportTable(NumberColumns.read(path, NEEDED))
    }
}
