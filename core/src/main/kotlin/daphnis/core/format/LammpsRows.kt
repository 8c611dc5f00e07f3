package daphnis.core.format

/** The particles of a state in a LAMMPS file, with substitutes for what the file does not have. */
internal class LammpsRows(private val size: Int) {
    val id = IntArray(size) { it }
    val position = Array(3) { DoubleArray(size) }
    val velocity = Array(3) { DoubleArray(size) }
    val radius = DoubleArray(size) { 0.5 }
    val mass = DoubleArray(size) { 1.0 }
    var hasMass = false
    var hasRadius = false

    /** The state in the order of ids, in a box that is centred on the origin. */
    fun snapshot(step: Long, time: Double, cell: LammpsCell, fail: (String) -> Nothing): Snapshot {
        for (axis in 0..2) {
            val shift = cell.centre(axis)
            if (shift != 0.0) for (k in 0 until size) position[axis][k] -= shift
        }
        val normal = cell.normalAxis(fail)
        val slide = if (normal == 0) 1 else 0
        val order = (0 until size).sortedBy { id[it] }
        fun sorted(a: DoubleArray) = DoubleArray(size) { a[order[it]] }
        return Snapshot(
            step, time, cell.lengths, cell.periodic, if (normal < 0) 0.0 else cell.edges[normal][slide],
            IntArray(size) { id[order[it]] },
            Array(3) { sorted(position[it]) }, Array(3) { sorted(velocity[it]) }, sorted(radius), sorted(mass),
            if (normal < 0) 1 else normal, slide, hasMass, hasRadius,
        )
    }
}

/** The words of a line in a LAMMPS file as numbers, refused with the file and the line. */
internal class LammpsWords(private val lines: TextLines) {
    fun number(text: String): Double = text.toDoubleOrNull()?.takeIf { it.isFinite() }
        ?: lines.fail("'${TextLines.shown(text)}' must be a finite number")

    fun positive(name: String, text: String): Double =
        number(text).also { if (it <= 0) lines.fail("$name is $it; it must be > 0") }

    fun id(text: String): Int = text.toIntOrNull()?.takeIf { it >= 0 }
        ?: lines.fail("id is '${TextLines.shown(text)}'; it must be a whole number in 0..${Int.MAX_VALUE}")

    /** A number of particles, if the file is long enough for so many. */
    fun count(text: String): Int {
        val n = text.toIntOrNull()?.takeIf { it >= 0 }
            ?: lines.fail("'${TextLines.shown(text)}' must be the number of particles")
        if (n > lines.bytes / LEAST_BYTES) {
            lines.fail("$n particles are declared; a file of ${lines.bytes} bytes cannot hold so many")
        }
        return n
    }

    fun split(line: String): List<String> = line.trim().split(SPACES)

    private companion object {
        val SPACES = Regex("\\s+")

        /** A line of a particle is no shorter than `0 0 0` and its end. */
        const val LEAST_BYTES = 6
    }
}
