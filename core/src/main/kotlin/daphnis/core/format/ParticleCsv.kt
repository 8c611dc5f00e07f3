package daphnis.core.format

import daphnis.core.boundary.Open
import daphnis.core.population.Population
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * A table of spheres as text: a header with `x, y, z, radius` and optionally `vx, vy, vz, mass, id` in any order, then a line a sphere.
 * Lines that are empty or begin with `#` are skipped.
 */
public object ParticleCsv {
    private val KNOWN = listOf("x", "y", "z", "vx", "vy", "vz", "radius", "mass", "id")

    /**
     * Reads [path].
     *
     * @param density mass per volume where the table has no masses
     * @throws FormatException that names the line and column of what is wrong
     */
    public fun read(path: Path, density: Double = 1.0): Population = table(path).let { population(it.rows, it.names, density, path) }

    /** Reads [path] as a frame at step and time 0, masses from density 1 where it has none. */
    public fun frame(path: Path): Frame {
        val table = table(path)
        return Frame.of(population(table.rows, table.names, 1.0, path), Open, 0, 0.0, hasMass = "mass" in table.names)
    }

    private class Table(val names: List<String>, val rows: List<DoubleArray>)

    private fun table(path: Path): Table {
        var header: List<String>? = null
        val rows = ArrayList<DoubleArray>()
        try {
            Files.newBufferedReader(path).useLines { lines ->
                lines.forEachIndexed { number, raw ->
                    // Some programs mark UTF-8 at the beginning.
                    val line = raw.removePrefix("\uFEFF").trim()
                    if (line.isEmpty() || line.startsWith("#")) return@forEachIndexed
                    val cells = line.split(',').map { it.trim() }
                    val names = header
                    if (names == null) header = readHeader(cells, path) else rows += readRow(cells, names, path, number + 1)
                }
            }
        } catch (e: java.nio.charset.CharacterCodingException) {
            throw FormatException("$path: is not UTF-8 text")
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${e.message}")
        }
        val names = header ?: throw FormatException("$path: is empty; a header with x, y, z, radius is needed")
        return Table(names, rows)
    }

    private fun readHeader(names: List<String>, path: Path): List<String> {
        for (name in names) if (name !in KNOWN) throw FormatException("$path: unknown column '$name'; known: ${KNOWN.joinToString()}")
        for (name in listOf("x", "y", "z", "radius")) if (name !in names) throw FormatException("$path: column '$name' is missing")
        for (name in names) if (names.count { it == name } > 1) throw FormatException("$path: column '$name' occurs twice")
        return names
    }

    private fun readRow(cells: List<String>, names: List<String>, path: Path, number: Int): DoubleArray {
        if (cells.size != names.size) throw FormatException("$path:$number: ${cells.size} values, the header has ${names.size}")
        return DoubleArray(cells.size) { k ->
            cells[k].toDoubleOrNull()?.takeIf { it.isFinite() }
                ?: throw FormatException("$path:$number: ${names[k]} is '${cells[k].take(40)}'; it must be a finite number")
        }
    }

    private fun population(rows: List<DoubleArray>, names: List<String>, density: Double, path: Path): Population {
        fun column(name: String): DoubleArray? = names.indexOf(name).takeIf { it >= 0 }?.let { c -> DoubleArray(rows.size) { rows[it][c] } }
        val radius = column("radius")!!
        val none = DoubleArray(rows.size)
        val mass = column("mass") ?: DoubleArray(rows.size) { density * 4.0 / 3.0 * Math.PI * radius[it] * radius[it] * radius[it] }
        val ids = column("id")
        val id = if (ids == null) {
            IntArray(rows.size) { it }
        } else {
            IntArray(rows.size) { k ->
                ids[k].toInt().takeIf { it >= 0 && it.toDouble() == ids[k] }
                    ?: throw FormatException("$path: id ${ids[k]} must be a whole number in 0..${Int.MAX_VALUE}")
            }
        }
        return try {
            Population(
                column("x")!!, column("y")!!, column("z")!!,
                column("vx") ?: none, column("vy") ?: none.copyOf(), column("vz") ?: none.copyOf(),
                radius, mass, id,
            )
        } catch (e: IllegalArgumentException) {
            throw FormatException("$path: ${e.message}")
        }
    }
}
