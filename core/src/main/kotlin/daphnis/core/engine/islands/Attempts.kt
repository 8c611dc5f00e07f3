package daphnis.core.engine.islands

/**
 * What one worker did in a window: its attempts at islands, and for each the spheres that took part and what was
 * counted. An attempt is alive until it turns out that its island has met another one.
 */
internal class Attempts {
    var size = 0
        private set
    private var columns = IntArray(INITIAL * WIDTH)
    private var alive = BooleanArray(INITIAL)

    fun clear() {
        size = 0
    }

    /** Begins an attempt; [rows] and [record] are where the worker's rows and its record of collisions end. */
    fun begin(rows: Int, record: Int): Int {
        if (size == alive.size) {
            alive = alive.copyOf(size * 2)
            columns = columns.copyOf(size * 2 * WIDTH)
        }
        val k = size++
        alive[k] = true
        columns.fill(0, k * WIDTH, (k + 1) * WIDTH)
        columns[k * WIDTH + FROM] = rows
        columns[k * WIDTH + RECORD] = record
        return k
    }

    fun count(attempt: Int, column: Int) {
        columns[attempt * WIDTH + column]++
    }

    fun counted(attempt: Int, column: Int): Int = columns[attempt * WIDTH + column]

    fun isAlive(attempt: Int): Boolean = alive[attempt]

    fun drop(attempt: Int) {
        alive[attempt] = false
    }

    /** The first of its rows among the worker's; they end where those of the next attempt begin. */
    fun firstRow(attempt: Int): Int = columns[attempt * WIDTH + FROM]

    /** Place in the worker's record of collisions where this attempt began. */
    fun firstRecord(attempt: Int): Int = columns[attempt * WIDTH + RECORD]

    companion object {
        const val COLLISIONS = 0
        const val WALL_COLLISIONS = 1
        const val GUARDED = 2
        private const val FROM = 3
        private const val RECORD = 4
        private const val WIDTH = 5
        private const val INITIAL = 256
    }
}
