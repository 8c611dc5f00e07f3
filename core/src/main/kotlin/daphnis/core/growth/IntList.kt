package daphnis.core.growth

/** Numbers in the order in which they were added. Allocates only when it grows. */
internal class IntList : GrowingTable() {
    private var values = IntArray(0)

    override fun resize(room: Int) {
        values = values.copyOf(room)
    }

    operator fun get(k: Int): Int = values[k]

    operator fun set(k: Int, value: Int) {
        values[k] = value
    }

    fun add(value: Int) {
        val k = append()
        values[k] = value
    }

    fun removeLast() {
        size--
    }

    fun addAll(other: IntList) {
        ensure(size + other.size)
        other.values.copyInto(values, size, 0, other.size)
        size += other.size
    }

    /** Puts the numbers in ascending order. */
    fun sort() {
        values.sort(0, size)
    }

    fun toArray(): IntArray = values.copyOf(size)
}
