package daphnis.analysis.series

import daphnis.analysis.table.NumberColumns
import java.nio.file.Path

/**
 * The rows of a run's time series, `series.csv`, as columns, in order of time. Columns are known by name; a file may
 * have more than were known here.
 */
public class SeriesTable private constructor(private val columns: Map<String, DoubleArray>) {
    /** Number of rows. */
    public val size: Int get() = columns.getValue("time").size

    /** Names of the columns, in the file's order. */
    public val names: Set<String> get() = columns.keys

    /**
     * Column [name] of the file, in its units; NaN for an empty cell.
     *
     * @throws NoSuchElementException when there is none
     */
    public operator fun get(name: String): DoubleArray = columns.getValue(name)

    public operator fun contains(name: String): Boolean = name in columns

    public companion object {
        private val NEEDED = listOf("time", "particles", "collisions")

        /**
         * Reads [path]. A last line that is cut short, as of a run that goes on, is left out.
         *
         * @throws daphnis.core.format.FormatException when it is no such file or damaged; the message names file and
         * line
         */
        public fun read(path: Path): SeriesTable = SeriesTable(NumberColumns.read(path, NEEDED))
    }
}
