package daphnis.analysis.occultation

import daphnis.core.format.FormatException
import daphnis.core.format.PackedFile
import daphnis.core.format.reasonOf
import daphnis.core.table.UnitsOfDimensions
import java.io.IOException
import java.nio.charset.CharacterCodingException
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
            val text = try {
                PackedFile.text(path, LONGEST)
            } catch (_: CharacterCodingException) {
                throw FormatException("$path: is not UTF-8 text")
            } catch (e: IOException) {
                throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
            }
            val rows = text.lines().withIndex().filter { (_, line) ->
                line.isNotBlank() && !line.trimStart().startsWith("#")
            }
            val head = rows.firstOrNull() ?: throw FormatException("$path: is empty; it must have a header and rows")
            return Reader(path, head.value.split(',').map { it.trim() }).read(rows.drop(1))
        }

        private const val LONGEST = 1 shl 20
        private const val LONGEST_CELL = 40
        private const val ELEVATION = "elevation"
        private const val AZIMUTH = "azimuth"
        private const val DEPTH = "optical_depth"
        private const val TRANSMISSION = "transmission"
        private const val ERROR = "error"

        /** Beyond these no square overflows a sum. */
        private const val LEAST_ERROR = 1e-12
        private const val MOST_VALUE = 1000.0
        private val DEGREES = listOf("degrees", "degree", "deg", "°")
        private val PURE = listOf("1", "")
        private val DECIMAL = Regex("[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][+-]?[0-9]+)?")
    }

    private class Reader(private val path: Path, private val heads: List<String>) {
        private val names = heads.map { UnitsOfDimensions.nameIn(it) }
        private val areDepths = DEPTH in names
        private val value = if (areDepths) DEPTH else TRANSMISSION
        private val places = listOf(ELEVATION, AZIMUTH, value, ERROR).associateWith { names.indexOf(it) }

        fun read(rows: List<IndexedValue<String>>): ObservedDepths {
            if (areDepths && TRANSMISSION in names) {
                throw FormatException("$path: there are $DEPTH and $TRANSMISSION; one of the two is compared")
            }
            places.entries.find { it.value < 0 }?.let {
                val or = if (it.key == TRANSMISSION) ", and there is no '$DEPTH' either" else ""
                throw FormatException("$path: column '${it.key}' is missing$or")
            }
            for ((name, place) in places) checkHead(name, heads[place])
            if (rows.isEmpty()) throw FormatException("$path: has no rows")
            if (rows.size > MOST) throw FormatException("$path: ${rows.size} rows; at most $MOST are compared")
            val values = DoubleArray(rows.size)
            val errors = DoubleArray(rows.size)
            val remarks = ArrayList<String>()
            val lines = rows.mapIndexed { k, (index, line) ->
                val cells = line.split(',')
                if (cells.size != names.size) {
                    throw FormatException("$path:${index + 1}: ${cells.size} values, the header has ${names.size}")
                }
                fun number(name: String, right: String, holds: (Double) -> Boolean): Double {
                    val cell = cells[places.getValue(name)].trim()
                    val number = if (DECIMAL.matches(cell)) cell.toDouble() else null
                    if (number != null && holds(number)) return number
                    throw FormatException(
                        "$path:${index + 1}: $name is '${cell.take(LONGEST_CELL)}'; it must be $right",
                    )
                }
                values[k] = number(value, "a number in -1000..1000") { it >= -MOST_VALUE && it <= MOST_VALUE }
                errors[k] = number(ERROR, "finite and at least $LEAST_ERROR") { it >= LEAST_ERROR && it.isFinite() }
                val beyond = if (areDepths) 0.0 else maxOf(-values[k], values[k] - 1)
                if (beyond > 0) {
                    number(value, "in [0, 1] within five of its errors") { beyond <= MOST_ERRORS * errors[k] }
                    remarks += "Line ${index + 1} of the file has the $value ${values[k]}, which is not in 0 to 1."
                }
                LineOfSight.degrees(
                    number(ELEVATION, "in ${LineOfSight.LOWEST}..90 degrees") { it >= LineOfSight.LOWEST && it <= 90 },
                    number(AZIMUTH, "in -360..360 degrees") { it >= -360 && it <= 360 },
                )
            }
            return ObservedDepths(lines, values, errors, areDepths, remarks)
        }

        private fun checkHead(name: String, head: String) {
            if (names.count { it == name } > 1) throw FormatException("$path: column '$name' occurs twice")
            if (head == name) return
            val unit = head.substringAfter('[').removeSuffix("]").trim()
            val isAngle = name == ELEVATION || name == AZIMUTH
            if (unit in if (isAngle) DEGREES else PURE) return
            val right = if (isAngle) "in degrees" else "a pure number"
            throw FormatException("$path: $name is in '${unit.take(LONGEST_CELL)}'; it must be $right")
        }
    }
}
