package daphnis.core.format

import daphnis.core.format.Kept.Presence.IF_THERE
import daphnis.core.population.MaterialNames
import daphnis.core.population.Population
import daphnis.core.population.SphereQuantity
import java.io.IOException
import java.nio.file.Path

/**
 * A table of spheres as text: a header with `x, y, z, radius` and optionally `vx, vy, vz, mass, omegax, omegay, omegaz,
 * material, id` in any order, then one line per sphere. A table of discs may do without z, vz, omegax and omegay.
 * Materials are names, or numbers from 0 on. Lines that are empty or begin with `#` are skipped.
 */
public object ParticleCsv : ReadableFormat {
    override val title: String = "table with a header"
    override val extensions: List<String> = listOf("csv", "txt", "dat")
    override val isText: Boolean = true
    override val keeps: Kept = Kept(masses = IF_THERE, velocities = IF_THERE, ids = IF_THERE, severalStates = false)

    private val KNOWN = SphereQuantity.EXPORTED.flatMap { it.columns } + "id"
    private val NEEDED = listOf(SphereQuantity.POSITION, SphereQuantity.RADIUS).flatMap { it.columns } - "z"
    private val POSITIVE = SphereQuantity.EXPORTED.filter { it.isPositive }.flatMap { it.columns }

    /** What other programs put between cells. */
    private val SEPARATORS = listOf(';' to "semicolons", '\t' to "tabs", '|' to "bars", ' ' to "spaces")

    /**
     * Reads [path].
     *
     * @param density mass per volume where the table has no masses, of discs without z per area
     * @throws FormatException that names the line and column of the error
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun population(path: Path, density: Double = 1.0): Population = snapshot(path, density).population()

    /** Reads [path] as a state at step and time 0, masses from density 1 where it has none. */
    override fun read(path: Path, notices: MutableList<String>): List<Snapshot> = listOf(snapshot(path, 1.0))

    private fun snapshot(path: Path, density: Double): Snapshot {
        val table = try {
            TextLines(path).use { table(it, path) }
        } catch (e: IOException) {
            throw FormatException("$path: cannot be read: ${reasonOf(e, path)}")
        }
        return table.snapshot(density).also { SnapshotCheck.check(it, "$path") }
    }

    private fun table(lines: TextLines, path: Path): Table {
        var table: Table? = null
        while (true) {
            val line = (lines.next() ?: break).trim()
            if (line.isEmpty() || line.startsWith("#")) continue
            val cells = line.split(',').map { it.trim() }
            if (table == null) table = Table(header(cells, path)) else table.rows += row(cells, table, lines)
        }
        return table ?: throw FormatException("$path: is empty; a header with x, y, z (not of discs), radius is needed")
    }

    private fun header(names: List<String>, path: Path): List<String> {
        separator(names.first())?.let { throw FormatException("$path: is separated by $it; commas are needed") }
        for (name in names) {
            if (name !in KNOWN) {
                throw FormatException(
                    "$path: unknown column '${TextLines.shown(name)}'; known: ${KNOWN.joinToString()}",
                )
            }
        }
        for (name in NEEDED) {
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

    /** What separates the names of columns when it is not a comma, in words; null when the [first] cell is one name. */
    private fun separator(first: String): String? = SEPARATORS.find { (sign, _) ->
        val parts = first.split(sign).map { it.trim() }.filter { it.isNotEmpty() }
        parts.size > 1 && parts.all { it in KNOWN }
    }?.second

    private fun row(cells: List<String>, table: Table, lines: TextLines): DoubleArray {
        val names = table.names
        if (cells.size != names.size) lines.fail("${cells.size} values, the header has ${names.size}")
        return DoubleArray(cells.size) { k ->
            if (names[k] == MATERIAL) return@DoubleArray table.material(cells[k], lines).toDouble()
            val value = cells[k].toDoubleOrNull()
            val right = when {
                value == null || !value.isFinite() -> "a finite number"
                names[k] == "id" && !isId(value) -> "a whole number in 0..${Int.MAX_VALUE}"
                names[k] in POSITIVE && !(value > 0) -> "> 0"
                else -> null
            }
            if (right != null) lines.fail("${names[k]} is '${TextLines.shown(cells[k])}'; it must be $right")
            value!!
        }
    }

    private fun isId(value: Double) = value >= 0 && value <= Int.MAX_VALUE && value == Math.rint(value)

    private class Table(val names: List<String>) {
        val rows = ArrayList<DoubleArray>()

        /** Whether it can be of discs only. */
        private val isFlat = "z" !in names

        /** What stands in the column of materials, in the order in which it comes up. */
        private val words = LinkedHashMap<String, Int>()

        /** The place of [word] among them. */
        fun material(word: String, lines: TextLines): Int = words.getOrPut(word) {
            MaterialNames.problem(word)?.let { lines.fail("material is '${TextLines.shown(word)}'; it $it") }
            words.size
        }

        /** Names of materials: numbers are their own. */
        private fun names(): List<String> {
            val numbers = words.keys.map { it.toIntOrNull() ?: return words.keys.toList() }
            val most = numbers.max()
            return if (most >= MaterialNames.MOST) words.keys.toList() else List(most + 1) { "$it" }
        }

        private fun withMaterials(snapshot: Snapshot): Snapshot {
            if (words.isEmpty()) return snapshot
            val at = names.indexOf(MATERIAL)
            val said = Species(IntArray(rows.size) { rows[it][at].toInt() }, words.keys.toList())
            return names().let { snapshot.withMaterials(said.numbers(it), it) }
        }

        /** The rows in the order of ids. */
        fun snapshot(density: Double): Snapshot {
            val at = names.indexOf("id")
            if (at >= 0) rows.sortBy { it[at] }
            val known = SphereQuantity.EXPORTED.filterTo(HashSet()) { quantity ->
                quantity in NUMBERED && quantity.columns.all { it in names || isFlat && it in OUT_OF_PLANE }
            }
            val numbers = SphereQuantity.EXPORTED.flatMap { quantity ->
                quantity.columns.map { column(it, quantity.absent) }
            }.toTypedArray()
            if (SphereQuantity.MASS !in known) {
                val radius = numbers[SphereQuantity.RADIUS.place]
                numbers[SphereQuantity.MASS.place] =
                    DoubleArray(rows.size) {
                        val r = radius[it]
                        if (isFlat) density * Math.PI * r * r else density * 4.0 / 3.0 * Math.PI * r * r * r
                    }
            }
            val state = Snapshot(
                0, 0.0, DoubleArray(3) { Double.NaN }, BooleanArray(3), 0.0,
                if (at < 0) IntArray(rows.size) { it } else IntArray(rows.size) { rows[it][at].toInt() },
                numbers, NORMAL_AXIS, SLIDE_AXIS, known, hasTime = false, hasId = at >= 0, isFlat = isFlat,
            )
            return withMaterials(state)
        }

        private fun column(name: String, absent: Double): DoubleArray {
            val c = names.indexOf(name)
            return DoubleArray(rows.size) { if (c < 0) absent else rows[it][c] }
        }
    }

    private val OUT_OF_PLANE = setOf("z", "vz", "omegax", "omegay")
    private const val MATERIAL = "material"
    private const val NORMAL_AXIS = 1
    private const val SLIDE_AXIS = 0
}
