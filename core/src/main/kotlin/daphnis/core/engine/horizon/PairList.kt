package daphnis.core.engine.horizon

/** A list of pairs of slots, each with the image of the second line. */
internal class PairList {
    // Empty at first, since groups have many lists, most of which stay so.
    private var data = IntArray(0)
    var size = 0
        private set

    fun clear() {
        size = 0
    }

    fun add(i: Int, j: Int, code: Int) {
        val p = size * WIDTH
        if (p == data.size) data = data.copyOf(maxOf(INITIAL * WIDTH, data.size * 2))
        data[p] = i
        data[p + 1] = j
        data[p + 2] = code
        size++
    }

    inline fun forEach(use: (i: Int, j: Int, code: Int) -> Unit) {
        for (k in 0 until size) use(first(k), second(k), image(k))
    }

    fun first(k: Int): Int = data[k * WIDTH]

    fun second(k: Int): Int = data[k * WIDTH + 1]

    fun image(k: Int): Int = data[k * WIDTH + 2]

    private companion object {
        const val INITIAL = 64
        const val WIDTH = 3
    }
}
