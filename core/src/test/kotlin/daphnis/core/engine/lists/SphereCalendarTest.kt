package daphnis.core.engine.lists

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SphereCalendarTest {
    @Test
    fun `it gives the sphere that a list of all gives, with times moved to and fro and many at one time`() {
        for (seed in 1L..200L) {
            val random = SeededRandom(seed)
            val n = 1 + random.nextInt(60)
            // Lower numbers first.
            val table = EventTable()
            val calendar = SphereCalendar(table) { a, b -> a < b }
            table.reserve(n)
            val duration = random.nextDouble(0.1, 10.0)
            val grain = 1 + random.nextInt(40)
            var taken = 0
            for (step in 1..3) {
                for (k in 0 until n) calendar.remove(k)
                calendar.begin(0.0, duration, random.nextInt(200))
                val times = DoubleArray(n) { Double.POSITIVE_INFINITY }
                fun put(k: Int, from: Double) {
                    val at = from + duration * random.nextInt(grain) / grain
                    times[k] = at
                    calendar.put(k, at)
                }
                for (k in 0 until n) put(k, 0.0)
                for (event in 1..300) {
                    val expected = (0 until n).minWith(compareBy<Int> { times[it] }.thenBy { it })
                    val next = calendar.next(duration)
                    if (times[expected] > duration) {
                        assertEquals(SphereCalendar.NONE, next) { "seed $seed" }
                        break
                    }
                    taken++
                    assertEquals(expected, next) { "seed $seed, event $event" }
                    assertEquals(times[next], table.time(next))
                    val now = times[next]
                    if (random.nextInt(4) == 0) {
                        times[next] = duration * 2
                        calendar.putLater(next, duration)
                    } else {
                        put(next, now)
                    }
                    put(random.nextInt(n), now)
                    val isMore = (0 until n).any { times[it] == now }
                    assertTrue(isMore || !calendar.hasMoreAt(now)) { "seed $seed, event $event" }
                }
            }
            assertTrue(taken > 0)
        }
    }
}
