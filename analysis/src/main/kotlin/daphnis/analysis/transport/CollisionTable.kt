package daphnis.analysis.transport

import daphnis.analysis.table.NumberColumns
import daphnis.core.run.CollisionColumns
import daphnis.core.table.Column
import java.nio.file.Path

/**
 * The rows of a run's `collisions.csv` as columns, in order of time: one row per collision of two spheres, in the run's
 * units. Steps and ids are whole numbers. All rows are in memory, eight bytes a number.
 */
public class CollisionTable private constructor(private val columns: Map<String, DoubleArray>) {
    /** Number of rows. */
    public val size: Int get() = this[CollisionColumns.STEP].size

    /** Whether it is of rough spheres, and has tangential impulses and what surfaces dissipate. */
    public val isRough: Boolean get() = CollisionColumns.TANGENTIAL_IMPULSE[0] in this

    /** The numbers of [column]. @throws NoSuchElementException when the file lacks it */
    public operator fun get(column: Column): DoubleArray = columns.getValue(column.name)

    /** Whether the file has [column]; that of smooth spheres, or an older one, may lack it. */
    public operator fun contains(column: Column): Boolean = column.name in columns

    public companion object {
        /**
         * Reads [path]; a last line that is cut short, as of a run that goes on, is left out.
         *
         * @throws daphnis.core.format.FormatException when it is no such file or damaged; the message names file and
         * line
         */
        @JvmStatic
        public fun read(path: Path): CollisionTable =
            CollisionTable(NumberColumns.read(path, CollisionColumns, CollisionColumns.STEP.name))
    }
}
