package daphnis.analysis.theory

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.PI

class EnskogGasTest {
    @Test
    fun `the viscosity is that worked out by hand`() {
        // φ = 0.3: χ = 0.85/0.343, bχ = 2.9738, 0.17915 · 1.2 · (0.33627 + 0.8 + 2.26424).
        assertEquals(0.73103, EnskogGas.viscosity(1.0, 1.0, 0.3, 1.0), 1e-4)
        // η ~ √(m kT)/σ²; at vanishing density it is η₀.
        assertEquals(0.73103 * 6 / 4, EnskogGas.viscosity(2.0, 4.0, 0.3, 9.0), 2e-4)
        assertEquals(1.016 * 5 / 16 / Math.sqrt(PI), EnskogGas.viscosity(1.0, 1.0, 1e-9, 1.0), 1e-6)
    }
}
