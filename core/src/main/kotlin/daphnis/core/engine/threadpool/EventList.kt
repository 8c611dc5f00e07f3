package daphnis.core.engine.threadpool

import daphnis.core.queue.Schedule

/**
 * What one worker wants changed in the queue: the spheres that have collided, whose potential collisions are to be
 * dropped first, and those that it has found.
 */
internal class EventList : Schedule {
    var size = 0
        private set
    private var times = DoubleArray(INITIAL)
    private var data = IntArray(INITIAL * WIDTH)

    /** Slots of the spheres that have collided, the first [changedCount]. */
    val changed = IntArray(2)
    var changedCount = 0
        private set

    fun clear() {
        size = 0
        changedCount = 0
    }

    /** Only before any [add] since [clear]. */
    override fun removeAllOf(slot: Int) {
        changed[changedCount++] = slot
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
