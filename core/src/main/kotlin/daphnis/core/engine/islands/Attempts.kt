package daphnis.core.engine.islands

import daphnis.core.collision.CollisionCounters
import daphnis.core.growth.GrowingTable

/**
 * The attempts at islands that one worker has made in a window. The worker's stores are filled in order, so an attempt
 * is known by where these stood when it began; it ends where the next one begins. An attempt is alive until its island
 * is found to have met another one.
 */
internal class Attempts : GrowingTable() {
    /** One row of [WIDTH] numbers per attempt, and one for the end of the last. */
    private var marks = LongArray(0)
    private var alive = BooleanArray(0)

    override fun resize(room: Int) {
        marks = marks.copyOf((room + 1) * WIDTH)
        alive = alive.copyOf(room)
    }

    /**
     * Begins an attempt and returns its number. The worker has as many [rows] and as many collisions in its [record]
     * now, and its counters stand at [counted].
     */
    fun begin(rows: Int, record: Int, counted: CollisionCounters): Int {
        val k = append()
        mark(k, rows, record, counted)
        alive[k] = true
        return k
    }

    /** Ends the last attempt, see [begin]. */
    fun end(rows: Int, record: Int, counted: CollisionCounters) {
        mark(size, rows, record, counted)
    }

    private fun mark(attempt: Int, rows: Int, record: Int, counted: CollisionCounters) {
        val p = attempt * WIDTH
        marks[p + ROWS] = rows.toLong()
        marks[p + RECORD] = record.toLong()
        marks[p + COLLISIONS] = counted.collisions
        marks[p + WALL_COLLISIONS] = counted.wallCollisions
        marks[p + GUARDED] = counted.guardActivations
        marks[p + EDGES] = counted.edgeEvents
        marks[p + MERGERS] = counted.mergers
    }

    fun isAlive(attempt: Int): Boolean = alive[attempt]

    fun drop(attempt: Int) {
        alive[attempt] = false
    }

    /** The first of its rows among the worker's. */
    fun firstRow(attempt: Int): Int = marks[attempt * WIDTH + ROWS].toInt()

    /** One past the last of its rows. */
    fun endOfRows(attempt: Int): Int = firstRow(attempt + 1)

    /** Place of its first collision in the worker's record. */
    fun firstRecord(attempt: Int): Int = marks[attempt * WIDTH + RECORD].toInt()

    /** One past its last collision there. */
    fun endOfRecord(attempt: Int): Int = firstRecord(attempt + 1)

    /** Adds the counts of the attempts that are alive. */
    fun addTo(counters: CollisionCounters) {
        for (k in 0 until size) {
            if (!alive[k]) continue
            counters.collisions += counted(k, COLLISIONS)
            counters.wallCollisions += counted(k, WALL_COLLISIONS)
            counters.guardActivations += counted(k, GUARDED)
            counters.edgeEvents += counted(k, EDGES)
            counters.mergers += counted(k, MERGERS)
        }
    }

    private fun counted(attempt: Int, column: Int): Long =
        marks[(attempt + 1) * WIDTH + column] - marks[attempt * WIDTH + column]

    private companion object {
        const val ROWS = 0
        const val RECORD = 1
        const val COLLISIONS = 2
        const val WALL_COLLISIONS = 3
        const val GUARDED = 4
        const val EDGES = 5
        const val MERGERS = 6
        const val WIDTH = 7
    }
}
