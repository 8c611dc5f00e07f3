package daphnis.core.engine.islands

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class IslandWorkersTest {
    private val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
    private val field = fieldOf(randomSpheres(300, boundary, 1, 1.0) { 0.3 }, boundary, workers = 1)
    private val workers = IslandWorkers(field, 1).apply { window = WindowLength(0.0, 0.0, leastSeeds = 1) }

    private fun assertOutOfTurn(vararg calls: () -> Unit) {
        for (call in calls) assertThrows(IllegalStateException::class.java, call)
    }

    private val open: () -> Unit = { workers.openWindow() }
    private val collect: () -> Unit = { workers.collectRoots() }
    private val join: () -> Unit = { workers.joinBorders() }
    private val merge: () -> Unit = { workers.mergeConflicts() }
    private val close: () -> Unit = { workers.closeWindow() }
    private val result: () -> Unit = { workers.addTo(CollisionCounters()) }

    /** Opens windows until one has a potential collision. */
    private fun openFull() {
        while (workers.openWindow() == 0) assertOutOfTurn(collect, join, merge, close)
    }

    private fun process() {
        for (k in 0 until workers.rootCount) assertTrue(workers[0].process(workers.root(k)))
        workers[0].check()
    }

    @Test
    fun `calls between phases have one order, and results come after the last window`() {
        assertOutOfTurn(open, collect, join, merge, close, result)
        workers.prepare()
        assertOutOfTurn(collect, join, merge, close, result)
        workers[0].searchStart(0, field.size)
        openFull()
        assertOutOfTurn(open, merge, close, result)
        workers.propose(0)
        workers[0].group()
        workers.collectRoots()
        assertOutOfTurn(open, collect, join, close, result)
        process()
        while (workers.mergeConflicts()) {
            assertOutOfTurn(open, collect, join, close, result)
            process()
        }
        assertOutOfTurn(open, collect, join, merge, result)
        workers[0].commit()
        workers[0].hintSuspects()
        assertFalse(workers.isLastWindow)
        workers.closeWindow()
        assertOutOfTurn(collect, join, merge, close, result)
    }

    @Test
    fun `after the last window there is no other`() {
        // No sphere was searched from, so no window has a potential collision.
        workers.prepare()
        while (!workers.isLastWindow) workers.openWindow()
        assertOutOfTurn(open)
        workers.writeTo(null)
        workers.addTo(CollisionCounters())
        workers.prepare()
        workers.openWindow()
    }
}
