package daphnis.analysis.input

import daphnis.core.format.Snapshot
import kotlin.math.abs

/**
 * Whether places along one axis of [states], which repeat there, go on beyond the box. Where the box begins is not
 * known: it is judged by how far the places reach and by how they jump, in edges of the box.
 *
 * @param ids of the particles that are in every state, ascending
 */
internal class Unwrapping private constructor(states: List<Snapshot>, private val axis: Int, ids: IntArray) {
    private var low = Double.POSITIVE_INFINITY
    private var high = Double.NEGATIVE_INFINITY

    /** Displacements from a state to the next; those of more than half a box; those of nearly one. */
    private var moves = 0L
    private var jumps = 0L
    private var boxes = 0L

    init {
        val told = states.filter { it.periodic[axis] && it.lengths[axis] > 0 }
        for (state in told) {
            for (k in 0 until state.size) {
                val place = place(state, k)
                if (place < low) low = place
                if (place > high) high = place
            }
        }
        for (k in 1 until told.size) follow(told[k - 1], told[k], ids)
    }

    private fun follow(a: Snapshot, b: Snapshot, ids: IntArray) {
        for (id in ids) {
            val from = place(a, java.util.Arrays.binarySearch(a.id, id))
            val moved = abs(place(b, java.util.Arrays.binarySearch(b.id, id)) - from)
            moves++
            if (moved > 0.5) jumps++
            if (moved in 1 - NEAR..1 + NEAR) boxes++
        }
    }

    private fun place(state: Snapshot, k: Int): Double = state.position[axis][k] / state.lengths[axis]

    /** Some place is not in a box that is centred. */
    private val isOutside get() = low < -0.5 || high > 0.5

    /** In all states together they reach over far more than a box, and not because a few jump by a box each. */
    private val isBeyond get() = high - low > FAR && !(jumps > 0 && jumps < moves / 2 && boxes >= MOST * jumps)

    companion object {
        /**
         * Whether places in [states] are unwrapped, where no image says: along some axis they reach over far more than a
         * box, or some are outside and none jumps by more than half a box, so that displacements are their differences.
         * Along an edge that leans places reach beyond a box, and jump, in any case, so the other axes tell.
         */
        fun isIn(states: List<Snapshot>, ids: IntArray): Boolean {
            if (states.any { it.image != null }) return false
            val axes = (0..2).filter { axis ->
                states.none { it.slidesAlong(axis) }
            }.map { Unwrapping(states, it, ids) }
            return axes.any { it.isBeyond } || axes.any { it.isOutside } && axes.all { it.jumps == 0L }
        }

        private fun Snapshot.slidesAlong(axis: Int) = axis == slideAxis && shearOffset != 0.0 && periodic[normalAxis]

        /** Edges up to which places that jump may be those of a box and a little beyond. */
        private const val FAR = 1.5
        private const val NEAR = 0.25
        private const val MOST = 0.9
    }
}
