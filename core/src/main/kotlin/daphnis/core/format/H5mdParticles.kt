package daphnis.core.format

import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereQuantity
import java.nio.file.Path

/**
 * The particles of an H5MD file in [frames] frames.
 *
 * @param materials names of what the numbers of species mean, empty in files of others
 */
internal class H5mdParticles(
    private val source: H5Source,
    private val all: String,
    private val path: Path,
    private val frames: Long,
    private val materials: List<String>,
) {
    private val shape = source.shape("$all/position/value").also { shape ->
        if (shape.size != 3 || shape[0] != frames || shape[2] != 3L) {
            throw FormatException("$path: $all/position/value has the shape $shape; it must be [$frames, particles, 3]")
        }
    }

    // What is declared is compared with the size of the file before the number of particles is used.
    private val id = valued("id") { name, its -> source.ints(name, its, 0..Int.MAX_VALUE) }
    private val numbers = H5md.FIXED.associateWith { valued(it.title, source::doubles) }
    private val count = Math.toIntExact(shape[1])
    private val vectors = H5md.CHANGING.filter { source.has("$all/${it.title}") }.associateWith {
        source.doubles("$all/${it.title}/value", if (it.columns.size == 1) shape.take(2) else shape)
    }
    private val position = vectors.getValue(SphereQuantity.POSITION)
    private val image = if (source.has("$all/image")) source.ints("$all/image/value", shape, ANY) else null

    private val species = species()

    /** Of files of others there may be none, or words in place of numbers, which are not looked for. */
    private fun species(): Valued<IntArray>? = try {
        valued(H5md.SPECIES) { name, its -> source.ints(name, its, ANY) }
    } catch (e: FormatException) {
        if (materials.isEmpty()) null else throw e
    }

    /** What a file holds once, or for each frame. */
    private class Valued<A>(val data: A, val isByFrame: Boolean)

    private fun <A> valued(part: String, read: (String, List<Long>) -> A): Valued<A>? {
        if (!source.has("$all/$part")) return null
        val isByFrame = source.has("$all/$part/value")
        if (!isByFrame) return Valued(read("$all/$part", listOf(shape[1])), false)
        return Valued(read("$all/$part/value", shape.take(2)), true)
    }

    /**
     * Moves particles that are between 0 and the edge of a box, whether or not it repeats, so that it is centred on the
     * origin. In the first frame some may be a hair outside; later they may go on beyond the box.
     *
     * @return what was taken off by frame and axis
     */
    fun centre(cells: List<FileCell>): List<DoubleArray> {
        val shifts = cells.map { DoubleArray(3) }
        for (axis in 0..2) {
            if (cells.any { !(it.lengths[axis] > 0) }) continue
            if (!isFromZero(axis) { cells[it].edges[axis][axis] }) continue
            for (t in cells.indices) {
                val half = cells[t].edges[axis][axis] / 2
                shifts[t][axis] = half
                for (k in 0 until count) position[cube(t, k, axis)] -= half
            }
        }
        return shifts
    }

    private inline fun isFromZero(axis: Int, length: (Int) -> Double): Boolean {
        val outside = (0 until count).count { position[cube(0, it, axis)] !in 0.0..length(0) }
        if (outside > count * MOST_OUTSIDE) return false
        return (0 until frames.toInt()).any { t ->
            (0 until count).any { position[cube(t, it, axis)] in length(t) / 2..length(t) }
        }
    }

    /** What a frame is besides its particles. */
    class Head(
        val step: Long,
        val time: Double,
        val hasTime: Boolean,
        val lengths: DoubleArray,
        val periodic: BooleanArray,
        val lean: Lean,
        val shift: DoubleArray,
    ) {
        /** The state without a particle. */
        fun empty(): Snapshot = Snapshot(
            step, time, lengths, periodic, lean.offset, IntArray(0), Array(SphereQuantity.EXPORTED_WIDTH) { NONE },
            lean.normalAxis, lean.slideAxis,
            SphereQuantity.EXPORTED.filterTo(HashSet()) {
                !it.isOptional
            },
            hasTime = hasTime,
        )
    }

    /** Frame [t], particles in the order of their ids. */
    fun state(t: Int, head: Head): Snapshot {
        val ids = IntArray(count) { k -> id?.let { it.data[at(it.isByFrame, t, k)] } ?: k }
        val isSorted = (1 until count).none { ids[it] < ids[it - 1] }
        val order = if (isSorted) IntArray(count) { it } else (0 until count).sortedBy { ids[it] }.toIntArray()
        fun column(quantity: SphereQuantity, c: Int): DoubleArray {
            val vector = vectors[quantity]
            val number = numbers[quantity]
            return when {
                vector != null -> DoubleArray(count) { vector[quantity.columns.size * (t * count + order[it]) + c] }
                number != null -> DoubleArray(count) { number.data[at(number.isByFrame, t, order[it])] }
                else -> PopulationColumns.absent(quantity.place + c, count)
            }
        }
        val made = species?.let { said ->
            Species.Rows(count).also { for (k in 0 until count) it.put(k, "${said.data[at(said.isByFrame, t, k)]}") }
                .species(order, numberedFrom = 0)
        }
        val state = Snapshot(
            head.step, head.time, head.lengths, head.periodic, head.lean.offset, IntArray(count) { ids[order[it]] },
            SphereQuantity.EXPORTED.flatMap { it.columns.indices.map { c -> column(it, c) } }.toTypedArray(),
            head.lean.normalAxis, head.lean.slideAxis, vectors.keys + numbers.filterValues { it != null }.keys,
            image?.let { data -> Array(3) { axis -> IntArray(count) { data[cube(t, order[it], axis)] } } },
            head.hasTime, head.shift, id != null, species = made,
        )
        return if (materials.isEmpty() ||
            made == null
        ) {
            state
        } else {
            state.withMaterials(made.numbers(materials), materials)
        }
    }

    private fun at(isByFrame: Boolean, t: Int, k: Int) = if (isByFrame) t * count + k else k

    private fun cube(t: Int, k: Int, axis: Int) = 3 * (t * count + k) + axis

    private companion object {
        val ANY = Int.MIN_VALUE..Int.MAX_VALUE

        /** The part of the particles that may be outside a box in its first frame. */
        const val MOST_OUTSIDE = 0.05
        val NONE = DoubleArray(0)
    }
}
