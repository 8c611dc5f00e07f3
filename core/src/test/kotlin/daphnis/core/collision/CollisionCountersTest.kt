package daphnis.core.collision

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class CollisionCountersTest {
    private fun counters(first: Long) = CollisionCounters().apply {
        collisions = first
        wallCollisions = first + 1
        guardActivations = first + 2
        edgeEvents = first + 3
        mergers = first + 4
        broken = first + 5
        redoneSteps = first + 6
        causalityReplays = first + 7
    }

    private fun CollisionCounters.all() =
        listOf(collisions, wallCollisions, guardActivations, edgeEvents, mergers, broken, redoneSteps, causalityReplays)

    @Test
    fun `each number is added, taken over and cleared by itself`() {
        val counters = counters(10)
        counters.add(counters(200))
        assertEquals(listOf(210L, 212L, 214L, 216L, 218L, 220L, 222L, 224L), counters.all())
        counters.set(counters(3000))
        assertEquals(counters(3000).all(), counters.all())
        counters.clear()
        assertEquals(List(8) { 0L }, counters.all())
    }

    @Test
    fun `each number has its key, and parts add up only what belongs to the trajectory`() {
        val counters = counters(10)
        assertEquals(counters.all(), Counter.entries.map { counters[it] })
        counters.addParts(listOf(counters(100), counters(200)))
        assertEquals(listOf(310L, 313L, 316L, 319L, 322L, 325L, 222L, 224L), counters.all())
        assertEquals(List(8) { 7L }, counters(10).since(counters(3)).all())
    }
}
