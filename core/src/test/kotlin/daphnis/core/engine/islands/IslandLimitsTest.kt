package daphnis.core.engine.islands

import daphnis.core.collision.StepRows
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** What one worker keeps of a window has an end. */
class IslandLimitsTest {
    private val limits = IslandLimits(10)

    @Test
    fun `pieces of path`() {
        val paths = PathLog().apply { clear(limits.pieces) }
        val row = DoubleArray(StepRows.STRIDE)
        repeat(500_020) { paths.add(row, 0, PathLog.NONE) }
        assertThrows(IslandsTooLargeException::class.java) { paths.add(row, 0, PathLog.NONE) }
    }

    @Test
    fun `collisions of one island, and the potential ones`() {
        limits.checkIsland(4_040, 1_000_080)
        assertThrows(IslandsTooLargeException::class.java) { limits.checkIsland(4_041, 0) }
        assertThrows(IslandsTooLargeException::class.java) { limits.checkIsland(0, 1_000_081) }
    }

    @Test
    fun `potential collisions beyond the window`() {
        val hints = Hints().apply { reset(1.0, limits) }
        repeat(2_000_320) { hints.add(0.5, 0, 1, 0) }
        assertThrows(IslandsTooLargeException::class.java) { hints.add(0.5, 0, 1, 0) }
    }
}
