package daphnis.core.engine.horizon

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionRecord

/**
 * What a group's spheres have done to one another in the present step, so that a part of it can be dropped: spheres
 * that have collided are of one **cluster**, whose members are a ring of places. All is addressed by place, as in
 * [EpochBodies].
 */
internal class GroupPaths {
    private var parent = IntArray(INITIAL)
    private var ring = IntArray(INITIAL)

    /** The last piece of the path, see [Trails]; [NONE] for a sphere that has not collided. */
    private var piece = IntArray(INITIAL)
    private var isDropped = BooleanArray(INITIAL)
    private var size = 0

    /** The collisions that count, in order: place of one sphere, and whether it was guarded. */
    private var hits = IntArray(INITIAL)
    private var guarded = BooleanArray(INITIAL)
    private var hitCount = 0
    private var noted = 0L
    private var notedGuards = 0L

    /** The reflections at walls: place of the sphere. */
    private var bounces = IntArray(INITIAL)
    private var bounceCount = 0

    /** Forgets all. */
    fun begin() {
        size = 0
        hitCount = 0
        noted = 0
        notedGuards = 0
        bounceCount = 0
    }

    private fun reach(place: Int) {
        while (size <= place) {
            if (size == parent.size) grow()
            parent[size] = size
            ring[size] = size
            piece[size] = NONE
            isDropped[size++] = false
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
     */
    fun met(first: Int, second: Int, counted: CollisionCounters) {
        reach(maxOf(first, second))
        val a = root(first)
        val b = root(second)
        if (a != b) {
            parent[b] = a
            val next = ring[a]
            ring[a] = ring[b]
            ring[b] = next
        }
        if (first == second) bounced(first)
        if (counted.collisions == noted) return
        noted = counted.collisions
        if (hitCount == hits.size) growHits()
        hits[hitCount] = first
        guarded[hitCount++] = counted.guardActivations > notedGuards
        notedGuards = counted.guardActivations
    }

    private fun bounced(place: Int) {
        if (bounceCount == bounces.size) bounces = bounces.copyOf(bounceCount * 2)
        bounces[bounceCount++] = place
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
        for (place in 0 until count()) if (isLive(place)) use(place)
    }

    fun count(): Int = size

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
        for (k in 0 until hitCount) {
            if (isDropped[root(hits[k])]) continue
            counters.collisions++
            if (guarded[k]) counters.guardActivations++
            record?.addAll(from, k, k + 1)
        }
        for (k in 0 until bounceCount) if (!isDropped[root(bounces[k])]) counters.wallCollisions++
    }

    private fun grow() {
        val n = size * 2
        ring = ring.copyOf(n)
        piece = piece.copyOf(n)
        isDropped = isDropped.copyOf(n)
        // Last, since its length says how many there is room for.
        parent = parent.copyOf(n)
    }

    private fun growHits() {
        guarded = guarded.copyOf(hitCount * 2)
        hits = hits.copyOf(hitCount * 2)
    }

    companion object {
        const val NONE = -1
        private const val INITIAL = 256
    }
}
