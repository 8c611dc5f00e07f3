package daphnis.core.collision

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

class CollisionRecordTest {
    private data class Entry(val time: Double, val rank: Int, val lower: Int, val higher: Int, val data: List<Double>)

    private val order = compareBy<Entry>({ it.time }, { it.rank }, { it.lower }, { it.higher })

    private fun CollisionRecord.all() = List(size) { k ->
        val vectors = List(3) { separation(k, it) } + List(3) { tangentialImpulse(k, it) }
        val data = listOf(impactSpeed(k), coefficient(k), impulse(k), surfaceDissipation(k)) + vectors
        Entry(time[k], rank[k], lower[k], higher[k], data)
    }

    private fun CollisionRecord.draw(random: SeededRandom, number: Int) {
        val outcome = CollisionOutcome().apply {
            impactSpeed = number.toDouble()
            coefficient = random.nextDouble()
            impulse = random.nextDouble()
            separationX = random.nextDouble() - 0.5
            separationY = random.nextDouble() - 0.5
            separationZ = random.nextDouble() - 0.5
            slideX = random.nextDouble() - 0.5
            slideY = random.nextDouble() - 0.5
            slideZ = random.nextDouble() - 0.5
            rubbed = random.nextDouble()
            rank = 1 + random.nextInt(3)
        }
        // Few times and ids, so that all ties come up.
        val first = random.nextInt(5)
        add(random.nextInt(6) / 4.0, first, (first + 1 + random.nextInt(4)) % 5, outcome)
    }

    @Test
    fun `entries are sorted by time, rank, lower id and higher id, with all that belongs to them`() {
        for (seed in 1L..60L) {
            val random = SeededRandom(seed)
            val record = CollisionRecord()
            repeat(random.nextInt(3000)) { record.draw(random, it) }
            // What is equal in all four stays in the order in which it came.
            val expected = record.all().sortedWith(order)
            record.sort()
            assertEquals(expected, record.all()) { "seed $seed" }
            val times = record.time
            record.sort()
            assertEquals(expected, record.all())
            assertSame(times, record.time) { "sorting what is in order moved it" }
        }
    }

    @Test
    fun `the last two alone may be out of order`() {
        for ((a, b) in listOf(1.0 to 0.5, 0.5 to 1.0)) {
            val record = CollisionRecord()
            val outcome = CollisionOutcome()
            for (time in listOf(0.25, a, b)) record.add(time, 0, 1, outcome)
            record.sort()
            assertEquals(listOf(0.25, 0.5, 1.0), record.time.take(3))
        }
    }

    @Test
    fun `a pair is named by the lower id, and the separation turns with it, without negative zeros`() {
        val outcome = CollisionOutcome().apply {
            separationX = 1.0
            separationY = -0.0
            separationZ = 0.0
        }
        val record = CollisionRecord()
        record.add(0.5, 3, 7, outcome)
        record.add(0.5, 7, 3, outcome)
        for (k in 0..1) assertEquals(3 to 7, record.lower[k] to record.higher[k])
        assertEquals(listOf(1.0, 0.0, 0.0), List(3) { record.separation(0, it) })
        assertEquals(listOf(-1.0, 0.0, 0.0), List(3) { record.separation(1, it) })
    }

    @Test
    fun `part of a record can be appended to another, beyond its room`() {
        val random = SeededRandom(1)
        val source = CollisionRecord().apply { repeat(5000) { draw(random, it) } }
        val record = CollisionRecord().apply { draw(random, -1) }
        val first = record.all()
        record.addAll(source, 100, 4900)
        record.addAll(source, 7, 7)
        assertEquals(first + source.all().subList(100, 4900), record.all())
    }

    @Test
    fun `each number of a collision is found under its name`() {
        val outcome = CollisionOutcome().apply {
            impactSpeed = 2.0
            coefficient = 0.5
            impulse = 7.0
            separationX = -0.0
            separationY = 3.0
            separationZ = -4.0
            rank = 6
        }
        val record = CollisionRecord()
        repeat(2) { record.add(0.25, 1, 9, outcome) }
        assertEquals(listOf(0.25, 6, 1, 9), listOf(record.time[1], record.rank[1], record.lower[1], record.higher[1]))
        assertEquals(listOf(2.0, 0.5, 7.0), listOf(record.impactSpeed(1), record.coefficient(1), record.impulse(1)))
        assertEquals(listOf(0.0, 3.0, -4.0), List(3) { record.separation(1, it) })
    }
}
