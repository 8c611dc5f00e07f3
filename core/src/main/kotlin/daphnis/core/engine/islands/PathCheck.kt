package daphnis.core.engine.islands

import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.contactTime

/**
 * Compares the paths of one worker's suspects when all islands are done, and notes which islands touch.
 *
 * @param membersOf the members of a worker, by its number
 */
internal class PathCheck(
    private val field: IslandField,
    private val stores: WorkerStores,
    private val membersOf: (Int) -> Members,
) {
    private val board = field.board
    private val suspects = stores.suspects
    private val own = stores.members
    private val islands = IntList()
    private val others = IntList()

    /** Number of pairs of islands that touch. */
    val count: Int get() = islands.size

    /** Root of the one island of pair [k]. */
    fun island(k: Int): Int = islands[k]

    /** Root of the other island of pair [k]; −1 for a sphere of no island. */
    fun other(k: Int): Int = others[k]

    fun run() {
        islands.clear()
        others.clear()
        for (k in 0 until suspects.size) {
            if (!stores.attempts.isAlive(suspects.attempt(k))) continue
            val slot = suspects.slot(k)
            val other = suspects.other(k)
            if (!pathsTouch(board.place(slot), other, suspects.image(k))) continue
            islands.add(board.owner(slot))
            others.add(board.owner(other))
        }
    }

    /**
     * Whether any new piece of the path at place [k] touches any piece of that of [other] within the window. Both
     * chains go from the newest piece to the oldest, and pieces without a common time are skipped, so this takes as
     * many comparisons as the two chains have pieces.
     */
    private fun pathsTouch(k: Int, other: Int, image: Int): Boolean {
        var state = own.rows.state
        var p = k * STRIDE
        var end = field.windowEnd
        var older = own.older(k)
        begin(other)
        // The last piece of the chain is the path at the start. It was compared with the other spheres' paths at the
        // start when seeds were made, and is compared with their later pieces from their side.
        while (older != PathLog.NONE) {
            if (touches(state, p, end, image)) return true
            end = state[p + TIME]
            state = own.paths.rows()
            p = PathLog.offset(older)
            older = own.paths.older(older)
        }
        return false
    }

    // The other sphere's newest piece that has begun before the own present piece ends. A sphere of no island has only
    // one piece.
    private var otherMembers: Members? = null
    private var otherState = DoubleArray(0)
    private var otherRow = 0
    private var otherEnd = 0.0
    private var otherOlder = PathLog.NONE

    private fun begin(other: Int) {
        otherEnd = field.windowEnd
        val attempt = board.attempt(other)
        if (attempt == 0) {
            otherMembers = null
            otherState = field.rows.state
            otherRow = other * STRIDE
            otherOlder = PathLog.NONE
        } else {
            val members = membersOf(board.workerOf(attempt))
            val place = board.place(other)
            otherMembers = members
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
        // A piece that begins only after this piece ends also begins after the end of all older ones.
        while (otherState[otherRow + TIME] > end) {
            val older = otherOlder
            if (older == PathLog.NONE) return false
            val paths = otherMembers!!.paths
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
            b = otherMembers!!.paths.rows()
            q = PathLog.offset(older)
            older = otherMembers!!.paths.older(older)
        }
    }
}
