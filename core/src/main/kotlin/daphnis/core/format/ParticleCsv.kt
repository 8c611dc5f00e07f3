package daphnis.core.format

import daphnis.core.population.Population
import java.io.IOException
import java.nio.file.Path

/**
 * A table of spheres as text: a header with `x, y, z, radius` and optionally `vx, vy, vz, mass, id` in any order, then
 * a line a sphere. Lines that are empty or begin with `#` are skipped.
 */
public object ParticleCsv {
    private val KNOWN = listOf("x", "y", "z", "vx", "vy", "vz", "radius", "mass", "id")

    /**
     * Reads [path].
     *
     * @param density mass per volume where the table has no masses
     * @throws FormatException that names the line and column of what is wrong
     */
    public fun read(path: Path, density: Double = 1.0): Population = frame(path, density).population()

    /** Reads [path] as a frame at step and time 0, masses from density 1 where it has none. */
    public fun frame(path: Path): Snapshot = frame(path, 1.0)

    private fun frame(path: Path, density: Double): Snapshot {
        val table = try {
            TextLines(path).use { table(it, path) }
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${e.message}")
        }
        return table.frame(density).also { SnapshotCheck.check(it, "$path") }
    }

    private fun table(lines: TextLines, path: Path): Table {
        var table: Table? = null
        while (true) {
            // Some programs mark UTF-8 at the beginning.
            val line = (lines.next() ?: break).removePrefix("\uFEFF").trim()
            if (line.isEmpty() || line.startsWith("#")) continue
            val cells = line.split(',').map { it.trim() }
            if (table == null) table = Table(header(cells, path)) else table.rows += row(cells, table.names, lines)
        }
        return table ?: throw FormatException("$path: is empty; a header with x, y, z, radius is needed")
    }

    private fun header(names: List<String>, path: Path): List<String> {
        for (name in names) {
            if (name !in KNOWN) {
                throw FormatException(
                    "$path: unknown column '${TextLines.shown(name)}'; known: ${KNOWN.joinToString()}",
                )
            }
        }
        for (name in listOf("x", "y", "z", "radius")) {
            if (name !in names) {
                throw FormatException("$path: column '$name' is missing")
            }
        }
        for (name in KNOWN) {
            if (names.count { it == name } > 1) {
                throw FormatException("$path: column '$name' occurs twice")
            }
        }
        return names
    }

    private fun row(cells: List<String>, names: List<String>, lines: TextLines): DoubleArray {
        if (cells.size != names.size) lines.fail("${cells.size} values, the header has ${names.size}")
        return DoubleArray(cells.size) { k ->
            val value = cells[k].toDoubleOrNull()
            val right = when {
                value == null || !value.isFinite() -> "a finite number"
                names[k] == "id" && !isId(value) -> "a whole number in 0..${Int.MAX_VALUE}"
                (names[k] == "radius" || names[k] == "mass") && !(value > 0) -> "> 0"
                else -> null
            }
            if (right != null) lines.fail("${names[k]} is '${TextLines.shown(cells[k])}'; it must be $right")
            value!!
        }
    }

    private fun isId(value: Double) = value >= 0 && value <= Int.MAX_VALUE && value == Math.rint(value)

    private class Table(val names: List<String>) {
        val rows = ArrayList<DoubleArray>()

        /** The rows in the order of ids. */
        fun frame(density: Double): Snapshot {
            val at = names.indexOf("id")
            if (at >= 0) rows.sortBy { it[at] }
            val radius = column("radius")
            val hasMass = "mass" in names
            val mass = if (hasMass) {
                column("mass")
            } else {
                DoubleArray(rows.size) { density * 4.0 / 3.0 * Math.PI * radius[it] * radius[it] * radius[it] }
            }
            return Snapshot(
                0, 0.0, DoubleArray(3) { Double.NaN }, BooleanArray(3), 0.0,
                if (at < 0) IntArray(rows.size) { it } else IntArray(rows.size) { rows[it][at].toInt() },
                arrayOf(column("x"), column("y"), column("z")), arrayOf(column("vx"), column("vy"), column("vz")),
                radius, mass, hasMass = hasMass,
            )
        }

        /** Zeros when there is none of this [name]. */
        private fun column(name: String): DoubleArray {
            val c = names.indexOf(name)
            return DoubleArray(rows.size) { if (c < 0) 0.0 else rows[it][c] }
        }
    }
}
