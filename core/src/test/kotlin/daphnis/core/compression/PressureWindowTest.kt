package daphnis.core.compression

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.exp

class PressureWindowTest {
    @Test
    fun `steps are weighted by their growth and fade with collisions`() {
        val window = PressureWindow(100.0)
        assertTrue(window.mean.isNaN() && !window.isFull)
        window.add(2.0, 0.1, 50)
        assertEquals(2.0, window.mean, 1e-15)
        assertFalse(window.isFull)
        window.add(Double.NaN, 0.5, 1000)
        assertFalse(window.isFull)
        window.add(4.0, 0.3, 100)
        assertEquals((2 * 0.1 * exp(-1.0) + 4 * 0.3) / (0.1 * exp(-1.0) + 0.3), window.mean, 1e-12)
        assertTrue(window.isFull)
    }
}
