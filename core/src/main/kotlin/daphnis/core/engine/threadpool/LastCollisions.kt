package daphnis.core.engine.threadpool

import daphnis.core.collision.StepRows.Companion.STRIDE

/**
 * What each sphere was before its last collision. A row is written by the worker that processes the sphere, and is read
 * under the same rule as the state.
 */
internal class LastCollisions {
    /** Rows like those of the step; meaningful for spheres that have collided. */
    var rows = DoubleArray(0)
        private set

    /** By slot: how often it has collided at time 0, where the local time does not tell: 0, 1, or 2 for more often. */
    var atZero = ByteArray(0)
        private set

    /** Whether the last collision was taken before its turn. */
    var early = BooleanArray(0)
        private set

    /** Slot of the partner in the last collision, negative for a wall. */
    var partner = IntArray(0)
        private set

    fun reset(size: Int) {
        if (atZero.size < size) {
            early = BooleanArray(size)
            partner = IntArray(size)
            rows = DoubleArray(size * STRIDE)
            atZero = ByteArray(size)
        } else {
            atZero.fill(0)
        }
    }
}
