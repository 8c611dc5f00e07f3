package daphnis.core.format

import java.nio.file.Path

/** The particles of an H5MD file in [frames] frames. */
internal class H5mdParticles(
    private val source: H5Source,
    private val all: String,
    private val path: Path,
    private val frames: Long,
) {
    private val shape = source.shape("$all/position/value").also { shape ->
        if (shape.size != 3 || shape[0] != frames || shape[2] != 3L) {
            throw FormatException("$path: $all/position/value has the shape $shape; it must be [$frames, particles, 3]")
        }
    }

    private val hasId = source.has("$all/id")
    private val hasMass = source.has("$all/mass")
    private val hasRadius = source.has("$all/radius")

    // What is declared is compared with the size of the file before the number of particles is used.
    private val id = if (hasId) valued("id") { name, its -> source.ints(name, its, 0..Int.MAX_VALUE) } else null
    private val mass = if (hasMass) valued("mass", source::doubles) else null
    private val radius = if (hasRadius) valued("radius", source::doubles) else null
    private val position = source.doubles("$all/position/value", shape)
    private val count = Math.toIntExact(shape[1])
    private val velocity = if (source.has("$all/velocity")) source.doubles("$all/velocity/value", shape) else null
    private val image = if (source.has("$all/image")) source.ints("$all/image/value", shape, ANY) else null

    /** What a file holds once, or for each frame. */
    private class Valued<A>(val data: A, val isByFrame: Boolean)

    private fun <A> valued(part: String, read: (String, List<Long>) -> A): Valued<A> {
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
            step, time, lengths, periodic, lean.offset, IntArray(0), Array(3) { DoubleArray(0) },
            Array(3) { DoubleArray(0) }, DoubleArray(0), DoubleArray(0), lean.normalAxis, lean.slideAxis,
            hasTime = hasTime,
        )
    }

    /** Frame [t], particles in the order of their ids. */
    fun state(t: Int, head: Head): Snapshot {
        val ids = IntArray(count) { k -> id?.let { it.data[at(it.isByFrame, t, k)] } ?: k }
        val isSorted = (1 until count).none { ids[it] < ids[it - 1] }
        val order = if (isSorted) IntArray(count) { it } else (0 until count).sortedBy { ids[it] }.toIntArray()
        fun column(data: DoubleArray?, axis: Int) = DoubleArray(count) { data?.get(cube(t, order[it], axis)) ?: 0.0 }
        fun single(of: Valued<DoubleArray>?, otherwise: Double) =
            DoubleArray(count) { k -> of?.let { it.data[at(it.isByFrame, t, order[k])] } ?: otherwise }
        return Snapshot(
            head.step, head.time, head.lengths, head.periodic, head.lean.offset, IntArray(count) { ids[order[it]] },
            Array(3) { column(position, it) }, Array(3) { column(velocity, it) },
            single(radius, RADIUS), single(mass, 1.0), head.lean.normalAxis, head.lean.slideAxis, hasMass, hasRadius,
            image?.let { data -> Array(3) { axis -> IntArray(count) { data[cube(t, order[it], axis)] } } },
            head.hasTime, head.shift, velocity != null,
        )
    }

    private fun at(isByFrame: Boolean, t: Int, k: Int) = if (isByFrame) t * count + k else k

    private fun cube(t: Int, k: Int, axis: Int) = 3 * (t * count + k) + axis

    private companion object {
        val ANY = Int.MIN_VALUE..Int.MAX_VALUE

        /** The part of the particles that may be outside a box in its first frame. */
        const val MOST_OUTSIDE = 0.05

        /** In place of radii that a file does not have. */
        const val RADIUS = 0.5
    }
}
