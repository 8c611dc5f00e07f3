package daphnis.core.engine.islands

/** Numbers in the order in which they were added. Allocates only when it grows. */
internal class IntList {
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

    fun addAll(other: IntList) {
        for (k in 0 until other.size) add(other[k])
    }

    /** Puts the numbers in ascending order. */
    fun sort() {
        values.sort(0, size)
    }

    fun toArray(): IntArray = values.copyOf(size)

    private companion object {
        const val INITIAL = 64
    }
}
