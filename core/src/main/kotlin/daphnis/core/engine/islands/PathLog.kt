package daphnis.core.engine.islands

import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.growth.GrowingTable

/**
 * Pieces of path that the spheres in one worker's islands have left behind in this window, including the one with which
 * they began. A piece is named by a number ≥ 0; [NONE] ends a chain.
 */
internal class PathLog : GrowingTable() {
    private var rows = DoubleArray(0)
    private var links = IntArray(0)
    private var most = 0L

    override fun resize(room: Int) {
        rows = rows.copyOf(room * STRIDE)
        links = links.copyOf(room)
    }

    /** Removes all; there may be [most] pieces from now on. */
    fun clear(most: Long) {
        clear()
        this.most = most
    }

    /** Keeps the row at [p] of [state], which came after the piece [older], and returns its name. */
    fun add(state: DoubleArray, p: Int, older: Int): Int {
        if (size >= most) throw IslandsTooLargeException("pieces of path", most)
        val k = append()
        state.copyInto(rows, k * STRIDE, p, p + STRIDE)
        links[k] = older
        return k
    }

    /** The array that holds the pieces; the row of one begins at [offset]. */
    fun rows(): DoubleArray = rows

    fun older(name: Int): Int = links[name]

    companion object {
        const val NONE = -1

        fun offset(name: Int): Int = name * STRIDE
    }
}
