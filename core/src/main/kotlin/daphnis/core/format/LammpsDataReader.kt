package daphnis.core.format

import daphnis.core.population.SphereQuantity
import java.nio.file.Path

/**
 * Reads a LAMMPS data file.
 *
 * @param notices receives what is taken where the file does not say it
 */
internal class LammpsDataReader(
    private val lines: TextLines,
    private val path: Path,
    private val notices: MutableList<String>,
) {
    private val words = LineWords(lines)
    private val low = DoubleArray(3)
    private val high = DoubleArray(3)
    private val bounded = BooleanArray(3)
    private val tilt = DoubleArray(3)
    private val massOfType = HashMap<String, Double>()
    private var count: Int? = null
    private var rows: ParticleRows? = null

    /** Place of an id in [rows]. */
    private val places = HashMap<Int, Int>()
    private val types = ArrayList<String>()
    private var isAtomic = false
    private var hasSpins = false

    fun snapshot(): Snapshot {
        val step = title(lines.next() ?: throw FormatException("$path: is empty"))
        var section = header()
        while (section != null) {
            section = when (words.split(bare(section)).first()) {
                "Atoms" -> atoms(style(section))
                "Velocities" -> velocities()
                "Masses" -> masses()
                else -> skip()
            }
        }
        val rows = rows ?: throw FormatException("$path: has no section Atoms")
        if (isAtomic) massesByType(rows)
        val cell = FileCell.of(low, high, tilt, bounded, bounded)
        return rows.snapshot(step, 0.0, cell, { "$path" }, { throw FormatException("$path: $it") })
            .with(hasTime = false)
    }

    /** The first line is free text, in which LAMMPS names the step. */
    private fun title(line: String): Long = STEP.find(line)?.groupValues?.get(1)?.toLongOrNull() ?: 0

    private fun bare(line: String) = line.substringBefore('#').trim()

    /** @return the line of the first section, null when there is none */
    private fun header(): String? {
        while (true) {
            val line = lines.next() ?: return null
            val bare = bare(line)
            if (bare.isEmpty()) continue
            if (bare[0].isLetter()) return line
            val said = words.split(bare)
            val axis = BOUNDS.indexOf(said.drop(2))
            when {
                said.drop(1) == listOf("atoms") -> count = words.count(said[0])
                axis >= 0 -> {
                    low[axis] = words.number(said[0])
                    high[axis] = words.number(said[1])
                    bounded[axis] = true
                }
                said.drop(3) == listOf("xy", "xz", "yz") -> for (k in 0..2) tilt[k] = words.number(said[k])
                said.last() in VECTORS || said.takeLast(2) == listOf("abc", "origin") ->
                    lines.fail("a general triclinic box is not read; write it with xlo xhi and xy xz yz")
            }
        }
    }

    /** `Atoms # sphere`; without the comment the number of columns tells. */
    private fun style(section: String): String? = section.substringAfter('#', "").trim().ifEmpty { null }

    private fun atoms(style: String?): String? {
        if (style != null && style !in STYLES) {
            lines.fail("atom style '${TextLines.shown(style)}' is not read; it must be sphere or atomic")
        }
        val n = count ?: lines.fail("the header has no line 'N atoms'")
        if (rows != null) lines.fail("a second section Atoms")
        val rows = ParticleRows(n).also { this.rows = it }
        rows.hasId = true
        val species = Species.Rows(n)
        rows.species = species
        rows.firstSpecies = 1
        for (k in 0 until n) {
            val cells = words.split(row(n, k))
            val widths = STYLES[style]
            val isSphere = if (style == null) cells.size in STYLES.getValue("sphere") else style == "sphere"
            val known = widths ?: STYLES.values.flatten()
            if (cells.size !in known) {
                lines.fail(
                    "${cells.size} values; an atom of style ${style ?: "sphere or atomic"} has ${known.sorted()}",
                )
            }
            if (style == null && k == 0) guess(isSphere, cells.size)
            isAtomic = !isSphere
            rows.id[k] = words.id(cells[0])
            places[rows.id[k]] = k
            types += cells[1]
            species.put(k, cells[1])
            if (isSphere) sphere(rows, k, cells)
            val at = if (isSphere) SPHERE_PLACE else ATOMIC_PLACE
            for (axis in 0..2) rows.position[axis][k] = words.number(cells[at + axis])
            if (cells.size > at + 3) {
                val image = rows.image ?: Array(3) { IntArray(n) }.also { rows.image = it }
                for (axis in 0..2) image[axis][k] = words.image(cells[at + 3 + axis])
            }
        }
        if (!isAtomic) rows.known += listOf(SphereQuantity.RADIUS, SphereQuantity.MASS)
        return section()
    }

    /** Other styles have as many columns, of other meaning, and need masses of types, which spheres do not have. */
    private fun guess(isSphere: Boolean, width: Int) {
        if (isSphere && massOfType.isNotEmpty()) {
            lines.fail(
                "an atom of $width values in a file with Masses may be of several styles; " +
                    "write which behind Atoms, such as Atoms # sphere",
            )
        }
        val columns = if (isSphere) "id type diameter density x y z" else "id type x y z"
        notices += "$path: Atoms does not name its style; $width values are taken as $columns"
    }

    private fun sphere(rows: ParticleRows, k: Int, cells: List<String>) {
        val r = words.positive("diameter", cells[2]) / 2
        rows.radius[k] = r
        rows.mass[k] = words.positive("density", cells[3]) * (4.0 / 3.0 * Math.PI * r * r * r)
    }

    private fun velocities(): String? {
        val rows = rows ?: lines.fail("Velocities come before Atoms")
        val n = count ?: 0
        // One that is named twice leaves another without a velocity.
        val seen = BooleanArray(n)
        for (k in 0 until n) {
            val cells = words.split(row(n, k))
            if (cells.size < VELOCITY_WIDTH) lines.fail("${cells.size} values; a velocity has id vx vy vz")
            // Of other styles more columns mean other things.
            val isSpinning = !isAtomic && cells.size == SPIN_WIDTH
            if (k == 0) hasSpins = isSpinning
            if (isSpinning != hasSpins) {
                lines.fail("${cells.size} values; all lines have id vx vy vz, or all have wx wy wz behind")
            }
            val at = places[words.id(cells[0])] ?: lines.fail("there is no atom ${TextLines.shown(cells[0])}")
            if (seen[at]) lines.fail("atom ${TextLines.shown(cells[0])} has a second velocity")
            seen[at] = true
            for (axis in 0..2) rows.velocity[axis][at] = words.number(cells[1 + axis])
            if (hasSpins) for (axis in 0..2) rows[SphereQuantity.SPIN, axis][at] = words.number(cells[4 + axis])
        }
        rows.known += SphereQuantity.VELOCITY
        if (hasSpins) rows.known += SphereQuantity.SPIN
        return section()
    }

    private fun masses(): String? {
        while (true) {
            val line = lines.next() ?: return null
            val bare = bare(line)
            if (bare.isEmpty()) continue
            val cells = words.split(bare)
            if (cells.size != 2 || cells[1].toDoubleOrNull() == null) return line
            massOfType[cells[0]] = words.positive("mass of type ${TextLines.shown(cells[0])}", cells[1])
        }
    }

    private fun massesByType(rows: ParticleRows) {
        if (massOfType.isEmpty()) return
        for (k in types.indices) {
            rows.mass[k] = massOfType[types[k]]
                ?: throw FormatException("$path: type ${TextLines.shown(types[k])} of an atom has no mass")
        }
        rows.known += SphereQuantity.MASS
    }

    /** A line of a section with [n] lines, of which [k] have been read. */
    private fun row(n: Int, k: Int): String {
        while (true) {
            val line = lines.next() ?: lines.fail("the file is cut short: $n particles are declared, $k are there")
            val bare = bare(line)
            if (bare.isEmpty()) continue
            if (bare[0].isLetter()) lines.fail("$n particles are declared, the section has $k")
            return bare
        }
    }

    /** The line of the next section. */
    private fun section(): String? {
        while (true) {
            val line = lines.next() ?: return null
            val bare = bare(line)
            if (bare.isEmpty()) continue
            if (bare[0].isLetter()) return line
            lines.fail("'${TextLines.shown(bare)}' is one line more than the ${count ?: 0} particles that are declared")
        }
    }

    private fun skip(): String? {
        while (true) {
            val line = lines.next() ?: return null
            if (line.isNotEmpty() && line[0].isLetter()) return line
        }
    }

    private companion object {
        val STEP = Regex("""timestep = (\d+)""")
        val BOUNDS = listOf(listOf("xlo", "xhi"), listOf("ylo", "yhi"), listOf("zlo", "zhi"))
        val VECTORS = setOf("avec", "bvec", "cvec")

        /** The numbers of columns without and with image flags. */
        val STYLES = mapOf("sphere" to listOf(7, 10), "atomic" to listOf(5, 8))
        const val SPHERE_PLACE = 4
        const val ATOMIC_PLACE = 2
        const val VELOCITY_WIDTH = 4
        const val SPIN_WIDTH = 7
    }
}
