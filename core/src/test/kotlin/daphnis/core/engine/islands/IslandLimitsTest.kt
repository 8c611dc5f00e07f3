package daphnis.core.engine.islands

import daphnis.core.Sphere
import daphnis.core.collision.StepRows
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** What one worker keeps of a window has an end; arrays double, so it comes within a factor of two. */
class IslandLimitsTest {
    private val limits = IslandLimits(10)

    private fun tooMuch(add: () -> Unit) {
        assertThrows(IslandsTooLargeException::class.java) { repeat(5_000_000) { add() } }
    }

    @Test
    fun `pieces of path`() {
        val paths = PathLog().apply { clear(limits.pieces) }
        val row = DoubleArray(StepRows.STRIDE)
        repeat(500_000) { paths.add(row, 0, PathLog.NONE) }
        tooMuch { paths.add(row, 0, PathLog.NONE) }
    }

    @Test
    fun `potential collisions of one island`() {
        val rows = StepRows().apply { load(populationOf(Sphere(), Sphere(x = 3.0)), IntArray(2) { it }, 1.0, false) }
        val queue = IslandQueue(rows).apply { clear(limits) }
        repeat(1_000_000) { queue.add(0.5, 0, 1, 0) }
        tooMuch { queue.add(0.5, 0, 1, 0) }
    }

    @Test
    fun `potential collisions beyond the window`() {
        val hints = Hints().apply { reset(1.0, limits) }
        repeat(2_000_000) { hints.add(0.5, 0, 1, 0) }
        tooMuch { hints.add(0.5, 0, 1, 0) }
    }
}
