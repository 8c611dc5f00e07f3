package daphnis.core.engine.threadpool

import daphnis.core.queue.EventStore
import daphnis.core.queue.Schedule

/** What one worker has found and not yet queued. [SafeQueue] drops what the two colliding spheres had queued. */
internal class Findings : Schedule {
    val events = EventStore()

    fun clear() {
        events.clear()
    }

    override fun add(time: Double, first: Int, second: Int, image: Int) {
        events.add(time, first, second, image)
    }

    override fun removeAllOf(slot: Int): Unit = Unit
}
