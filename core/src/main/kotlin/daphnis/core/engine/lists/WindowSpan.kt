package daphnis.core.engine.lists

/**
 * How long windows are: so long that threads do not wait for one another all the time, and so short that few collisions
 * are left to one thread where regions meet. Any length gives the same bits.
 */
internal class WindowSpan {
    /** Collisions per sphere that a window should have, and those in a unit of time as seen last. */
    private var wanted = FIRST
    private var rate = 0.0

    /** Length of the last window. */
    private var last = Double.POSITIVE_INFINITY

    /**
     * The end of a window that begins at [start] in a step of [duration], in which no sphere that is as fast as
     * [fastest] goes farther than [farthest].
     */
    fun endOf(start: Double, duration: Double, fastest: Double, farthest: Double): Double {
        val byRate = if (rate > 0) wanted / rate else duration / FIRST_PART
        val length = minOf(byRate, MOST_GROWTH * last, farthest / (fastest * ROOM))
        val windows = Math.ceil((duration - start) / length - TINY)
        return if (windows <= 1) duration else start + (duration - start) / windows
    }

    /** Told that a window of [length] had so many [collisions] per sphere, so many of which, in all rounds, were taken [between] regions. */
    fun learn(length: Double, collisions: Double, between: Double) {
        last = length
        rate = collisions / length
        if (collisions <= 0) return
        val share = between / collisions
        if (share > MOST_BETWEEN) {
            wanted = maxOf(wanted * SHORTER, LEAST)
        } else if (share < FEW_BETWEEN) {
            wanted = minOf(wanted * LONGER, MOST)
        }
    }

    private companion object {
        const val FIRST = 0.05
        const val FIRST_PART = 16.0
        const val MOST_GROWTH = 2.0
        const val ROOM = 1.5
        const val TINY = 1e-9
        const val LEAST = 0.01
        const val MOST = 0.5
        const val MOST_BETWEEN = 0.3
        const val FEW_BETWEEN = 0.2
        const val SHORTER = 0.8
        const val LONGER = 1.1
    }
}
