package daphnis.core.queue

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The store beside a plain list under the same operations. */
class EventStoreTest {
    private data class Event(
        val time: Long,
        val first: Int,
        val second: Int,
        val image: Int,
        var link: Int = EventStore.NONE,
    )

    private fun EventStore.all() = List(size) {
        Event(time(it).toRawBits(), first(it), second(it), image(it), link(it))
    }

    private val times =
        doubleArrayOf(0.0, -0.0, 1.0, Double.NaN, Double.MIN_VALUE, Double.MAX_VALUE, Double.POSITIVE_INFINITY)
    private val numbers = intArrayOf(0, 1, -1, -6, Int.MAX_VALUE, Int.MIN_VALUE, 0x00ff80ff)

    private fun drawEvent(random: SeededRandom) = Event(
        (if (random.nextInt(2) == 0) random.nextDouble() else times[random.nextInt(times.size)]).toRawBits(),
        numbers[random.nextInt(numbers.size)],
        numbers[random.nextInt(numbers.size)],
        numbers[random.nextInt(numbers.size)],
    )

    private fun act(random: SeededRandom, store: EventStore, list: MutableList<Event>) {
        val event = drawEvent(random)
        val time = Double.fromBits(event.time)
        val e = if (list.isEmpty()) 0 else random.nextInt(list.size)
        val f = if (list.isEmpty()) 0 else random.nextInt(list.size)
        when (if (list.isEmpty()) 0 else random.nextInt(40)) {
            1, 2, 3, 4 -> {
                store.link(e, f)
                list[e].link = f
            }
            5 -> {
                store.take(e)
                list[e] = list[e].copy(first = EventStore.NONE, second = EventStore.NONE)
            }
            6, 7 -> {
                store.copy(e, f)
                list[f] = list[e].copy()
            }
            8 -> {
                store.truncate(e)
                while (list.size > e) list.removeLast()
            }
            9 -> store.grow()
            10 -> if (random.nextInt(10) == 0) {
                store.clear()
                list.clear()
            }
            else -> {
                store.add(time, event.first, event.second, event.image)
                list += event
            }
        }
    }

    @Test
    fun `what was put in comes out to the bit, under any operations`() {
        for (seed in 1L..100L) {
            val random = SeededRandom(seed)
            val store = EventStore(1 + random.nextInt(10))
            val list = ArrayList<Event>()
            repeat(400) {
                act(random, store, list)
                assertEquals(list, store.all()) { "seed $seed, operation $it" }
                assertTrue(store.room >= store.size)
            }
        }
    }

    @Test
    fun `ties are broken by ids, whichever sphere is named first`() {
        val ids = intArrayOf(5, 3, 9)
        val store = EventStore()
        store.add(0.5, 0, 2, 0) // ids 5, 9
        store.add(0.5, 2, 1, 0) // ids 3, 9
        store.add(0.5, 1, 0, 0) // ids 3, 5
        store.add(0.5, 1, -1, 0) // a wall
        assertEquals(listOf(3, 2, 1, 0), (0..3).sortedWith { a, b -> store.compareTied(a, b, ids) })
        for (e in 0..3) assertEquals(0, store.compareTied(e, e, ids))
    }
}
