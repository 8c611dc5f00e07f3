package daphnis.core.format

import java.io.BufferedReader
import java.nio.file.Path

/** Reads extended XYZ frame by frame. */
internal class XyzReader(private val input: BufferedReader, private val path: Path) {
    private var line = 0

    /** The next frame, null at the end. */
    fun frame(number: Int): Frame? {
        var head = next() ?: return null
        while (head.isBlank()) head = next() ?: return null
        val n = head.trim().toIntOrNull()?.takeIf { it >= 0 } ?: fail("'${head.take(MOST_SHOWN)}' must be the number of particles")
        val comment = next() ?: fail("the file is cut short")
        val keys = ENTRY.findAll(comment).associate { it.groupValues[1].lowercase() to it.groupValues[2].trim('"') }
        val columns = Columns(keys["properties"] ?: "species:S:1:pos:R:3")
        if (columns.position < 0) fail("Properties has no pos:R:3")
        val position = Array(3) { DoubleArray(n) }
        val velocity = Array(3) { DoubleArray(n) }
        val radius = DoubleArray(n) { 0.5 }
        val mass = DoubleArray(n) { 1.0 }
        val id = IntArray(n) { it }
        for (k in 0 until n) {
            val cells = (next() ?: fail("the file is cut short: $n particles are announced, $k are there")).trim().split(SPACES)
            if (cells.size < columns.width) fail("${cells.size} values, Properties has ${columns.width}")
            for (axis in 0..2) position[axis][k] = number(cells[columns.position + axis])
            if (columns.velocity >= 0) for (axis in 0..2) velocity[axis][k] = number(cells[columns.velocity + axis])
            if (columns.radius >= 0) radius[k] = number(cells[columns.radius]).also { if (it <= 0) fail("radius is $it; it must be > 0") }
            if (columns.mass >= 0) mass[k] = number(cells[columns.mass]).also { if (it <= 0) fail("mass is $it; it must be > 0") }
            if (columns.id >= 0) {
                id[k] = cells[columns.id].toIntOrNull()?.takeIf { it >= 0 }
                    ?: fail("id is '${cells[columns.id].take(MOST_SHOWN)}'; it must be a whole number, 0 to ${Int.MAX_VALUE}")
            }
        }
        unscale(keys, position, velocity, radius)
        return made(number, keys, columns, id, position, velocity, radius, mass)
    }

    /** Takes back the factor on lengths and velocities that [ExtendedXyz.write] multiplied by. */
    private fun unscale(keys: Map<String, String>, position: Array<DoubleArray>, velocity: Array<DoubleArray>, radius: DoubleArray) {
        val scale = scale(keys)
        if (scale == 1.0) return
        for (column in position + velocity + radius) for (k in column.indices) column[k] /= scale
    }

    private fun scale(keys: Map<String, String>): Double {
        val scale = keys["scale"]?.let { number(it) } ?: 1.0
        if (scale <= 0) fail("Scale is $scale; it must be > 0")
        return scale
    }

    private fun made(
        number: Int,
        keys: Map<String, String>,
        columns: Columns,
        id: IntArray,
        position: Array<DoubleArray>,
        velocity: Array<DoubleArray>,
        radius: DoubleArray,
        mass: DoubleArray,
    ): Frame {
        val scale = scale(keys)
        val lattice = keys["lattice"]?.trim()?.split(SPACES)?.map { number(it) / scale }
        if (lattice != null && lattice.size != CELL) fail("Lattice has ${lattice.size} numbers; it must have 9")
        val lengths = DoubleArray(3) { lattice?.get(4 * it) ?: Double.NaN }
        lengths.find { it <= 0 }?.let { fail("Lattice has an edge of $it along its axis; it must be > 0") }
        val periodic = keys["pbc"]?.trim()?.split(SPACES)?.map { it.startsWith("T", ignoreCase = true) || it == "1" } ?: List(3) { lattice != null }
        if (periodic.size != 3) fail("pbc has ${periodic.size} entries; it must have 3")
        // Row 1 leans along x (Lees–Edwards), or row 0 along y (a shearing sheet).
        val overX = lattice?.get(1) ?: 0.0
        val overY = lattice?.get(3) ?: 0.0
        val origin = keys["origin"]?.trim()?.split(SPACES)?.map { number(it) / scale }
        if (lattice != null) {
            // Boxes here are centred on the origin.
            for (axis in 0..2) {
                val shift = (origin?.getOrNull(axis) ?: 0.0) + lengths[axis] / 2
                if (shift != 0.0) for (k in id.indices) position[axis][k] -= shift
            }
        }
        return Frame(
            keys["step"]?.toLongOrNull() ?: number.toLong(), keys["time"]?.toDoubleOrNull() ?: number.toDouble(), lengths, periodic.toBooleanArray(),
            if (overX != 0.0) overX else overY, id, position, velocity, radius, mass, if (overX != 0.0) 0 else 1, if (overX != 0.0) 1 else 0,
            columns.mass >= 0, columns.radius >= 0,
        ).also { frame ->
            try {
                frame.population()
            } catch (e: IllegalArgumentException) {
                fail("${e.message}")
            }
        }
    }

    private fun next(): String? = input.readLine()?.also { line++ }

    private fun number(text: String): Double = text.toDoubleOrNull()?.takeIf { it.isFinite() } ?: fail("'${text.take(MOST_SHOWN)}' must be a finite number")

    private fun fail(problem: String): Nothing = throw FormatException("$path:$line: $problem")

    /** Where in a line what stands. */
    private inner class Columns(properties: String) {
        var position = -1
        var velocity = -1
        var radius = -1
        var mass = -1
        var id = -1
        var width = 0

        init {
            val parts = properties.split(':')
            if (parts.size % 3 != 0) fail("Properties '${properties.take(MOST_SHOWN)}' must be name:type:count, again and again")
            for (k in parts.indices step 3) {
                val count = parts[k + 2].toIntOrNull()?.takeIf { it > 0 } ?: fail("Properties: '${parts[k + 2].take(MOST_SHOWN)}' must be a number of columns")
                when (parts[k].lowercase()) {
                    "pos" -> if (count == 3) position = width
                    "velo", "vel", "velocity", "velocities" -> if (count == 3) velocity = width
                    "radius" -> radius = width
                    "mass", "masses" -> mass = width
                    "id" -> id = width
                }
                width += count
            }
        }
    }

    private companion object {
        val SPACES = Regex("\\s+")
        val ENTRY = Regex("""(\w+)=("[^"]*"|\S+)""")
        const val MOST_SHOWN = 40
        const val CELL = 9
    }
}
