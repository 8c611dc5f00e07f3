package daphnis.core.format

import daphnis.core.population.SphereQuantity
import java.nio.file.Path

/**
 * Reads a LAMMPS dump state by state.
 *
 * @param notices receives what is there and not used
 */
internal class LammpsDumpReader(
    private val lines: TextLines,
    private val path: Path,
    private val notices: MutableList<String>,
) {
    private val words = LineWords(lines)
    private val told = HashSet<String>()

    /** The next state, null at the end. */
    fun snapshot(): Snapshot? {
        var step: Long? = null
        var time: Double? = null
        var count: Int? = null
        var cell: FileCell? = null
        var line = lines.next() ?: return null
        while (line.isBlank()) line = lines.next() ?: return null
        while (!line.startsWith(ATOMS)) {
            when {
                line.trim() == "ITEM: UNITS" -> next()
                line.trim() == "ITEM: TIME" -> time = words.number(next().trim())
                line.trim() == "ITEM: TIMESTEP" -> step = step(next().trim())
                line.trim() == "ITEM: NUMBER OF ATOMS" -> count = words.count(next())
                line.startsWith(BOX) -> cell = cell(words.split(line).drop(BOX_WORDS))
                else -> lines.fail(
                    "'${TextLines.shown(line)}' must be an ITEM of a LAMMPS dump, such as ITEM: TIMESTEP",
                )
            }
            line = next()
        }
        val at = step ?: lines.fail("ITEM: TIMESTEP is missing before $ATOMS")
        val box = cell ?: lines.fail("$BOX is missing before $ATOMS")
        val columns = LammpsColumns(words.split(line).drop(ATOMS_WORDS), lines::fail)
        val head = lines.number
        val rows = rows(count ?: lines.fail("ITEM: NUMBER OF ATOMS is missing before $ATOMS"), columns, box)
        for (name in columns.unused()) if (told.add(name)) notices += "$path: the column $name is not used"
        return rows.snapshot(at, time, box, { k -> "$path:${head + k + 1}" }, lines::fail)
    }

    private fun next(): String = lines.next() ?: lines.fail("the file is cut short")

    private fun step(text: String): Long =
        text.toLongOrNull() ?: lines.fail("'${TextLines.shown(text)}' must be the number of the step")

    /** @param said what stands behind BOX BOUNDS: the kind of the box, and what its faces do */
    private fun cell(said: List<String>): FileCell {
        val kind = said.takeWhile { it !in FACES }
        val faces = said.drop(kind.size).ifEmpty { listOf("pp", "pp", "pp") }
        if (faces.size != 3 || faces.any { it !in FACES }) {
            lines.fail("$BOX ends with '${TextLines.shown(said.joinToString(" "))}'; it must be such as pp pp ff")
        }
        val periodic = BooleanArray(3) { faces[it] == "pp" }
        val bounded = BooleanArray(3) { faces[it] == "pp" || faces[it] == "ff" }
        if (kind == listOf("abc", "origin")) {
            val rows = Array(3) { numbers(4) }
            val edges = Array(3) { rows[it].copyOf(3) }
            return FileCell(
                DoubleArray(3) {
                    rows[it][3]
                },
                edges,
                periodic,
                bounded,
            ).also { it.normalAxis(lines::fail) }
        }
        if (kind.isNotEmpty() && kind != listOf("xy", "xz", "yz")) {
            lines.fail("$BOX is of '${TextLines.shown(kind.joinToString(" "))}'; known are xy xz yz, and abc origin")
        }
        val rows = Array(3) { numbers(if (kind.isEmpty()) 2 else 3) }
        val tilt = DoubleArray(3) { rows[it].getOrElse(2) { 0.0 } }
        val (xy, xz, yz) = tilt
        // The bounds are those of the whole tilted box.
        val low = DoubleArray(3) { rows[it][0] }
        val high = DoubleArray(3) { rows[it][1] }
        low[0] -= minOf(minOf(0.0, xy), minOf(xz, xy + xz))
        high[0] -= maxOf(maxOf(0.0, xy), maxOf(xz, xy + xz))
        low[1] -= minOf(0.0, yz)
        high[1] -= maxOf(0.0, yz)
        return FileCell.of(low, high, tilt, periodic, bounded).also { it.normalAxis(lines::fail) }
    }

    private fun numbers(count: Int): DoubleArray {
        val said = words.split(next())
        if (said.size != count) lines.fail("${said.size} numbers; a line of the box must have $count")
        return DoubleArray(count) { words.number(said[it]) }
    }

    private fun rows(n: Int, columns: LammpsColumns, cell: FileCell): ParticleRows {
        val scaled = (0..2).count { columns.isScaled(it) }
        if (scaled in 1..2 && cell.normalAxis(lines::fail) >= 0) {
            lines.fail("$ATOMS has scaled coordinates along some axes only, which says nothing in a box that leans")
        }
        val rows = ParticleRows(n)
        rows.known += columns.known
        rows.hasId = columns.id >= 0
        val images = if (columns.knowsImages(cell.periodic)) Array(3) { IntArray(n) } else null
        rows.image = images
        val species = if (columns.type >= 0) Species.Rows(n) else null
        rows.species = species
        rows.firstSpecies = 1
        val place = DoubleArray(3)
        for (k in 0 until n) {
            val line = lines.next() ?: lines.fail("the file is cut short: $n particles are declared, $k are there")
            val cells = words.split(line)
            if (cells.size != columns.width) lines.fail("${cells.size} values; $ATOMS names ${columns.width}")
            for (axis in 0..2) place[axis] = words.number(cells[columns.position[axis]])
            for (axis in 0..2) {
                rows.position[axis][k] = if (columns.isScaled(axis)) cell.place(place, axis) else place[axis]
                val flag = columns.image[axis]
                if (images != null && flag >= 0) images[axis][k] = words.image(cells[flag])
            }
            if (columns.diameter >= 0) rows.radius[k] = words.positive("diameter", cells[columns.diameter]) / 2
            for (quantity in OTHERS) words.take(quantity, columns[quantity], cells, rows, k)
            if (columns.id >= 0) rows.id[k] = words.id(cells[columns.id])
            species?.put(k, cells[columns.type])
        }
        return rows
    }

    private companion object {
        const val ATOMS = "ITEM: ATOMS"
        const val ATOMS_WORDS = 2
        const val BOX = "ITEM: BOX BOUNDS"
        const val BOX_WORDS = 3
        val OTHERS = NUMBERED - SphereQuantity.POSITION

        /**
         * What the two faces of an axis do: both periodic, or each fixed, shrink-wrapped, or shrink-wrapped with a
         * minimum.
         */
        val FACES = setOf("pp") + listOf('f', 's', 'm').flatMap { one -> listOf('f', 's', 'm').map { "$one$it" } }
    }
}
