package daphnis.core.boundary

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class BoxTest {
    private val box = Box(-1.0, 2.0, -4.0, 2.0, 4.0, 1.0)

    @Test
    fun `bounds are the same by name and by axis`() {
        assertEquals(listOf(-1.0, 2.0, -4.0), listOf(box.lowerX, box.lowerY, box.lowerZ))
        assertEquals(listOf(2.0, 4.0, 1.0), listOf(box.upperX, box.upperY, box.upperZ))
        for (axis in 0..2) {
            assertEquals(listOf(-1.0, 2.0, -4.0)[axis], box.lower(axis))
            assertEquals(listOf(2.0, 4.0, 1.0)[axis], box.upper(axis))
            assertEquals(listOf(3.0, 2.0, 5.0)[axis], box.length(axis))
        }
        assertEquals(30.0, box.volume)
    }

    @Test
    fun `a box ends somewhere only if it does along every axis`() {
        assertTrue(box.isFinite)
        for (axis in 0..2) {
            val upper = DoubleArray(3) { if (it == axis) Double.POSITIVE_INFINITY else 5.0 }
            assertEquals(false, Box(-1.0, 2.0, -4.0, upper[0], upper[1], upper[2]).isFinite) { "axis $axis" }
        }
        assertEquals(false, Box.UNBOUNDED.isFinite)
    }

    @Test
    fun `a box without extent is refused, and the axis named`() {
        for (axis in 0..2) {
            val upper = DoubleArray(3) { if (it == axis) 1.0 else 5.0 }
            val refusal = assertThrows(IllegalArgumentException::class.java) {
                Box(1.0, 1.0, 1.0, upper[0], upper[1], upper[2])
            }
            assertTrue("box along ${"xyz"[axis]} is [1.0, 1.0]" in refusal.message!!) { refusal.message!! }
        }
    }

    @Test
    fun `a centred box reaches half its length to either side`() {
        val centred = Box.centred(10.0, 8.0, 6.0)
        assertEquals(listOf(-5.0, -4.0, -3.0), (0..2).map { centred.lower(it) })
        assertEquals(listOf(5.0, 4.0, 3.0), (0..2).map { centred.upper(it) })
    }
}
