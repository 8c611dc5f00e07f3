package daphnis.core.engine.islands

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.randomSpheres
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class IslandCrewTest {
    private val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
    private val field = fieldOf(randomSpheres(300, boundary, 1, 1.0) { 0.3 }, boundary, workers = 1)
    private val crew = IslandCrew(field, 1).apply { window = WindowLength(0.0, 0.0, leastSeeds = 1) }

    private fun assertOutOfTurn(vararg calls: () -> Unit) {
        for (call in calls) assertThrows(IllegalStateException::class.java, call)
    }

    private val open: () -> Unit = { crew.openWindow() }
    private val collect: () -> Unit = { crew.collectRoots() }
    private val join: () -> Unit = { crew.joinBorders() }
    private val merge: () -> Unit = { crew.mergeConflicts() }
    private val close: () -> Unit = { crew.closeWindow() }
    private val result: () -> Unit = { crew.addTo(CollisionCounters()) }

    /** Opens windows until one has a potential collision. */
    private fun openFull() {
        while (crew.openWindow() == 0) assertOutOfTurn(collect, join, merge, close)
    }

    private fun process() {
        for (k in 0 until crew.rootCount) assertTrue(crew[0].process(crew.root(k)))
        crew[0].check()
    }

    @Test
    fun `calls between phases have one order, and results come after the last window`() {
        assertOutOfTurn(open, collect, join, merge, close, result)
        crew.prepare()
        assertOutOfTurn(collect, join, merge, close, result)
        crew[0].searchStart(0, field.size)
        openFull()
        assertOutOfTurn(open, merge, close, result)
        crew.propose(0)
        crew[0].group()
        crew.collectRoots()
        assertOutOfTurn(open, collect, join, close, result)
        process()
        while (crew.mergeConflicts()) {
            assertOutOfTurn(open, collect, join, close, result)
            process()
        }
        assertOutOfTurn(open, collect, join, merge, result)
        crew[0].commit()
        crew[0].hintSuspects()
        assertFalse(crew.isLastWindow)
        crew.closeWindow()
        assertOutOfTurn(collect, join, merge, close, result)
    }

    @Test
    fun `after the last window there is no other`() {
        // No sphere was searched from, so no window has a potential collision.
        crew.prepare()
        while (!crew.isLastWindow) crew.openWindow()
        assertOutOfTurn(open)
        crew.writeTo(null)
        crew.addTo(CollisionCounters())
        crew.prepare()
        crew.openWindow()
    }
}
