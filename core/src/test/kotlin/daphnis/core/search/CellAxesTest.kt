package daphnis.core.search

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.floor

class CellAxesTest {
    /** Five cells of 0.4 from 1 to 3 along an axis with images, and along one without; none long along the third. */
    private val axes = CellAxes().also {
        for (k in 0..1) {
            it.low[k] = 1.0
            it.length[k] = 2.0
            it.divide(k, 0.8, 2.0, 100.0)
        }
        it.low[2] = 7.0
        it.divide(2, 0.8, 2.0, 100.0)
        it.isPeriodic[0] = true
        it.settle()
    }

    @Test
    fun `cells of one axis are as wide as what was asked for allows, at least one and not too many`() {
        assertEquals(listOf(5, 5, 1), axes.count.toList())
        assertEquals(25, axes.total)
        assertEquals(0.4, axes.width[0], 1e-15)
        assertEquals(2.2, axes.middleOf(3, 0) - axes.width[0] / 2, 1e-15)
        axes.divide(0, 0.8, 2.0, 3.0)
        assertEquals(3, axes.count[0])
        // Longer than the axis, of no length, and with a length of no number.
        for ((range, cells) in listOf(5.0 to 1, Double.POSITIVE_INFINITY to 1, 1e-300 to 3)) {
            axes.divide(0, range, 1.0, 3.0)
            assertEquals(cells, axes.count[0])
        }
    }

    @Test
    fun `beyond the faces cells go on along an axis with images, and those at the ends have all along others`() {
        val positions = listOf(1.0, 1.39, 1.41, 2.99, 3.01, 0.99, -1.01, 5.01)
        val counted = listOf(0, 0, 1, 4, 5, -1, -6, 10)
        for ((x, toward) in positions.zip(counted)) {
            val at = toward.coerceIn(0, 4)
            assertEquals(toward, axes.cellToward(x, 0)) { "$x" }
            val clamped = listOf(axes.cellToward(x, 1), axes.cellAt(x, 0), axes.cellAt(x, 1))
            assertEquals(listOf(at, at, at), clamped) { "$x" }
            assertEquals(Math.floorMod(toward, 5), axes.cellOfImage(x, 0)) { "$x" }
            assertEquals(at, axes.cellOfImage(x, 1)) { "$x" }
            assertEquals(0, axes.cellAt(x, 2))
        }
        for (x in listOf(Double.NaN, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, -1e300, 1e300)) {
            for (k in 0..2) {
                val cells = listOf(axes.cellAt(x, k), axes.cellOfImage(x, k))
                assertTrue(cells.all { it in 0 until axes.count[k] }) { "$x is in $cells" }
            }
        }
    }

    @Test
    fun `a cell beyond the faces is as many boxes away as its middle`() {
        for (c in -20..20) assertEquals(floor((axes.middleOf(c, 0) - 1) / 2).toInt(), axes.boxes(c, 0)) { "cell $c" }
    }

    @Test
    fun `a position and its images are in one cell, whatever the numbers`() {
        val random = SeededRandom(35)
        repeat(2000) {
            val axes = CellAxes()
            axes.low[0] = random.nextDouble(-1e3, 1e3)
            axes.length[0] = random.nextDouble(1e-3, 1e3)
            axes.isPeriodic[0] = true
            axes.divide(0, random.nextDouble(1e-3, 1.0), 1.0, 1e4)
            axes.settle()
            // In the middle of a cell, so that round-off moves it to no other.
            val c = (random.nextDouble() * axes.count[0]).toInt()
            for (boxes in -3..3) {
                val x = axes.middleOf(c, 0) + boxes * axes.length[0]
                assertEquals(c, axes.cellOfImage(x, 0))
                assertEquals(c + boxes * axes.count[0], axes.cellToward(x, 0))
                assertEquals(boxes, axes.boxes(axes.cellToward(x, 0), 0))
            }
        }
    }

    @Test
    fun `where there are too many cells there are fewer along the axis that has most`() {
        axes.count[0] = 1000
        axes.count[1] = 10
        axes.count[2] = 3
        axes.thin(7_000) { it / 2 }
        assertEquals(listOf(125, 10, 3), axes.count.toList())
        axes.thin(1) { it - 1 }
        assertEquals(listOf(1, 1, 1), axes.count.toList())
    }
}
