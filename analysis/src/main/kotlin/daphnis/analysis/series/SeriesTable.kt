package daphnis.analysis.series

import daphnis.analysis.table.NumberColumns
import daphnis.core.run.SeriesColumns
import daphnis.core.table.Column
import java.nio.file.Path

/**
 * The rows of a run's time series, `series.csv`, as columns, in order of time: those of [SeriesColumns], and by name
 * whatever else the file has.
 */
public class SeriesTable private constructor(private val columns: Map<String, DoubleArray>) {
    /** Number of rows. */
    public val size: Int get() = this[SeriesColumns.TIME].size

    /** Names of the columns, in the file's order. */
    public val names: Set<String> get() = columns.keys

    /**
     * Column [name] of the file, in its units; NaN for an empty cell.
     *
     * @throws NoSuchElementException when there is none
     */
    public operator fun get(name: String): DoubleArray = columns.getValue(name)

    public operator fun contains(name: String): Boolean = name in columns

    /** The numbers of [column], in the run's units; NaN for an empty cell. @throws NoSuchElementException without it */
    public operator fun get(column: Column): DoubleArray = this[column.name]

    /** Whether the file has [column]; an older one may lack it. */
    public operator fun contains(column: Column): Boolean = column.name in columns

    public companion object {
        /**
         * Reads [path]. A last line that is cut short, as of a run that goes on, is left out.
         *
         * @throws daphnis.core.format.FormatException when it is no such file or damaged; the message names file and
         * line
         */
        @JvmStatic
        public fun read(path: Path): SeriesTable = SeriesTable(NumberColumns.read(path, SeriesColumns))
    }
}
