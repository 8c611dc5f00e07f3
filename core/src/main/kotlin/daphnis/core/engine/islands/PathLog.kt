package daphnis.core.engine.islands

import daphnis.core.collision.StepRows.Companion.STRIDE

/**
 * Pieces of path that the spheres in one worker's islands have left behind in this window, including the one with which
 * they began. A piece is named by a number ≥ 0; [NONE] ends a chain.
 */
internal class PathLog {
    private var rows = DoubleArray(INITIAL * STRIDE)
    private var links = IntArray(INITIAL)
    private var size = 0
    private var most = 0L

    /** Removes all; there may be [most] pieces from now on. */
    fun clear(most: Long) {
        size = 0
        this.most = most
    }

    /** Keeps the row at [p] of [state], which came after the piece [older], and returns its name. */
    fun add(state: DoubleArray, p: Int, older: Int): Int {
        if (size >= most) throw IslandsTooLargeException("pieces of path", most)
        if (size == links.size) {
            rows = rows.copyOf(size * 2 * STRIDE)
            // Last, since its length says how many there is room for: an allocation before it may have failed.
            links = links.copyOf(size * 2)
        }
        state.copyInto(rows, size * STRIDE, p, p + STRIDE)
        links[size] = older
        return size++
    }

    /** The array that holds the pieces; the row of one begins at [offset]. */
    fun rows(): DoubleArray = rows

    fun older(name: Int): Int = links[name]

    companion object {
        const val NONE = -1
        private const val INITIAL = 64

        fun offset(name: Int): Int = name * STRIDE
    }
}
