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

    /**
     * Whether any new piece of the path at place [k] touches any piece of that of [other] within the window. Both
     * chains go from the newest piece to the oldest, and pieces that are not flown at the same time are passed over, so
     * that this takes as many looks as the two have pieces.
     */
    private fun pathsTouch(k: Int, other: Int, image: Int): Boolean {
        var state = own.rows.state
        var p = k * STRIDE
        var end = field.windowEnd
        var older = own.older(k)
        begin(other)
        // The last of the chain is what it began with; that was compared with the others' beginnings when seeds were
        // made, and with what they did since from their side.
        while (older != PathLog.NONE) {
            if (touches(state, p, end, image)) return true
            end = state[p + TIME]
            state = own.paths.rows()
            p = PathLog.offset(older)
            older = own.paths.older(older)
        }
        return false
    }

    // The other's newest piece that has begun before the own piece at hand ends; who belongs to no island has but one.
    private var others: Members? = null
    private var otherState = DoubleArray(0)
    private var otherRow = 0
    private var otherEnd = 0.0
    private var otherOlder = PathLog.NONE

    private fun begin(other: Int) {
        otherEnd = field.windowEnd
        val attempt = field.attempt(other)
        if (attempt == 0) {
            others = null
            otherState = field.rows.state
            otherRow = other * STRIDE
            otherOlder = PathLog.NONE
        } else {
            val members = membersOf(field.workerOf(attempt))
            val place = field.place(other)
            others = members
            otherState = members.rows.state
            otherRow = place * STRIDE
            otherOlder = members.older(place)
        }
    }

    /**
     * Whether the piece of path in the row at [p] of [state], which ends at [end], touches any piece of the other's.
     */
    private fun touches(state: DoubleArray, p: Int, end: Double, image: Int): Boolean {
        val images = field.grid.images
        // Who has begun only after this piece ends has also begun after all older ones.
        while (otherState[otherRow + TIME] > end) {
            val older = otherOlder
            if (older == PathLog.NONE) return false
            val paths = others!!.paths
            otherEnd = otherState[otherRow + TIME]
            otherState = paths.rows()
            otherRow = PathLog.offset(older)
            otherOlder = paths.older(older)
        }
        val begin = state[p + TIME]
        var b = otherState
        var q = otherRow
        var endThere = otherEnd
        var older = otherOlder
        while (true) {
            val t = contactTime(state, p, b, q, image, images)
            if (t <= end && t <= endThere) return true
            if (older == PathLog.NONE) return false
            endThere = b[q + TIME]
            if (endThere < begin) return false
            b = others!!.paths.rows()
            q = PathLog.offset(older)
            older = others!!.paths.older(older)
        }
    }

    private companion object {
        const val INITIAL = 64
    }
}
