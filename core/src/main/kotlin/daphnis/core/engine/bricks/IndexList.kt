package daphnis.core.engine.bricks

/** Indices in the order in which they were added. Allocates only when it grows. */
internal class IndexList {
    private var values = IntArray(INITIAL)

    var size = 0
        private set

    operator fun get(k: Int): Int = values[k]

    fun clear() {
        size = 0
    }

    fun add(value: Int) {
        if (size == values.size) values = values.copyOf(size * 2)
        values[size++] = value
    }

    /** Puts them in ascending order. */
    fun sort() {
        values.sort(0, size)
    }

    private companion object {
        const val INITIAL = 4
    }
}
