package daphnis.analysis.theory

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sqrt

class EnskogGasTest {
    @Test
    fun `the viscosity is that worked out by hand`() {
        // φ = 0.3: χ = 0.85/0.343, bχ = 2.9738, 0.17915 · 1.2 · (0.33627 + 0.8 + 2.26424).
        assertEquals(0.73103, EnskogGas.viscosity(1.0, 1.0, 0.3, 1.0), 1e-4)
        // η ~ √(m kT)/σ²; at vanishing density it is η₀.
        assertEquals(0.73103 * 6 / 4, EnskogGas.viscosity(2.0, 4.0, 0.3, 9.0), 2e-4)
        assertEquals(1.016 * 5 / 16 / Math.sqrt(PI), EnskogGas.viscosity(1.0, 1.0, 1e-9, 1.0), 1e-6)
    }

    /** At nσ³ = ½: b = π/3, χ = 2.16047. */
    @Test
    fun `bulk viscosity, conductivity, diffusion and rate are those of their textbook forms`() {
        val phi = PI / 12
        val chi = (1 - phi / 2) / ((1 - phi) * (1 - phi) * (1 - phi))
        assertEquals(4.0 / 9 * chi * 0.25 * sqrt(PI), EnskogGas.bulkViscosity(1.0, 1.0, phi, 1.0), 1e-12)
        assertEquals(LAMBDA, EnskogGas.conductivity(1.0, 1.0, phi, 1.0), 1e-5)
        assertEquals(DIFFUSION, EnskogGas.diffusion(1.0, 1.0, phi, 1.0), 1e-6)
        assertEquals(4 * sqrt(PI) * 0.5 * chi, EnskogGas.collisionRate(1.0, 1.0, phi, 1.0), 1e-12)
        // σ = 2, m = 4, kT = 9.
        val double = doubleArrayOf(
            EnskogGas.bulkViscosity(2.0, 4.0, phi, 9.0) * 4 / 6 / EnskogGas.bulkViscosity(1.0, 1.0, phi, 1.0),
            EnskogGas.conductivity(2.0, 4.0, phi, 9.0) * 4 * 4 / 6 / LAMBDA,
            EnskogGas.diffusion(2.0, 4.0, phi, 9.0) / 3 / DIFFUSION,
            EnskogGas.collisionRate(2.0, 4.0, phi, 9.0) * 4 / 3 / EnskogGas.collisionRate(1.0, 1.0, phi, 1.0),
        )
        for (ratio in double) assertEquals(1.0, ratio, 1e-5)
    }

    private companion object {
        const val LAMBDA = 2.381661
        const val DIFFUSION = 0.1995707
    }
}
