package daphnis.core.engine.islands

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.isUnknown
import daphnis.core.engine.islands.IslandBoard.Companion.FREE
import daphnis.core.queue.EventHeap
import daphnis.core.queue.Schedule

/**
 * The island that a worker is growing: its spheres, addressed by their place among the worker's members, and its queue.
 * Their potential collisions in this window are queued, and spheres of no island that they can hit join. What lies
 * beyond the window becomes a hint. A sphere that belongs to another island becomes a suspect.
 *
 * @param number the number of the worker
 */
internal class Island(private val field: IslandField, private val number: Int, private val stores: WorkerStores) :
    Schedule {
    private val board = field.board
    private val hints = stores.hints
    private val members = stores.members

    /** The potential collisions of its spheres in this window. */
    val queue = EventHeap()

    /** Which spheres may join; null for any. */
    var claimRule: ClaimRule? = null

    /** A sphere that the island needed and that [claimRule] refused, −1 when there was none. */
    var refused = FREE
        private set

    private var root = FREE
    private var attempt = 0
    private var index = 0

    /** Begins with the spheres of the seeds of [root]; this is attempt [index] of the worker. */
    fun begin(root: Int, index: Int) {
        this.root = root
        this.index = index
        attempt = board.attemptNumber(number, index)
        refused = FREE
        queue.reset(field.windowEnd, members.rows.id, 0)
        val seeds = board.seeds.store
        var s = board.firstSeed(root)
        while (s != FREE) {
            val first = join(seeds.first(s))
            val second = seeds.second(s)
            queue.add(seeds.time(s), first, if (second < 0) second else join(second), seeds.image(s))
            s = seeds.link(s)
        }
    }

    /** Takes [slot], which the island owns, into its rows, and returns its place there. */
    private fun join(slot: Int): Int {
        if (board.attempt(slot) == attempt) return board.place(slot)
        val k = members.take(field.rows, slot)
        board.take(slot, root, attempt, k)
        queue.include(k, members.rows.id)
        return k
    }

    /**
     * Notes that the sphere at place [first] can touch [second], a slot or a wall's partner number, at [time], which is
     * [UNKNOWN][StepRows.UNKNOWN] when an island, perhaps this one, has the sphere in that slot.
     */
    override fun add(time: Double, first: Int, second: Int, image: Int) {
        when {
            isUnknown(time) -> addTaken(first, second, image)
            time > field.windowEnd -> hints.add(time, members.slot(first), second, image)
            second < 0 -> queue.add(time, first, second, image)
            else -> addFree(time, first, second, image)
        }
    }

    /** A sphere that an island has. */
    private fun addTaken(first: Int, slot: Int, image: Int) {
        if (board.owner(slot) == root) addOwn(first, slot, image) else suspect(first, slot, image)
    }

    /** A sphere that no island had: it joins, unless that is refused or another island is quicker. */
    private fun addFree(time: Double, first: Int, slot: Int, image: Int) {
        if (claimRule?.mayClaim(slot) == false) {
            refused = slot
        } else if (board.claim(slot, root)) {
            queue.add(time, first, join(slot), image)
        } else {
            suspect(first, slot, image)
        }
    }

    /** A sphere of another island: what it does in this window is not known yet. */
    private fun suspect(first: Int, slot: Int, image: Int) {
        stores.suspects.add(members.slot(first), slot, image, index)
    }

    /** A sphere of this island, which is at its own place among the members. */
    private fun addOwn(first: Int, slot: Int, image: Int) {
        val second = board.place(slot)
        val t = field.prepared.meetingTime(members.rows, first, members.rows, second, image)
        if (t <= field.windowEnd) {
            queue.add(t, first, second, image)
        } else if (t <= field.prepared.duration) {
            hints.add(t, members.slot(first), slot, image)
        }
    }

    override fun removeAllOf(slot: Int) {
        queue.removeAllOf(slot)
    }
}
