package daphnis.core.engine.threadpool

import daphnis.core.queue.EventSink

/** What one worker has found and not yet queued. */
internal class EventList : EventSink {
    var size = 0
        private set
    private var times = DoubleArray(INITIAL)
    private var data = IntArray(INITIAL * WIDTH)

    fun clear() {
        size = 0
    }

    override fun add(time: Double, first: Int, second: Int, image: Int) {
        if (size == times.size) {
            times = times.copyOf(size * 2)
            data = data.copyOf(size * 2 * WIDTH)
        }
        times[size] = time
        val p = size++ * WIDTH
        data[p] = first
        data[p + 1] = second
        data[p + 2] = image
    }

    fun time(k: Int): Double = times[k]

    fun first(k: Int): Int = data[k * WIDTH]

    fun second(k: Int): Int = data[k * WIDTH + 1]

    fun image(k: Int): Int = data[k * WIDTH + 2]

    private companion object {
        const val INITIAL = 64
        const val WIDTH = 3
    }
}
