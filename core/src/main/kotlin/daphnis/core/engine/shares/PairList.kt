package daphnis.core.engine.shares

import daphnis.core.growth.GrowingTable

/** A list of pairs of slots, each with the image of the second line. */
internal class PairList : GrowingTable() {
    private var data = IntArray(0)

    override fun resize(room: Int) {
        data = data.copyOf(room * WIDTH)
    }

    fun add(i: Int, j: Int, code: Int) {
        val p = append() * WIDTH
        data[p] = i
        data[p + 1] = j
        data[p + 2] = code
    }

    inline fun forEach(use: (i: Int, j: Int, code: Int) -> Unit) {
        for (k in 0 until size) use(first(k), second(k), image(k))
    }

    fun first(k: Int): Int = data[k * WIDTH]

    fun second(k: Int): Int = data[k * WIDTH + 1]

    fun image(k: Int): Int = data[k * WIDTH + 2]

    private companion object {
        const val WIDTH = 3
    }
}
