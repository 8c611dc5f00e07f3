package daphnis.core.engine.islands

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.growth.GrowingTable

/**
 * The spheres in one worker's islands: copies of their rows with their present states, and the paths which they have
 * left in this window. Addressed by **place**, in the order in which they joined. Written by the worker; read by other
 * workers when all islands are done.
 */
internal class Members : GrowingTable() {
    val rows = StepRows()
    val paths = PathLog()
    private var slotOf = IntArray(0)
    private var older = IntArray(0)

    override fun resize(room: Int) {
        slotOf = slotOf.copyOf(room)
        older = older.copyOf(room)
    }

    /** Removes all; there may be as many pieces of path as [limits] allow. */
    fun clear(limits: IslandLimits) {
        clear()
        rows.clear()
        paths.clear(limits.pieces)
    }

    /** Takes over [slot] of [state] and returns its place. */
    fun take(state: StepRows, slot: Int): Int {
        ensure(size + 1)
        // The last that can fail.
        rows.take(state, slot)
        val k = append()
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
}
