package daphnis.core.engine.horizon

import daphnis.core.growth.GrowingTable

/** Numbers, each with a time, of which the one with the least time is taken first: a binary heap. */
internal class TimedHeap : GrowingTable() {
    private var times = DoubleArray(0)
    private var numbers = IntArray(0)

    override fun resize(room: Int) {
        times = times.copyOf(room)
        numbers = numbers.copyOf(room)
    }

    /** The least time; there is one. */
    val least: Double get() = times[0]

    fun add(time: Double, number: Int) {
        var k = append()
        while (k > 0) {
            val parent = (k - 1) shr 1
            if (times[parent] <= time) break
            put(k, times[parent], numbers[parent])
            k = parent
        }
        put(k, time, number)
    }

    /** Takes the number with the least time. */
    fun take(): Int {
        val taken = numbers[0]
        val n = --size
        val time = times[n]
        var k = 0
        while (2 * k + 1 < n) {
            var child = 2 * k + 1
            if (child + 1 < n && times[child + 1] < times[child]) child++
            if (time <= times[child]) break
            put(k, times[child], numbers[child])
            k = child
        }
        put(k, time, numbers[n])
        return taken
    }

    private fun put(k: Int, time: Double, number: Int) {
        times[k] = time
        numbers[k] = number
    }
}
