package daphnis.core.engine.horizon

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord
import daphnis.core.growth.GrowingTable
import daphnis.core.growth.IntList

/**
 * What a group's spheres have done to one another in the present step, so that a part of it can be dropped: spheres
 * that have collided are of one **cluster**, whose members are a ring of places. All is addressed by place, as in
 * [GroupSpheres].
 */
internal class GroupPaths : GrowingTable() {
    private var parent = IntArray(0)
    private var ring = IntArray(0)

    /** The last piece of the path, see [Trails]; [NONE] for a sphere that has not collided. */
    private var piece = IntArray(0)
    private var isDropped = BooleanArray(0)

    /** The collisions that count, in order: place of one sphere, entry of the record, and whether it was guarded. */
    private class Hits : GrowingTable() {
        var places = IntArray(0)
            private set
        var entries = IntArray(0)
            private set
        var guarded = BooleanArray(0)
            private set

        override fun resize(room: Int) {
            places = places.copyOf(room)
            entries = entries.copyOf(room)
            guarded = guarded.copyOf(room)
        }

        fun add(place: Int, entry: Int, isGuarded: Boolean) {
            val k = append()
            places[k] = place
            entries[k] = entry
            guarded[k] = isGuarded
        }
    }

    private val hits = Hits()
    private var noted = 0L
    private var notedGuards = 0L

    /** Entries of the record so far. */
    private var notedEntries = 0

    /** The reflections at walls: place of the sphere, and entry of the record; [NONE] where it has none. */
    private val bounces = IntList()
    private val bounceEntries = IntList()

    override fun resize(room: Int) {
        parent = parent.copyOf(room)
        ring = ring.copyOf(room)
        piece = piece.copyOf(room)
        isDropped = isDropped.copyOf(room)
    }

    /** Forgets all. */
    fun begin() {
        clear()
        hits.clear()
        noted = 0
        notedGuards = 0
        notedEntries = 0
        bounces.clear()
        bounceEntries.clear()
    }

    private fun reach(place: Int) {
        while (size <= place) {
            val k = append()
            parent[k] = k
            ring[k] = k
            piece[k] = NONE
            isDropped[k] = false
        }
    }

    /** The last piece of the path of the sphere at [place]; [NONE] when it has not collided. */
    fun pieceOf(place: Int): Int = if (place < size) piece[place] else NONE

    fun setPiece(place: Int, piece: Int) {
        reach(place)
        this.piece[place] = piece
    }

    /**
     * The spheres at [first] and [second] have met, after which [counted] is what the group has counted. The two are
     * the same where a sphere has met a wall.
     *
     * @param entries how many the group's record has now; the same ever where nothing is recorded
     */
    fun met(first: Int, second: Int, counted: CollisionCounters, entries: Int) {
        reach(maxOf(first, second))
        val a = root(first)
        val b = root(second)
        if (a != b) {
            parent[b] = a
            val next = ring[a]
            ring[a] = ring[b]
            ring[b] = next
        }
        val entry = if (entries > notedEntries) entries - 1 else NONE
        notedEntries = entries
        if (first == second) {
            bounces.add(first)
            bounceEntries.add(entry)
        }
        if (counted.collisions == noted) return
        noted = counted.collisions
        hits.add(first, entry, counted.guardActivations > notedGuards)
        notedGuards = counted.guardActivations
    }

    private fun root(place: Int): Int {
        var k = place
        while (parent[k] != k) {
            parent[k] = parent[parent[k]]
            k = parent[k]
        }
        return k
    }

    /** Whether the sphere at [place] has collided, and its cluster was not dropped. */
    fun isLive(place: Int): Boolean = pieceOf(place) != NONE && !isDropped[root(place)]

    /** Calls [use] with the place of each sphere that [isLive]. */
    inline fun forEachLive(use: (Int) -> Unit) {
        for (place in 0 until size) if (isLive(place)) use(place)
    }

    /** Drops the cluster of [place], and calls [use] with the place of each of its spheres. */
    inline fun drop(place: Int, use: (Int) -> Unit) {
        markDropped(place)
        var k = place
        do {
            use(k)
            k = nextOf(k)
        } while (k != place)
    }

    fun markDropped(place: Int) {
        isDropped[root(place)] = true
    }

    fun nextOf(place: Int): Int = ring[place]

    /** Adds what live clusters count to [counters], and their entries of [from] to [record]. */
    fun addTo(counters: CollisionCounters, record: CollisionRecord?, from: CollisionRecord) {
        for (k in 0 until hits.size) {
            if (isDropped[root(hits.places[k])]) continue
            counters.collisions++
            if (hits.guarded[k]) counters.guardActivations++
            addEntry(record, from, hits.entries[k])
        }
        for (k in 0 until bounces.size) {
            if (isDropped[root(bounces[k])]) continue
            counters.wallCollisions++
            addEntry(record, from, bounceEntries[k])
        }
    }

    private fun addEntry(record: CollisionRecord?, from: CollisionRecord, entry: Int) {
        if (entry != NONE) record?.addAll(from, entry, entry + 1)
    }

    companion object {
        const val NONE = -1
    }
}
