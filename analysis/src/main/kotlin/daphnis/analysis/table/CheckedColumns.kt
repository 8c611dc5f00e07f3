package daphnis.analysis.table

import daphnis.core.format.FormatException
import daphnis.core.format.PackedFile
import daphnis.core.format.reasonOf
import daphnis.core.table.UnitsOfDimensions
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Path

/**
 * A table that a user wrote, CSV with a header: columns in any order, with a unit in brackets behind a name or without.
 * Columns beyond those asked for are passed over, and so are empty lines and those that begin with `#`.
 */
internal class CheckedColumns private constructor(
    private val path: Path,
    private val heads: List<String>,
    private val rows: List<IndexedValue<String>>,
) {
    private val names = heads.map { UnitsOfDimensions.nameIn(it) }
    private val places = HashMap<String, Int>()
    private val cells by lazy { rows.map { cellsOf(it) } }

    /** Number of rows. */
    val size: Int get() = rows.size

    operator fun contains(name: String): Boolean = name in names

    /** The line of the file in which [row] is, from 1 on. */
    fun line(row: Int): Int = rows[row].index + 1

    /** The number in [row] of the column [name], which [holds]; if not, the error says that it must be [right]. */
    inline fun number(row: Int, name: String, right: String, holds: (Double) -> Boolean): Double {
        val cell = cells[row][places.getValue(name)].trim()
        val number = if (DECIMAL.matches(cell)) cell.toDouble() else null
        if (number != null && holds(number)) return number
        throw FormatException("$path:${line(row)}: $name is '${cell.take(LONGEST_CELL)}'; it must be $right")
    }

    private fun cellsOf(row: IndexedValue<String>): List<String> {
        val cells = row.value.split(',')
        if (cells.size == names.size) return cells
        throw FormatException("$path:${row.index + 1}: ${cells.size} values, the header has ${names.size}")
    }

    /** Asks for the columns [angles], in degrees, and [numbers], which are pure; [note] on one that is missing. */
    fun require(angles: List<String>, numbers: List<String>, most: Int, note: (String) -> String = { "" }) {
        for (name in angles + numbers) {
            val place = names.indexOf(name)
            if (place < 0) throw FormatException("$path: column '$name' is missing${note(name)}")
            places[name] = place
        }
        for (name in angles) checkHead(name, DEGREES, "in degrees")
        for (name in numbers) checkHead(name, PURE, "a pure number")
        if (rows.isEmpty()) throw FormatException("$path: has no rows")
        if (rows.size > most) throw FormatException("$path: ${rows.size} rows; at most $most are read")
        cells.size
    }

    private fun checkHead(name: String, units: List<String>, right: String) {
        if (names.count { it == name } > 1) throw FormatException("$path: column '$name' occurs twice")
        val head = heads[places.getValue(name)]
        if (head == name) return
        val unit = head.substringAfter('[').removeSuffix("]").trim()
        if (unit !in units) {
            throw FormatException("$path: $name is in '${unit.take(LONGEST_CELL)}'; it must be $right")
        }
    }

    companion object {
        private const val LONGEST = 1 shl 20
        const val LONGEST_CELL = 40
        private val DEGREES = listOf("degrees", "degree", "deg", "°")
        private val PURE = listOf("1", "")
        val DECIMAL = Regex("[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][+-]?[0-9]+)?")

        /** @throws FormatException when [path] cannot be read or has no header */
        fun of(path: Path): CheckedColumns {
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
            return CheckedColumns(path, head.value.split(',').map { it.trim() }, rows.drop(1))
        }

        /** [path] with the columns [angles], in degrees, and [numbers], which are pure, and up to [most] rows. */
        fun read(path: Path, angles: List<String>, numbers: List<String>, most: Int): CheckedColumns =
            of(path).also { it.require(angles, numbers, most) }
    }
}
