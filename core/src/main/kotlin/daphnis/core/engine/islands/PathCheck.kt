package daphnis.core.engine.islands

import daphnis.core.growth.IntList

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
            // What the pair remembers does not change while the two are in different islands.
            state = field.prepared.stateOf(field.rows, slot, field.rows, other)
            if (!pathsTouch(board.place(slot), other, suspects.image(k))) continue
            islands.add(board.owner(slot))
            others.add(board.owner(other))
        }
    }

    /** Of the pair whose paths are compared. */
    private var state = 0

    // Walk back along the two paths; the third goes on ahead of the second.
    private val mine = PathWalk()
    private val theirs = PathWalk()
    private val further = PathWalk()

    /**
     * Whether any new piece of the path at place [k] touches any piece of that of [other] within the window. Both walks
     * go from the newest piece to the oldest, and pieces without a common time are skipped, so this takes as many
     * comparisons as the two paths have pieces.
     */
    private fun pathsTouch(k: Int, other: Int, image: Int): Boolean {
        mine.begin(own, k, field.windowEnd)
        val attempt = board.attempt(other)
        if (attempt == 0) {
            theirs.begin(field.rows, other, field.windowEnd)
        } else {
            theirs.begin(membersOf(board.workerOf(attempt)), board.place(other), field.windowEnd)
        }
        // The oldest piece is the path at the start. It was compared with the other spheres' paths at the start when
        // seeds were made, and is compared with their later pieces from their side.
        while (!mine.isOldest) {
            if (touches(image)) return true
            mine.goBack()
        }
        return false
    }

    /** Whether the present piece of [mine] touches any piece of [theirs]. */
    private fun touches(image: Int): Boolean {
        // A piece that begins only after this piece ends also begins after the end of all older ones.
        while (theirs.start > mine.end) {
            if (theirs.isOldest) return false
            theirs.goBack()
        }
        further.begin(theirs)
        while (true) {
            val t = field.prepared.meetingTime(state, mine.state, mine.row, further.state, further.row, image)
            if (t <= mine.end && t <= further.end) return true
            if (further.isOldest || further.start < mine.start) return false
            further.goBack()
        }
    }
}
