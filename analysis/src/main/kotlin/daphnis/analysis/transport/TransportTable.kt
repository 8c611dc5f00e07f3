package daphnis.analysis.transport

import daphnis.core.format.FormatException
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** The rows of a run's `transport.csv` as columns, in order of time. */
public class TransportTable private constructor(private val columns: Map<String, DoubleArray>) {
    /** Number of rows. */
    public val size: Int get() = columns.getValue("time").size

    /** Column [name] of the file. */
    public operator fun get(name: String): DoubleArray = columns.getValue(name)

    /** Whether the file has a column [name]. */
    public operator fun contains(name: String): Boolean = name in columns

    /** The rows from [time] on. */
    public fun from(time: Double): TransportTable {
        val first = this["time"].indexOfFirst { it >= time }.let { if (it < 0) size else it }
        return TransportTable(columns.mapValues { it.value.copyOfRange(first, size) })
    }

    public companion object {
        private val NEEDED = listOf("time", "particles", "mass", "c_xx", "c_yy", "c_zz", "c_xy", "scale_height", "collisions", "dissipated", "virial_xy")

        /** Reads [path]; a last line that is cut short, as of a run that goes on, is left out. @throws FormatException when it is no such file */
        public fun read(path: Path): TransportTable {
            val lines = try {
                Files.readAllLines(path)
            } catch (e: IOException) {
                throw FormatException("$path: cannot be read: ${e.message}")
            }
            val names = lines.firstOrNull()?.split(',').orEmpty()
            for (name in NEEDED) if (name !in names) throw FormatException("$path: column '$name' is missing")
            val rows = ArrayList<DoubleArray>()
            for ((number, line) in lines.drop(1).withIndex()) {
                val cells = line.split(',')
                if (cells.size != names.size && number == lines.size - 2) break
                if (cells.size != names.size) throw FormatException("$path:${number + 2}: ${cells.size} values, the header has ${names.size}")
                rows += DoubleArray(names.size) { k ->
                    cells[k].toDoubleOrNull() ?: throw FormatException("$path:${number + 2}: ${names[k]} is '${cells[k].take(40)}'; it must be a number")
                }
            }
            return TransportTable(names.withIndex().associate { (k, name) -> name to DoubleArray(rows.size) { rows[it][k] } })
        }
    }
}
