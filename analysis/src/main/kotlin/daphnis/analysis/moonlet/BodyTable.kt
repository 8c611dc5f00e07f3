package daphnis.analysis.moonlet

import daphnis.analysis.table.NumberColumns
import daphnis.core.hill.Epicycle
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.run.BodyColumns
import daphnis.core.table.Column
import java.nio.file.Path

/**
 * The rows of one body in a run's `bodies.csv`, in order of time.
 *
 * @property id of the body
 */
public class BodyTable private constructor(public val id: Int, private val columns: Map<String, DoubleArray>) {
    /** Number of rows. */
    public val size: Int get() = this[BodyColumns.TIME].size

    /** The numbers of [column], in the run's units. @throws NoSuchElementException when the file lacks it */
    public operator fun get(column: Column): DoubleArray = columns.getValue(column.name)

    /** The rows from [time] on. What pushed the body before the first of them is not in them. */
    public fun from(time: Double): BodyTable {
        val first = this[BodyColumns.TIME].indexOfFirst { it >= time }.let { if (it < 0) size else it }
        return BodyTable(id, columns.mapValues { it.value.copyOfRange(first, size) })
    }

    /** Its epicycle at [time], as of the last row until then, among these [orbits]; null before the first row. */
    public fun orbit(time: Double, orbits: OrbitalFrequencies): Epicycle? {
        val row = this[BodyColumns.TIME].indexOfLast { it <= time }
        if (row < 0) return null
        fun of(column: Column) = this[column][row]
        return Epicycle(
            of(BodyColumns.GUIDING_X),
            of(BodyColumns.GUIDING_Y),
            of(BodyColumns.ECCENTRICITY),
            of(BodyColumns.PHASE),
            of(BodyColumns.INCLINATION),
            of(BodyColumns.VERTICAL_PHASE),
        ).after(time - of(BodyColumns.TIME), orbits)
    }

    /**
     * Mean force along the orbit between one row and the next, of pushes in [column]: one number less than there are
     * rows, and NaN between rows of one time. Mass · length/time².
     */
    public fun force(column: Column): DoubleArray {
        val time = this[BodyColumns.TIME]
        val push = this[column]
        return DoubleArray(maxOf(0, size - 1)) {
            val between = time[it + 1] - time[it]
            if (between > 0) push[it + 1] / between else Double.NaN
        }
    }

    public companion object {
        /**
         * Reads [path]: a table for each body, in the order of ids. A last line that is cut short, as of a run that
         * goes on, is left out.
         *
         * @throws daphnis.core.format.FormatException when it is no such file
         */
        @JvmStatic
        public fun read(path: Path): List<BodyTable> {
            val all = NumberColumns.read(path, BodyColumns)
            val ids = all.getValue(BodyColumns.BODY.name)
            return ids.distinct().sorted().map { id ->
                val own = ids.indices.filter { ids[it] == id }
                BodyTable(id.toInt(), all.mapValues { (_, column) -> DoubleArray(own.size) { column[own[it]] } })
            }
        }
    }
}
