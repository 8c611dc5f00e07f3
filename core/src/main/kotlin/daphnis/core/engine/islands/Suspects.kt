package daphnis.core.engine.islands

import daphnis.core.growth.GrowingTable

/**
 * Pairs of spheres of different islands that came near one another, noted by one worker. Whether they touch is checked
 * when all paths are known. Each pair is kept once per attempt, however often the two came near, since a moonlet sees
 * its whole neighbourhood at every collision.
 */
internal class Suspects : GrowingTable() {
    private var data = IntArray(0)

    /** Open addressing; one more than the number of a pair, 0 where there is none. At most half full. */
    private var table = IntArray(INITIAL * 2)

    override fun resize(room: Int) {
        data = data.copyOf(room * WIDTH)
    }

    override fun clear() {
        for (k in 0 until size) table[data[k * WIDTH + AT]] = 0
        super.clear()
    }

    /** Notes that [slot], of the worker's own [attempt], has to be compared with [image] of [other]. */
    fun add(slot: Int, other: Int, image: Int, attempt: Int) {
        var place = placeOf(slot, other, image, attempt)
        while (table[place] != 0) {
            val p = (table[place] - 1) * WIDTH
            if (data[p] == slot && data[p + 1] == other && data[p + 2] == image && data[p + 3] == attempt) return
            place = (place + 1) and (table.size - 1)
        }
        // Before the table names the pair, which it would for ever if there were no memory for it.
        val p = append() * WIDTH
        table[place] = size
        data[p] = slot
        data[p + 1] = other
        data[p + 2] = image
        data[p + 3] = attempt
        data[p + AT] = place
        if (size * 2 > table.size) growTable()
    }

    private fun placeOf(slot: Int, other: Int, image: Int, attempt: Int): Int {
        val hash = ((slot * MIX + other) * MIX + image) * MIX + attempt
        return (hash xor (hash ushr 15)) and (table.size - 1)
    }

    private fun growTable() {
        table = IntArray(table.size * 2)
        for (k in 0 until size) {
            var place = placeOf(slot(k), other(k), image(k), attempt(k))
            while (table[place] != 0) place = (place + 1) and (table.size - 1)
            table[place] = k + 1
            data[k * WIDTH + AT] = place
        }
    }

    fun slot(k: Int): Int = data[k * WIDTH]

    fun other(k: Int): Int = data[k * WIDTH + 1]

    fun image(k: Int): Int = data[k * WIDTH + 2]

    fun attempt(k: Int): Int = data[k * WIDTH + 3]

    private companion object {
        const val INITIAL = 256
        const val WIDTH = 5

        /** The place of a pair in the table, so that a few pairs are removed quickly. */
        const val AT = 4
        const val MIX = -1640531527
    }
}
