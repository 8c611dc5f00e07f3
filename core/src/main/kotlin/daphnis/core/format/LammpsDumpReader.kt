package daphnis.core.format

import java.nio.file.Path

/** Reads a LAMMPS dump state by state. */
internal class LammpsDumpReader(private val lines: TextLines, private val path: Path) {
    private val words = LammpsWords(lines)

    /** The next state, null at the end. */
    fun snapshot(): Snapshot? {
        var step: Long? = null
        var time: Double? = null
        var count: Int? = null
        var cell: LammpsCell? = null
        var line = lines.next() ?: return null
        while (line.isBlank()) line = lines.next() ?: return null
        while (!line.startsWith(ATOMS)) {
            when {
                line.trim() == "ITEM: UNITS" -> next()
                line.trim() == "ITEM: TIME" -> time = words.number(next().trim())
                line.trim() == "ITEM: TIMESTEP" -> step = step(next().trim())
                line.trim() == "ITEM: NUMBER OF ATOMS" -> count = words.count(next().trim())
                line.startsWith(BOX) -> cell = cell(words.split(line).drop(BOX_WORDS))
                else -> lines.fail(
                    "'${TextLines.shown(line)}' must be an ITEM of a LAMMPS dump, such as ITEM: TIMESTEP",
                )
            }
            line = next()
        }
        val at = step ?: lines.fail("ITEM: TIMESTEP is missing before $ATOMS")
        val box = cell ?: lines.fail("$BOX is missing before $ATOMS")
        val rows = rows(count ?: lines.fail("ITEM: NUMBER OF ATOMS is missing before $ATOMS"), Columns(line), box)
        val snapshot = rows.snapshot(at, time ?: at.toDouble(), box, lines::fail)
        return snapshot.also { SnapshotCheck.check(it, "$path:${lines.number}") }
    }

    private fun next(): String = lines.next() ?: lines.fail("the file is cut short")

    private fun step(text: String): Long =
        text.toLongOrNull() ?: lines.fail("'${TextLines.shown(text)}' must be the number of the step")

    /** @param said what stands behind BOX BOUNDS: the kind of the box, and what its faces do */
    private fun cell(said: List<String>): LammpsCell {
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
            return LammpsCell(DoubleArray(3) { rows[it][3] }, edges, periodic, bounded)
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
        return LammpsCell.of(low, high, tilt, periodic, bounded)
    }

    private fun numbers(count: Int): DoubleArray {
        val said = words.split(next())
        if (said.size != count) lines.fail("${said.size} numbers; a line of the box must have $count")
        return DoubleArray(count) { words.number(said[it]) }
    }

    private fun rows(n: Int, columns: Columns, cell: LammpsCell): LammpsRows {
        val rows = LammpsRows(n)
        rows.hasMass = columns.mass >= 0
        rows.hasRadius = columns.radius >= 0 || columns.diameter >= 0
        val place = DoubleArray(3)
        for (k in 0 until n) {
            val line = lines.next() ?: lines.fail("the file is cut short: $n particles are declared, $k are there")
            val cells = words.split(line)
            if (cells.size != columns.width) lines.fail("${cells.size} values; $ATOMS names ${columns.width}")
            for (axis in 0..2) place[axis] = words.number(cells[columns.position[axis]])
            for (axis in 0..2) rows.position[axis][k] = if (columns.isScaled) cell.place(place, axis) else place[axis]
            for (axis in 0..2) {
                val column = columns.velocity[axis]
                if (column >= 0) rows.velocity[axis][k] = words.number(cells[column])
            }
            if (columns.diameter >= 0) rows.radius[k] = words.positive("diameter", cells[columns.diameter]) / 2
            if (columns.radius >= 0) rows.radius[k] = words.positive("radius", cells[columns.radius])
            if (columns.mass >= 0) rows.mass[k] = words.positive("mass", cells[columns.mass])
            if (columns.id >= 0) rows.id[k] = words.id(cells[columns.id])
        }
        return rows
    }

    /** Places of the columns in [line], −1 for those that it does not name. */
    private inner class Columns(line: String) {
        private val names = words.split(line).drop(ATOMS_WORDS).also { names ->
            val twice = names.find { name -> names.count { it == name } > 1 }
            if (twice != null) lines.fail("$ATOMS names '${TextLines.shown(twice)}' twice")
        }
        val width = names.size
        val id = names.indexOf("id")
        val radius = names.indexOf("radius")
        val diameter = names.indexOf("diameter")
        val mass = names.indexOf("mass")
        val velocity = IntArray(3) { names.indexOf("v" + "xyz"[it]) }
        private val kind = KINDS.find { end -> "xyz".all { "$it$end" in names } }
            ?: lines.fail("$ATOMS has no x y z; columns x y z, xu yu zu, xs ys zs or xsu ysu zsu are needed")
        val isScaled = kind.startsWith("s")
        val position = IntArray(3) { names.indexOf("xyz"[it] + kind) }
    }

    private companion object {
        const val ATOMS = "ITEM: ATOMS"
        const val ATOMS_WORDS = 2
        const val BOX = "ITEM: BOX BOUNDS"
        const val BOX_WORDS = 3

        /** What faces do: periodic, fixed, shrink-wrapped, shrink-wrapped with a minimum; a letter for each side. */
        val FACES = listOf('p', 'f', 's', 'm').flatMap { one -> listOf('p', 'f', 's', 'm').map { "$one$it" } }.toSet()

        /** What may stand behind x, y and z. */
        val KINDS = listOf("", "u", "s", "su")
    }
}
