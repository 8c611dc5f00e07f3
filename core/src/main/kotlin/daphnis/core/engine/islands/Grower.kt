package daphnis.core.engine.islands

import daphnis.core.engine.islands.IslandBoard.Companion.FREE
import daphnis.core.step.Impact

/**
 * Grows the islands of one worker: processes each from its seeds to the end of the window, on copies of its rows.
 *
 * @param island the island that it grows
 */
internal class Grower(private val field: IslandField, private val stores: WorkerStores, private val island: Island) :
    Impact(field.prepared, stores.members.rows, island) {
    private val board = field.board
    private val members = stores.members
    private val queue = island.queue

    /**
     * Processes the island of [root].
     *
     * @return false when it was given up: the step is void or has failed, or the island needs a sphere that was
     *   [refused][Island.refused]; in that case everything is as if it had not been tried
     */
    fun grow(root: Int): Boolean {
        val index = stores.attempts.begin(members.size, stores.tried.size, counted)
        island.begin(root, index)
        val isDone = processAll()
        stores.attempts.end(members.size, stores.tried.size, counted)
        if (island.refused != FREE) {
            stores.attempts.drop(index)
            giveBack(index)
        }
        return isDone
    }

    private fun processAll(): Boolean {
        var collisions = 0L
        while (queue.pop()) {
            field.limits.checkIsland(++collisions, queue.store.size)
            if (field.stopped) return false
            val first = queue.first
            val second = queue.second
            members.leaveBehind(first)
            if (second >= 0) members.leaveBehind(second)
            val end = process(queue.time, first, second, queue.image)
            if (end == End.OUTRUN) field.outran(rows, first, second)
            if (end != End.DONE) return false
        }
        return true
    }

    override fun slotOf(place: Int): Int = members.slot(place)

    override fun search(place: Int, except: Int): Boolean {
        // The marks on this island's spheres, and the bounds that were widened for them.
        board.announce()
        return super.search(place, except) && island.refused == FREE
    }

    /** Undoes attempt [index], as if it had not been made. */
    fun giveBack(index: Int) {
        for (k in stores.attempts.firstRow(index) until stores.attempts.endOfRows(index)) {
            board.giveBack(members.slot(k), members.firstTime(k))
        }
    }
}
