package daphnis.core.format

import daphnis.core.population.SphereQuantity
import java.nio.file.Path

/**
 * Reads extended XYZ frame by frame.
 *
 * @param notices receives what is there and not used
 */
internal class XyzReader(
    private val lines: TextLines,
    private val path: Path,
    private val notices: MutableList<String>,
) {
    private val words = LineWords(lines)
    private val told = HashSet<String>()

    /** The next snapshot, null at the end. */
    fun snapshot(number: Int): Snapshot? {
        var head = lines.next() ?: return null
        while (head.isBlank()) head = lines.next() ?: return null
        val n = words.count(head)
        // All of the comment is read while its line is the last one, so that messages name it.
        val frame = Frame(XyzComment(lines.next() ?: lines.fail("the file is cut short"), lines::fail), number)
        val commentLine = lines.number
        val rows = ParticleRows(n)
        rows.known += frame.columns.known
        rows.hasId = XyzColumns.ID in frame.columns
        if (XyzColumns.SPECIES in frame.columns) rows.species = Species.Rows(n)
        rows.materials = frame.materials
        if (XyzColumns.IMAGE in frame.columns) rows.image = Array(3) { IntArray(n) }
        for (k in 0 until n) {
            val line = lines.next() ?: lines.fail("the file is cut short: $n particles are declared, $k are there")
            val cells = words.split(line)
            val tooMany = frame.isNamed && cells.size > frame.columns.width
            if (tooMany || cells.size < frame.columns.width) {
                lines.fail("${cells.size} values, Properties has ${frame.columns.width}")
            }
            set(rows, k, cells, frame.columns)
        }
        if (frame.scale != 1.0) divide(rows, frame.scale)
        tell(frame.columns)
        return rows.snapshot(
            frame.step,
            frame.time,
            frame.cell,
            { k -> "$path:${commentLine + k + 1}" },
            { throw FormatException("$path:$commentLine: $it") },
        )
    }

    private fun set(rows: ParticleRows, k: Int, cells: List<String>, columns: XyzColumns) {
        val diameter = columns[XyzColumns.DIAMETER]
        if (diameter >= 0) rows.radius[k] = words.positive("diameter", cells[diameter]) / 2
        for (quantity in NUMBERED) words.take(quantity, columns[quantity], cells, rows, k)
        if (columns.velocityFollows) {
            val momentum = columns[XyzColumns.MOMENTUM]
            for (axis in 0..2) rows.velocity[axis][k] = words.number(cells[momentum + axis]) / rows.mass[k]
        }
        if (XyzColumns.ID in columns) rows.id[k] = words.id(cells[columns[XyzColumns.ID]])
        rows.species?.put(k, cells[columns[XyzColumns.SPECIES]])
        val image = rows.image ?: return
        for (axis in 0..2) image[axis][k] = words.image(cells[columns[XyzColumns.IMAGE] + axis])
    }

    private fun divide(rows: ParticleRows, scale: Double) {
        for (quantity in NUMBERED) {
            val factor = quantity.dimension.of(scale, 1.0, 1.0)
            for (column in rows[quantity]) for (k in column.indices) column[k] /= factor
        }
    }

    private fun tell(columns: XyzColumns) {
        val isIdle = XyzColumns.MOMENTUM in columns && SphereQuantity.VELOCITY !in columns.known
        if (isIdle && told.add("momenta")) {
            notices += "$path has momenta and no masses, so velocities are not known: 0 is taken for each"
        }
        for (name in columns.unused) if (told.add(name)) notices += "$path: the column $name is not used"
    }

    /** What the [comment] of a frame says. */
    private inner class Frame(comment: XyzComment, number: Int) {
        /** Whether the file names its columns; plain XYZ may have more behind the places. */
        val isNamed = comment["properties"] != null
        val columns = XyzColumns(comment["properties"] ?: "species:S:1:pos:R:3", lines::fail)
        val scale = comment["scale"]?.let { words.number(it) } ?: 1.0
        val time: Double? = comment["time"]?.let { words.number(it) }
        val step: Long = comment["step", "timestep"]?.let { step(it) } ?: number.toLong()
        val cell: FileCell

        /** Names of materials, which are the words of the column species then. */
        val materials: List<String>? = comment.list(MATERIALS)

        init {
            if (scale <= 0) lines.fail("Scale is $scale; it must be > 0")
            val lattice = comment.list("lattice")?.let { numbers("Lattice", it, CELL) }
            cell = if (lattice == null) {
                FileCell.open()
            } else {
                val edges = Array(3) { row -> DoubleArray(3) { lattice[3 * row + it] / scale } }
                for (axis in 0..2) {
                    val edge = edges[axis][axis]
                    if (!(edge > 0)) lines.fail("Lattice has an edge of $edge along its axis; it must be > 0")
                }
                val origin = comment.list("origin")?.let { numbers("Origin", it, 3) } ?: DoubleArray(3)
                FileCell(DoubleArray(3) { origin[it] / scale }, edges, periodic(comment))
            }
            val isLeaning = cell.normalAxis { lines.fail("Lattice: $it") } >= 0
            if (isLeaning && NESTED.containsMatchIn(comment["lattice"].orEmpty())) {
                lines.fail("Lattice leans and is a list of lists, by row or by column; write nine numbers, by row")
            }
        }

        private fun step(text: String): Long =
            text.toLongOrNull() ?: lines.fail("Step is '${TextLines.shown(text)}'; it must be a whole number")

        private fun periodic(comment: XyzComment): BooleanArray {
            val said = comment.list("pbc") ?: return BooleanArray(3) { true }
            val each = when {
                said.size == 1 && said[0].length == 3 -> said[0].map { "$it" }
                said.size == 1 -> List(3) { said[0] }
                else -> said
            }
            if (each.size != 3) lines.fail("pbc has ${said.size} entries; it must have 3")
            return BooleanArray(3) { isTrue(each[it]) }
        }

        private fun isTrue(word: String): Boolean = when (word.lowercase().trim('.')) {
            in TRUE -> true
            in FALSE -> false
            else -> lines.fail("pbc has '${TextLines.shown(word)}'; it must be T or F")
        }

        private fun numbers(key: String, said: List<String>, count: Int): DoubleArray {
            if (said.size != count) lines.fail("$key has ${said.size} numbers; it must have $count")
            return DoubleArray(count) { words.number(said[it]) }
        }
    }

    private companion object {
        const val CELL = 9
        const val MATERIALS = "materials"

        /** A list of lists, which programs fill by row or by column. */
        val NESTED = Regex("""[\[{(]\s*+[\[{(]""")
        val TRUE = setOf("t", "true", "1", "yes", "periodic")
        val FALSE = setOf("f", "false", "0", "no", "none")
    }
}
