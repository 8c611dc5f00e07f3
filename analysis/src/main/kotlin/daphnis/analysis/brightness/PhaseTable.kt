package daphnis.analysis.brightness

import daphnis.analysis.table.CheckedColumns
import daphnis.core.format.FormatException
import java.nio.file.Path
import kotlin.math.PI

/**
 * A function of the phase angle in a table, on straight lines between its rows.
 *
 * @param angles phase angles in radians, ascending, in 0..π
 * @param values of the function there, at least 0
 */
public class PhaseTable(angles: DoubleArray, values: DoubleArray) {
    private val angles = angles.copyOf()
    private val values = values.copyOf()

    init {
        require(angles.size == values.size && angles.size >= 2) {
            "${angles.size} phase angles and ${values.size} values; there must be two or more, equally many"
        }
        for (k in angles.indices) {
            require(angles[k] >= 0 && angles[k] <= PI) { "phase angle is ${angles[k]}; it must be in [0, π]" }
            require(k == 0 || angles[k] > angles[k - 1]) {
                "phase angle ${angles[k]} follows ${angles[k - 1]}; they must be ascending"
            }
            require(values[k] >= 0 && values[k] <= MOST) { "value is ${values[k]}; it must be in [0, $MOST]" }
        }
    }

    /** The smallest angle in the table in radians; [last] the largest. */
    public val first: Double get() = angles.first()
    public val last: Double get() = angles.last()

    /** The function at [angle] in radians; beyond the table what it has at its end. */
    public fun at(angle: Double): Double {
        if (angle <= first) return values.first()
        if (angle >= last) return values.last()
        var low = 0
        var high = angles.lastIndex
        while (high - low > 1) {
            val middle = (low + high) ushr 1
            if (angles[middle] <= angle) low = middle else high = middle
        }
        val part = (angle - angles[low]) / (angles[high] - angles[low])
        return values[low] + part * (values[high] - values[low])
    }

    /** Whether [angle] in radians is in the table, but for rounding. */
    public fun covers(angle: Double): Boolean = angle >= first - ROUNDING && angle <= last + ROUNDING

    public companion object {
        /** Rows of a table, at most. */
        public const val MOST_ROWS: Int = 10_000
        private const val MOST = 1e6
        private const val ROUNDING = 1e-9
        private const val ANGLE = "phase_angle"
        private const val VALUE = "phase_function"

        /**
         * Reads a CSV file with the columns `phase_angle` in degrees, ascending, and `phase_function`; for the rest it
         * is like a table of [daphnis.analysis.occultation.ObservedDepths].
         *
         * @throws FormatException naming file and line when it cannot be read, a column is missing, an angle is not in
         * 0..180 degrees or not above the one before, a value is below 0, or there are too few rows or too many
         */
        @JvmStatic
        public fun read(path: Path): PhaseTable {
            val columns = CheckedColumns.read(path, angles = listOf(ANGLE), numbers = listOf(VALUE), MOST_ROWS)
            if (columns.size < 2) throw FormatException("$path: has one row; it must have two at least")
            var before = -1.0
            val angles = DoubleArray(columns.size) { row ->
                columns.number(row, ANGLE, "in 0..180 degrees") { it in 0.0..180.0 }
                columns.number(row, ANGLE, "more than that of the row before, $before") { it > before }
                    .also { before = it }
            }
            val values = DoubleArray(columns.size) { row ->
                columns.number(row, VALUE, "a number in 0..$MOST") { it in 0.0..MOST }
            }
            return PhaseTable(DoubleArray(angles.size) { Math.toRadians(angles[it]) }, values)
        }
    }
}
