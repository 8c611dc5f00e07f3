package daphnis.analysis.table

import daphnis.core.format.FormatException
import daphnis.core.format.PackedFile
import daphnis.core.format.reasonOf
import daphnis.core.table.TableColumns
import daphnis.core.table.UnitsOfDimensions
import daphnis.core.table.needed
import java.io.IOException
import java.nio.file.Path

/** Reads a CSV file of numbers that a run appends to, by the names of its columns. */
internal object NumberColumns {
    /**
     * The columns of [path] by name, all equally long, in the order of rows; columns beyond those needed come along, with
     * NaN for an empty cell. A run may be writing still: what follows the last line end is left out, and a last line
     * with too few values. A file without a whole line has no rows.
     *
     * @param declared which columns must be there, [order] among them
     * @param order the column that never falls from row to row
     * @throws FormatException naming file and line when it cannot be read, a column is missing, a value is no number or
     * [order] falls
     */
    fun read(path: Path, declared: TableColumns, order: String = "time"): Map<String, DoubleArray> {
        val needed = declared.needed
        val text = try {
            PackedFile.text(path)
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
        }
        // Half a number looks like a whole one: only the line end tells.
        val lines = text.substring(0, text.lastIndexOf('\n') + 1).lines().dropLast(1)
        if (lines.isEmpty()) return needed.associateWith { DoubleArray(0) }
        val names = lines[0].split(',').map { UnitsOfDimensions.nameIn(it) }
        for (name in needed) if (name !in names) throw FormatException("$path: column '$name' is missing")
        val columns = Array(names.size) { DoubleArray(lines.size - 1) }
        var rows = 0
        for (k in 1 until lines.size) {
            val cells = lines[k].split(',')
            if (cells.size < names.size && k == lines.lastIndex) break
            if (cells.size != names.size) {
                throw FormatException("$path:${k + 1}: ${cells.size} values, the header has ${names.size}")
            }
            for (c in names.indices) {
                columns[c][rows] =
                    number(cells[c], names[c] in needed) ?: damaged(path, k, names[c], cells[c], "a number")
            }
            rows++
        }
        checkOrder(path, order, columns[names.indexOf(order)], rows)
        return names.indices.associate { names[it] to columns[it].copyOf(rows) }
    }

    private fun number(cell: String, needed: Boolean): Double? = if (cell.isEmpty() && !needed) {
        Double.NaN
    } else {
        cell.toDoubleOrNull()
    }

    private fun checkOrder(path: Path, name: String, numbers: DoubleArray, rows: Int) {
        for (row in 0 until rows) {
            if (!numbers[row].isFinite()) damaged(path, row + 1, name, "${numbers[row]}", "finite")
            if (row == 0 || numbers[row] >= numbers[row - 1]) continue
            damaged(path, row + 1, name, "${numbers[row]}", "at least that of the row before, ${numbers[row - 1]}")
        }
    }

    private fun damaged(path: Path, line: Int, name: String, cell: String, right: String): Nothing =
        throw FormatException("$path:${line + 1}: $name is '${cell.take(LONGEST_CELL)}'; it must be $right")

    private const val LONGEST_CELL = 40
}
