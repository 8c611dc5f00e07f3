package daphnis.analysis.transport

import daphnis.analysis.table.NumberColumns
import daphnis.core.run.TransportColumns
import daphnis.core.table.Column
import java.nio.file.Path

/** The rows of a run's `transport.csv` as columns, in order of time. */
public class TransportTable private constructor(private val columns: Map<String, DoubleArray>) {
    /** Number of rows. */
    public val size: Int get() = this[TransportColumns.TIME].size

    /** The numbers of [column], in the run's units. @throws NoSuchElementException when the file lacks it */
    public operator fun get(column: Column): DoubleArray = columns.getValue(column.name)

    /** Whether the file has [column]; an older one may lack it. */
    public operator fun contains(column: Column): Boolean = column.name in columns

    /** The rows from [time] on. */
    public fun from(time: Double): TransportTable {
        val first = this[TransportColumns.TIME].indexOfFirst { it >= time }.let { if (it < 0) size else it }
        return TransportTable(columns.mapValues { it.value.copyOfRange(first, size) })
    }

    /** The rows up to [time]. */
    public fun until(time: Double): TransportTable {
        val end = this[TransportColumns.TIME].count { it <= time }
        return TransportTable(columns.mapValues { it.value.copyOfRange(0, end) })
    }

    public companion object {
        /**
         * Reads [path]; a last line that is cut short, as of a run that goes on, is left out.
         *
         * @throws daphnis.core.format.FormatException when it is no such file
         */
        @JvmStatic
        public fun read(path: Path): TransportTable = TransportTable(NumberColumns.read(path, TransportColumns))
    }
}
