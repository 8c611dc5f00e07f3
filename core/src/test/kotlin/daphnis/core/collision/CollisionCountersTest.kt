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
        swapAttempts = first + 6
        swaps = first + 7
        redoneSteps = first + 8
        causalityReplays = first + 9
    }

    private fun CollisionCounters.all() = listOf(
        collisions,
        wallCollisions,
        guardActivations,
        edgeEvents,
        mergers,
        broken,
        swapAttempts,
        swaps,
        redoneSteps,
        causalityReplays,
    )

    @Test
    fun `each number is added, taken over and cleared by itself`() {
        val counters = counters(10)
        counters.add(counters(200))
        assertEquals(List(10) { 210L + 2 * it }, counters.all())
        counters.set(counters(3000))
        assertEquals(counters(3000).all(), counters.all())
        counters.clear()
        assertEquals(List(10) { 0L }, counters.all())
    }

    @Test
    fun `each number has its key, and parts add up only what belongs to the trajectory`() {
        val counters = counters(10)
        assertEquals(counters.all(), Counter.entries.map { counters[it] })
        counters.addParts(listOf(counters(100), counters(200)))
        assertEquals(List(8) { 310L + 3 * it } + listOf(226L, 228L), counters.all())
        assertEquals(List(10) { 7L }, counters(10).since(counters(3)).all())
    }
}
