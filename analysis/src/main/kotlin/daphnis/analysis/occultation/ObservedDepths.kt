package daphnis.analysis.occultation

import daphnis.analysis.table.CheckedColumns
import daphnis.core.format.FormatException
import java.nio.file.Path

/**
 * What was observed of a ring along several [lines] of sight: normal optical depths, or transmissions.
 *
 * @property values by line, each with its standard error in [errors]
 * @property remarks a sentence for each transmission below 0 or above 1, which noise makes, with its line in the file
 * @property areDepths whether they are normal optical depths −sin B · ln T
 */
public class ObservedDepths private constructor(
    public val lines: List<LineOfSight>,
    public val values: DoubleArray,
    public val errors: DoubleArray,
    public val areDepths: Boolean,
    public val remarks: List<String>,
) {
    public companion object {
        /** Rows of a table, at most. */
        public const val MOST: Int = 1000

        /** By how many of its errors a transmission may lie beyond 0 and 1. */
        public const val MOST_ERRORS: Double = 5.0

        /**
         * Reads a CSV file with the columns `elevation` and `azimuth` in degrees, either `optical_depth` or
         * `transmission`, and `error`, in any order, with a unit in brackets behind the name or without. Other columns
         * are passed over, and so are empty lines and those that begin with `#`. The azimuth is that of [LineOfSight].
         *
         * @throws FormatException naming file and line when it cannot be read, a column is missing, there twice or in
         * another unit, a value is no decimal number or out of range, a transmission is more than [MOST_ERRORS] of its
         * errors below 0 or above 1, or there is no row or too many
         */
        @JvmStatic
        public fun read(path: Path): ObservedDepths {
            val columns = CheckedColumns.of(path)
            val areDepths = DEPTH in columns
            val value = if (areDepths) DEPTH else TRANSMISSION
            if (areDepths && TRANSMISSION in columns) {
                throw FormatException("$path: there are $DEPTH and $TRANSMISSION; one of the two is compared")
            }
            columns.require(listOf(ELEVATION, AZIMUTH), listOf(value, ERROR), MOST) {
                if (it == TRANSMISSION) ", and there is no '$DEPTH' either" else ""
            }
            val values = DoubleArray(columns.size)
            val errors = DoubleArray(columns.size)
            val remarks = ArrayList<String>()
            val lines = List(columns.size) { k ->
                values[k] =
                    columns.number(k, value, "a number in -1000..1000") { it >= -MOST_VALUE && it <= MOST_VALUE }
                errors[k] = error(columns, k)
                val beyond = if (areDepths) 0.0 else maxOf(-values[k], values[k] - 1)
                if (beyond > 0) {
                    columns.number(k, value, "in [0, 1] within five of its errors") {
                        beyond <= MOST_ERRORS * errors[k]
                    }
                    remarks +=
                        "Line ${columns.line(k)} of the file has the $value ${values[k]}, which is not in 0 to 1."
                }
                line(columns, k)
            }
            return ObservedDepths(lines, values, errors, areDepths, remarks)
        }

        /** The line of sight in [row] of [columns]. */
        internal fun line(columns: CheckedColumns, row: Int): LineOfSight = LineOfSight.degrees(
            columns.number(row, ELEVATION, "in ${LineOfSight.LOWEST}..90 degrees") {
                it >= LineOfSight.LOWEST && it <= RIGHT
            },
            columns.number(row, AZIMUTH, "in -360..360 degrees") { it >= -TURN && it <= TURN },
        )

        /** The standard error in [row] of [columns]. */
        internal fun error(columns: CheckedColumns, row: Int): Double =
            columns.number(row, ERROR, "finite and at least $LEAST_ERROR") { it >= LEAST_ERROR && it.isFinite() }

        internal const val ELEVATION = "elevation"
        internal const val AZIMUTH = "azimuth"
        internal const val ERROR = "error"
        private const val DEPTH = "optical_depth"
        private const val TRANSMISSION = "transmission"
        private const val RIGHT = 90.0
        private const val TURN = 360.0

        /** Beyond these no square overflows a sum. */
        private const val LEAST_ERROR = 1e-12
        private const val MOST_VALUE = 1000.0
    }
}
