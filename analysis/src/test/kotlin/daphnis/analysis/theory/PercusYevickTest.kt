package daphnis.analysis.theory

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import kotlin.math.pow
import kotlin.math.sin

class PercusYevickTest {
    @Test
    fun `at wave number 0 it is the compressibility of Percus and Yevick`() {
        for (filling in listOf(0.01, 0.1, 0.3, 0.49)) {
            val known = (1 - filling).pow(4) / (1 + 2 * filling).pow(2)
            assertEquals(known, PercusYevick.plain(0.0, filling), 1e-12)
        }
    }

    @Test
    fun `it is the transform of the direct correlation function, on both sides of the switch`() {
        val filling = 0.4
        val void = (1 - filling).pow(4)
        fun direct(r: Double) = -(
            (1 + 2 * filling).pow(2) - 6 * filling * (1 + filling / 2).pow(2) * r +
                filling / 2 * (1 + 2 * filling).pow(2) * r * r * r
            ) / void
        for (x in listOf(0.3, 0.4999, 0.5001, 3.0, 7.0, 20.0)) {
            val steps = 20_000
            var sum = 0.0
            for (k in 0 until steps) {
                val r = (k + 0.5) / steps
                sum += direct(r) * r * sin(x * r) / x / steps
            }
            assertEquals(1 / (1 - 24 * filling * sum), PercusYevick.plain(x, filling), 1e-7) { "k σ = $x" }
        }
    }

    @Test
    fun `corrected, its peak at freezing is 2_85 high, as Hansen and Verlet found`() {
        val peak = (600..800).maxOf { PercusYevick.structureFactor(it / 100.0, 0.494) }
        assertEquals(2.85, peak, 0.06)
        assertThrows(IllegalArgumentException::class.java) { PercusYevick.plain(1.0, 0.0) }
    }
}
