package daphnis.core.engine.islands

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME

/**
 * The spheres in one worker's islands: copies of their rows with their present states, and the paths which they have
 * left in this window. Addressed by **place**, in the order in which they joined. Written by the worker; read by other
 * workers when all islands are done.
 */
internal class Members {
    val rows = StepRows()
    val paths = PathLog()
    private var slotOf = IntArray(INITIAL)
    private var older = IntArray(INITIAL)

    val size: Int get() = rows.size

    /** Removes all; there may be as many pieces of path as [limits] allow. */
    fun clear(limits: IslandLimits) {
        rows.clear()
        paths.clear(limits.pieces)
    }

    /** Takes over [slot] of [state] and returns its place. */
    fun take(state: StepRows, slot: Int): Int {
        val k = rows.take(state, slot)
        if (k == slotOf.size) {
            older = older.copyOf(k * 2)
            // Last, since its length says how many there is room for: an allocation before it may have failed.
            slotOf = slotOf.copyOf(k * 2)
        }
        slotOf[k] = slot
        older[k] = PathLog.NONE
        return k
    }

    fun slot(k: Int): Int = slotOf[k]

    /** The piece of path before the present one, [PathLog.NONE] when the sphere is still on the one it came with. */
    fun older(k: Int): Int = older[k]

    /** Keeps the present path of the sphere at place [k], which is about to take another. */
    fun leaveBehind(k: Int) {
        older[k] = paths.add(rows.state, k * STRIDE, older[k])
    }

    /** Local time with which the sphere at place [k] came. */
    fun firstTime(k: Int): Double {
        var time = rows.state[k * STRIDE + TIME]
        var piece = older[k]
        while (piece != PathLog.NONE) {
            time = paths.rows()[PathLog.offset(piece) + TIME]
            piece = paths.older(piece)
        }
        return time
    }

    private companion object {
        const val INITIAL = 256
    }
}
