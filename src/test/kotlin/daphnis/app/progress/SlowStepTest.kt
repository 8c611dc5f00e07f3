package daphnis.app.progress

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import java.util.concurrent.CompletableFuture
import java.util.concurrent.LinkedBlockingQueue

/** The line about a step that does not end. */
@Timeout(60)
class SlowStepTest {
    private val said = LinkedBlockingQueue<Pair<Long, Double>>()

    private fun slow(milliseconds: Long, able: () -> Long = { Long.MAX_VALUE }) =
        SlowStep(milliseconds * 1_000_000, able) { step, seconds ->
            said += step to seconds
        }

    @Test
    fun `a step that goes on and on is told of at twice the time each`() {
        val slow = slow(20)
        slow.begin(7)
        val told = List(4) { said.take() }
        slow.end()
        assertEquals(List(4) { 7L }, told.map { it.first })
        assertTrue(told[0].second >= 0.02) { "$told" }
        assertTrue(told.zipWithNext().all { (a, b) -> b.second >= 2 * a.second }) { "$told" }
    }

    @Test
    fun `a new step has the patience of the first`() {
        val slow = slow(20)
        slow.begin(1)
        repeat(3) { said.take() }
        slow.begin(2)
        while (said.take().first == 1L) continue
        slow.end()
        assertTrue(said.all { it.first == 2L }) { "$said" }
    }

    @Test
    fun `the time in which it waits for nodes is none of a step's`() {
        val formed = CompletableFuture<Long>()
        val slow = slow(20) { if (formed.isDone) System.nanoTime() - formed.get() else 0 }
        slow.begin(1)
        Thread.sleep(200)
        assertEquals(0, said.size)
        formed.complete(System.nanoTime())
        val told = said.take()
        slow.end()
        assertEquals(1L, told.first)
        assertTrue(told.second >= 0.02 && told.second <= (System.nanoTime() - formed.get()) * 1e-9) { "$told" }
    }

    @Test
    fun `steps that end say nothing, and none is said after the end`() {
        val slow = slow(3_600_000)
        for (step in 1L..1000) slow.begin(step)
        slow.end()
        slow.end()
        assertEquals(0, said.size)
    }
}
