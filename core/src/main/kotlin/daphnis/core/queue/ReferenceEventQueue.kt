package daphnis.core.queue

import java.util.TreeSet

/**
 * The contract of [EventQueue] in its plainest form, a sorted set from which events are removed at once. Slow; the
 * oracle of the tests.
 */
public class ReferenceEventQueue : EventQueue {
    private class Event(val time: Double, val first: Int, val second: Int, val image: Int)

    private var ids = IntArray(0)
    private val events = TreeSet<Event> { a, b ->
        val byTime = a.time.compareTo(b.time)
        if (byTime != 0) byTime else compareTied(ids, a.first, a.second, a.image, b.first, b.second, b.image)
    }
    private var current = Event(0.0, -1, -1, 0)

    override val time: Double get() = current.time
    override val first: Int get() = current.first
    override val second: Int get() = current.second
    override val image: Int get() = current.image

    override fun reset(duration: Double, ids: IntArray, count: Int) {
        this.ids = ids
        events.clear()
    }

    override fun add(time: Double, first: Int, second: Int, image: Int) {
        events.add(Event(time, first, second, image))
    }

    override fun pop(): Boolean {
        current = events.pollFirst() ?: return false
        return true
    }

    override fun removeAllOf(slot: Int) {
        events.removeIf { it.first == slot || it.second == slot }
    }
}
