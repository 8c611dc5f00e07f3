package daphnis.analysis.table

import daphnis.core.format.WholeFile
import java.io.IOException
import java.io.Writer
import java.nio.file.Files
import java.nio.file.Path

/** A column of numbers with its unit, empty for a pure number. */
public class Column(public val name: String, public val unit: String, public val values: DoubleArray)

/** Columns of equal length, written as CSV with names and units in the header: `x [m]`. NaN is an empty cell. */
public class Table(public val name: String, public val columns: List<Column>) {
    init {
        val rows = columns.firstOrNull()?.values?.size ?: 0
        for (column in columns) {
            require(column.values.size == rows) {
                "$name: column ${column.name} has ${column.values.size} rows, the first has $rows"
            }
        }
    }

    /** Writes `name.csv` into [directory], which is made; the whole file, or what was there stays. */
    @Throws(IOException::class)
    public fun write(directory: Path) {
        Files.createDirectories(directory)
        WholeFile.write(directory.resolve("$name.csv")) { part -> Files.newBufferedWriter(part).use { write(it) } }
    }

    private fun write(out: Writer) {
        out.append(columns.joinToString(",") { if (it.unit.isEmpty()) it.name else "${it.name} [${it.unit}]" })
        out.append('\n')
        for (row in 0 until (columns.firstOrNull()?.values?.size ?: 0)) {
            out.append(columns.joinToString(",") { c -> c.values[row].let { if (it.isNaN()) "" else it.toString() } })
            out.append('\n')
        }
    }
}
