package daphnis.core.engine.islands

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class WindowLengthTest {
    @Test
    fun `windows grow while islands keep apart, up to their most`() {
        val window = WindowLength()
        assertEquals(10_000, window.seeds(1_000_000))
        window.learn(100, 2)
        assertEquals(11_000, window.seeds(1_000_000))
        repeat(20) { window.learn(100, 0) }
        assertEquals(15_000, window.seeds(1_000_000))
    }

    @Test
    fun `windows shrink while islands grow into one another, down to their least`() {
        val window = WindowLength()
        window.learn(100, 11)
        assertTrue(window.seeds(1_000_000) in 6_999..7_000)
        repeat(20) { window.learn(100, 100) }
        assertEquals(1_000, window.seeds(1_000_000))
    }

    @Test
    fun `between few and many the length stays`() {
        val window = WindowLength()
        for (redone in listOf(3, 5, 10)) window.learn(100, redone)
        assertEquals(10_000, window.seeds(1_000_000))
    }

    @Test
    fun `few spheres have windows of 16 potential collisions`() {
        assertEquals(16, WindowLength().seeds(10))
    }
}
