package daphnis.analysis.theory

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.pow
import kotlin.math.sqrt

class HeatedGasTest {
    /** Van Noije & Ernst 1998, equation for three dimensions, at two coefficients. */
    @Test
    fun `the fourth cumulant is the published one, and 0 for elastic spheres`() {
        assertEquals(-0.00868, HeatedGas.fourthCumulant(0.8), 5e-6)
        assertEquals(0.01288, HeatedGas.fourthCumulant(0.6), 5e-6)
        assertEquals(0.0, HeatedGas.fourthCumulant(1.0), 1e-15)
    }

    @Test
    fun `noise and collisions balance, and so do noise and drag`() {
        val n = 0.1 * 6 / PI
        val chi = 0.95 / 0.9.pow(3)
        for (drag in listOf(0.0, 0.05, 3.0)) {
            val t = HeatedGas.temperature(0.2, drag, 0.8, n, 1.0)
            val collisions = 0.36 * (4.0 / 3) * sqrt(PI) * n * chi * t.pow(1.5) * (1 - 3.0 / 16 * 0.00868)
            assertEquals(0.2, collisions + 2 * drag * t, 1e-6)
        }
        assertEquals(0.2 / 6, HeatedGas.temperature(0.2, 3.0, 1.0, n, 1.0), 1e-15)
        assertEquals(Double.POSITIVE_INFINITY, HeatedGas.temperature(0.2, 0.0, 1.0, n, 1.0))
        assertEquals(0.0, HeatedGas.temperature(0.0, 0.0, 0.8, n, 1.0))
        val double = HeatedGas.temperature(0.4, 0.0, 0.8, n, 1.0)
        assertEquals(2.0.pow(2.0 / 3), double / HeatedGas.temperature(0.2, 0.0, 0.8, n, 1.0), 1e-13)
    }
}
