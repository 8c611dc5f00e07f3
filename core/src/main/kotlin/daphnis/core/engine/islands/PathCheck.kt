package daphnis.core.engine.islands

import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.contactTime

/**
 * Compares the paths of one worker's [suspects] when all islands are done, and notes which islands touch.
 *
 * @param membersOf the members of any worker
 */
internal class PathCheck(
    private val field: IslandField,
    private val own: Members,
    private val attempts: Attempts,
    private val suspects: Suspects,
    private val membersOf: (Int) -> Members,
) {
    /** Pairs of roots whose islands touch, one after the other; the second is −1 for a sphere of no island. */
    var conflicts = IntArray(INITIAL)
        private set

    /** Number of pairs. */
    var count = 0
        private set

    fun run() {
        count = 0
        for (k in 0 until suspects.size) {
            if (!attempts.isAlive(suspects.attempt(k))) continue
            val slot = suspects.slot(k)
            val other = suspects.other(k)
            if (!pathsTouch(field.place(slot), other, suspects.image(k))) continue
            if (count * 2 == conflicts.size) conflicts = conflicts.copyOf(conflicts.size * 2)
            conflicts[count * 2] = field.owner(slot)
            conflicts[count * 2 + 1] = field.owner(other)
            count++
        }
    }

    /** Whether any new piece of the path at place [k] touches any piece of that of [other] within the window. */
    private fun pathsTouch(k: Int, other: Int, image: Int): Boolean {
        var state = own.rows.state
        var p = k * STRIDE
        var end = field.windowEnd
        var older = own.older(k)
        // The last of the chain is what it began with; that was compared with the others' beginnings when seeds were made, and with what they
        // did since from their side.
        while (older != PathLog.NONE) {
            if (touches(state, p, end, other, image)) return true
            end = state[p + TIME]
            state = own.paths.rows()
            p = PathLog.offset(older)
            older = own.paths.older(older)
        }
        return false
    }

    /** Whether the piece of path in the row at [p] of [state], which ends at [end], touches any piece of that of [other]. */
    private fun touches(state: DoubleArray, p: Int, end: Double, other: Int, image: Int): Boolean {
        val images = field.grid.images
        val attempt = field.attempt(other)
        if (attempt == 0) return contactTime(state, p, field.rows.state, other * STRIDE, image, images) <= end
        val members = membersOf(field.workerOf(attempt))
        val k = field.place(other)
        var otherState = members.rows.state
        var q = k * STRIDE
        var otherEnd = field.windowEnd
        var older = members.older(k)
        while (true) {
            val t = contactTime(state, p, otherState, q, image, images)
            if (t <= end && t <= otherEnd) return true
            if (older == PathLog.NONE) return false
            otherEnd = otherState[q + TIME]
            otherState = members.paths.rows()
            q = PathLog.offset(older)
            older = members.paths.older(older)
        }
    }

    private companion object {
        const val INITIAL = 64
    }
}
