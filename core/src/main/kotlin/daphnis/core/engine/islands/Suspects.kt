package daphnis.core.engine.islands

/** Pairs of spheres of different islands that came near one another, noted by one worker: who may touch, is asked when all paths are known. */
internal class Suspects {
    var size = 0
        private set
    private var data = IntArray(INITIAL * WIDTH)

    fun clear() {
        size = 0
    }

    /** Notes that [slot], of the worker's own [attempt], has to be compared with [image] of [other]. */
    fun add(slot: Int, other: Int, image: Int, attempt: Int) {
        if ((size + 1) * WIDTH > data.size) data = data.copyOf(data.size * 2)
        val p = size++ * WIDTH
        data[p] = slot
        data[p + 1] = other
        data[p + 2] = image
        data[p + 3] = attempt
    }

    fun slot(k: Int): Int = data[k * WIDTH]

    fun other(k: Int): Int = data[k * WIDTH + 1]

    fun image(k: Int): Int = data[k * WIDTH + 2]

    fun attempt(k: Int): Int = data[k * WIDTH + 3]

    private companion object {
        const val INITIAL = 256
        const val WIDTH = 4
    }
}
