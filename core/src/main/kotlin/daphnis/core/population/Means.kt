package daphnis.core.population

import java.nio.ByteBuffer

/** The means around which second moments are taken, weighted by mass, and the slabs across the flow. */
internal class Means {
    /** Mean position. */
    val position = DoubleArray(3)

    /** Mean velocity without the straight flow of the boundary's rate. */
    val velocity = DoubleArray(3)

    /** By how much the straight flow of the boundary along each axis changes across it. */
    val gradient = DoubleArray(3)

    /** Number of slabs. */
    var slabCount = 1
        private set
    private var least = 0.0
    private var perSlab = 0.0

    /** Slabs for [count] particles between [least] and [greatest]. */
    fun setSlabs(count: Int, least: Double, greatest: Double) {
        slabCount = (count / FlowFit.SPHERES_A_SLAB).coerceIn(1, FlowFit.MOST_SLABS)
        this.least = least
        perSlab = if (greatest > least) slabCount / (greatest - least) else 0.0
    }

    /** The slab of a particle at [position] across the flow; the first or the last for one beyond all slabs. */
    fun slab(position: Double): Int = maxOf(0, minOf(slabCount - 1, ((position - least) * perSlab).toInt()))

    /** Writes [BYTES] for [read]. */
    fun write(into: ByteBuffer) {
        for (axis in 0..2) into.putDouble(position[axis]).putDouble(velocity[axis]).putDouble(gradient[axis])
        into.putInt(slabCount).putDouble(least).putDouble(perSlab)
    }

    /**
     * Makes these the means that [write] has written.
     *
     * @throws IllegalArgumentException for bytes that are no means
     */
    fun read(from: ByteBuffer) {
        require(from.remaining() >= BYTES) { "means are cut off" }
        for (axis in 0..2) {
            position[axis] = from.getDouble()
            velocity[axis] = from.getDouble()
            gradient[axis] = from.getDouble()
        }
        val slabs = from.getInt()
        require(slabs in 1..FlowFit.MOST_SLABS) { "means with $slabs slabs" }
        slabCount = slabs
        least = from.getDouble()
        perSlab = from.getDouble()
    }

    companion object {
        const val BYTES = 11 * Double.SIZE_BYTES + Int.SIZE_BYTES
    }
}
