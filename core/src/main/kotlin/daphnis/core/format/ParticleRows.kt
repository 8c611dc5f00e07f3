package daphnis.core.format

import daphnis.core.population.SphereQuantity
import java.util.EnumSet

/** The particles of a state in a text file, with substitutes for what the file does not have. */
internal class ParticleRows(private val size: Int) {
    val id = IntArray(size) { it }
    private val numbers = Array(SphereQuantity.EXPORTED_WIDTH) { place ->
        SphereQuantity.at(place).absent.let { value -> DoubleArray(size) { value } }
    }

    /** Quantities that the file tells. */
    val known: MutableSet<SphereQuantity> = EnumSet.of(SphereQuantity.POSITION)

    /** The columns of [quantity], to be filled. */
    operator fun get(quantity: SphereQuantity): List<DoubleArray> = quantity.places.map { numbers[it] }

    operator fun get(quantity: SphereQuantity, column: Int): DoubleArray = numbers[quantity.place + column]

    val position = this[SphereQuantity.POSITION]
    val velocity = this[SphereQuantity.VELOCITY]
    val radius = this[SphereQuantity.RADIUS][0]
    val mass = this[SphereQuantity.MASS][0]

    /** Whether the file tells [id]. */
    var hasId = false

    /** What particles are made of, in words; null where the file does not tell. */
    var species: Species.Rows? = null

    /** Names of materials, where the file says that these words are such. */
    var materials: List<String>? = null

    /** The number of the first of [species] in a file whose numbers are never names; null in others. */
    var firstSpecies: Int? = null

    /** Boxes crossed, `[axis][k]`; null where the file does not tell. */
    var image: Array<IntArray>? = null

    /**
     * The state in the order of ids, in a box that is centred on the origin.
     *
     * @param where names the line of the particle that is the k-th in the file, of the state for −1
     * @param fail refuses a box that leans in another way than sliding images do
     */
    fun snapshot(
        step: Long,
        time: Double?,
        cell: FileCell,
        where: (Int) -> String,
        fail: (String) -> Nothing,
    ): Snapshot {
        val shift = DoubleArray(3) { cell.centre(it) }
        for (axis in 0..2) if (shift[axis] != 0.0) for (k in 0 until size) position[axis][k] -= shift[axis]
        cell.normalAxis(fail)
        val lean = Lean.of(cell)
        val lengths = cell.lengths
        val periodic = cell.periodic.copyOf()
        // In two dimensions LAMMPS has a box that repeats along z, however thin it is.
        val isFlat = lean.normalAxis != 2 && periodic[2] && lengths[2] <= 2 * (radius.maxOrNull() ?: 0.0) && isInPlane()
        if (isFlat) {
            lengths[2] = Double.NaN
            periodic[2] = false
        }
        val isSorted = (1 until size).none { id[it] < id[it - 1] }
        val order = if (isSorted) IntArray(size) { it } else (0 until size).sortedBy { id[it] }.toIntArray()
        val said = species?.species(order, firstSpecies)
        val names = materials
        fun sorted(a: DoubleArray) = DoubleArray(size) { a[order[it]] }
        val snapshot = Snapshot(
            step, time ?: step.toDouble(), lengths, periodic, lean.offset, IntArray(size) { id[order[it]] },
            Array(numbers.size) { sorted(numbers[it]) }, lean.normalAxis, lean.slideAxis, known,
            image?.let { all -> Array(3) { axis -> IntArray(size) { all[axis][order[it]] } } }, time != null, shift,
            hasId, species = said, isFlat = isFlat,
        ).let { if (names == null || said == null) it else it.withMaterials(made(said, names, fail), names) }
        SnapshotCheck.check(snapshot) { k -> where(if (k < 0) k else order[k]) }
        return snapshot
    }

    private fun isInPlane() = (listOf(position[2], velocity[2]) + this[SphereQuantity.SPIN].take(2)).all { column ->
        column.all { it == 0.0 }
    }

    private fun made(said: Species, names: List<String>, fail: (String) -> Nothing): IntArray = try {
        said.numbers(names)
    } catch (e: FormatException) {
        fail(e.message.orEmpty())
    }
}

/** The words of a line in a text file as numbers, refused with the file and the line. */
internal class LineWords(private val lines: TextLines) {
    fun number(text: String): Double = text.toDoubleOrNull()?.takeIf { it.isFinite() }
        ?: lines.fail("'${TextLines.shown(text)}' must be a finite number")

    fun positive(name: String, text: String): Double =
        number(text).also { if (it <= 0) lines.fail("$name is $it; it must be > 0") }

    /** Sets [quantity] of particle [k] of [rows] from the [cells] at [columns]; −1 for those that are not there. */
    fun take(quantity: SphereQuantity, columns: IntArray, cells: List<String>, rows: ParticleRows, k: Int) {
        for ((c, at) in columns.withIndex()) {
            if (at < 0) continue
            val name = quantity.columns[c]
            rows[quantity, c][k] = if (quantity.isPositive) positive(name, cells[at]) else number(cells[at])
        }
    }

    fun id(text: String): Int = text.toIntOrNull()?.takeIf { it >= 0 }
        ?: lines.fail("id is '${TextLines.shown(text)}'; it must be a whole number in 0..${Int.MAX_VALUE}")

    /** Boxes crossed. */
    fun image(text: String): Int = text.toIntOrNull()?.takeIf { it in -MOST_IMAGES..MOST_IMAGES }
        ?: lines.fail("the image is '${TextLines.shown(text)}'; it must be a whole number within ±$MOST_IMAGES")

    /** A number of particles, if the file is long enough for so many. */
    fun count(text: String): Int {
        val n = text.trim().toIntOrNull()?.takeIf { it >= 0 }
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

        /** As many boxes can be added to it as a particle can be outside. */
        const val MOST_IMAGES = 1_000_000_000
    }
}
