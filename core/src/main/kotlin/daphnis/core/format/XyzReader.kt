package daphnis.core.format

import java.nio.file.Path

/** Reads extended XYZ frame by frame. */
internal class XyzReader(private val lines: TextLines, private val path: Path) {
    /** The next snapshot, null at the end. */
    fun snapshot(number: Int): Snapshot? {
        var head = lines.next() ?: return null
        while (head.isBlank()) head = lines.next() ?: return null
        val n = count(head)
        val comment = lines.next() ?: fail("the file is cut short")
        val keys = ENTRY.findAll(comment).associate { it.groupValues[1].lowercase() to it.groupValues[2].trim('"') }
        val columns = XyzColumns(keys["properties"] ?: "species:S:1:pos:R:3", ::fail)
        val rows = Rows(n)
        for (k in 0 until n) {
            val line = lines.next() ?: fail("the file is cut short: $n particles are declared, $k are there")
            val cells = line.trim().split(SPACES)
            if (cells.size < columns.width) fail("${cells.size} values, Properties has ${columns.width}")
            rows.set(k, cells, columns)
        }
        val scale = keys["scale"]?.let { number(it) } ?: 1.0
        if (scale <= 0) fail("Scale is $scale; it must be > 0")
        if (scale != 1.0) rows.divide(scale)
        return made(number, keys, columns, rows, scale).also { SnapshotCheck.check(it, "$path:${lines.number}") }
    }

    /** The number of particles that the file declares, if the file is long enough for so many. */
    private fun count(head: String): Int {
        val n = head.trim().toIntOrNull()?.takeIf { it >= 0 }
            ?: fail("'${TextLines.shown(head)}' must be the number of particles")
        if (n > lines.bytes / LEAST_BYTES) {
            fail("$n particles are declared; a file of ${lines.bytes} bytes cannot hold so many")
        }
        return n
    }

    /** The columns of a frame of [n] particles, with substitutes for those that the file does not have. */
    private inner class Rows(n: Int) {
        val position = Array(3) { DoubleArray(n) }
        val velocity = Array(3) { DoubleArray(n) }
        val radius = DoubleArray(n) { 0.5 }
        val mass = DoubleArray(n) { 1.0 }
        val id = IntArray(n) { it }

        fun set(k: Int, cells: List<String>, columns: XyzColumns) {
            for (axis in 0..2) position[axis][k] = number(cells[columns.position + axis])
            if (columns.velocity >= 0) for (axis in 0..2) velocity[axis][k] = number(cells[columns.velocity + axis])
            if (columns.radius >= 0) radius[k] = positive("radius", cells[columns.radius])
            if (columns.mass >= 0) mass[k] = positive("mass", cells[columns.mass])
            if (columns.id >= 0) id[k] = id(cells[columns.id])
        }

        fun divide(scale: Double) {
            for (column in position + velocity + radius) for (k in column.indices) column[k] /= scale
        }

        private fun positive(name: String, text: String): Double {
            val value = number(text)
            if (value <= 0) fail("$name is $value; it must be > 0")
            return value
        }

        private fun id(text: String): Int = text.toIntOrNull()?.takeIf { it >= 0 }
            ?: fail("id is '${TextLines.shown(text)}'; it must be a whole number in 0..${Int.MAX_VALUE}")
    }

    private fun made(number: Int, keys: Map<String, String>, columns: XyzColumns, rows: Rows, scale: Double): Snapshot {
        val lattice = keys["lattice"]?.let { numbers("Lattice", it, CELL) }
        if (lattice != null) for (k in lattice.indices) lattice[k] /= scale
        if (lattice != null) checkLattice(lattice)
        val lengths = DoubleArray(3) { lattice?.get(4 * it) ?: Double.NaN }
        // Row 1 leans along x (Lees–Edwards), or row 0 along y (a shearing sheet).
        val overX = lattice?.get(1) ?: 0.0
        val overY = lattice?.get(3) ?: 0.0
        if (lattice != null) {
            // Boxes here are centred on the origin.
            val origin = keys["origin"]?.let { numbers("Origin", it, 3) } ?: DoubleArray(3)
            for (axis in 0..2) {
                val shift = origin[axis] / scale + lengths[axis] / 2
                if (shift != 0.0) for (k in rows.id.indices) rows.position[axis][k] -= shift
            }
        }
        val time = keys["time"]?.let { number(it) } ?: number.toDouble()
        val step = keys["step"]?.let { step(it) } ?: number.toLong()
        return Snapshot(
            step, time, lengths, periodic(keys, lattice != null),
            if (overX != 0.0) overX else overY, rows.id, rows.position, rows.velocity, rows.radius, rows.mass,
            if (overX != 0.0) 0 else 1, if (overX != 0.0) 1 else 0, columns.mass >= 0, columns.radius >= 0,
        )
    }

    private fun step(text: String): Long =
        text.toLongOrNull() ?: fail("Step is '${TextLines.shown(text)}'; it must be a whole number")

    private fun checkLattice(lattice: DoubleArray) {
        for (axis in 0..2) {
            val edge = lattice[4 * axis]
            if (!(edge > 0)) fail("Lattice has an edge of $edge along its axis; it must be > 0")
        }
        val leaning = LEANING.count { lattice[it] != 0.0 }
        val slides = lattice[1] != 0.0 || lattice[3] != 0.0
        if (leaning > (if (slides) 1 else 0)) {
            fail(
                "Lattice leans in a way that sliding images do not; " +
                    "only its second or its fourth number may be off the diagonal",
            )
        }
    }

    private fun periodic(keys: Map<String, String>, hasLattice: Boolean): BooleanArray {
        val words = keys["pbc"]?.trim()?.split(SPACES) ?: return BooleanArray(3) { hasLattice }
        if (words.size != 3) fail("pbc has ${words.size} entries; it must have 3")
        return BooleanArray(3) { words[it].startsWith("T", ignoreCase = true) || words[it] == "1" }
    }

    private fun numbers(key: String, text: String, count: Int): DoubleArray {
        val words = text.trim().split(SPACES)
        if (words.size != count) fail("$key has ${words.size} numbers; it must have $count")
        return DoubleArray(count) { number(words[it]) }
    }

    private fun number(text: String): Double =
        text.toDoubleOrNull()?.takeIf { it.isFinite() } ?: fail("'${TextLines.shown(text)}' must be a finite number")

    private fun fail(problem: String): Nothing = lines.fail(problem)

    private companion object {
        val SPACES = Regex("\\s+")

        // From the beginning of a word only, so that a long word without '=' is scanned once, not once from each of its
        // letters.
        val ENTRY = Regex("""\b(\w++)=("[^"]*"|\S+)""")
        const val CELL = 9

        /** Entries of a Lattice off the diagonal. */
        val LEANING = intArrayOf(1, 2, 3, 5, 6, 7)

        /** A line of a particle is no shorter than `0 0 0` and its end. */
        const val LEAST_BYTES = 6
    }
}
