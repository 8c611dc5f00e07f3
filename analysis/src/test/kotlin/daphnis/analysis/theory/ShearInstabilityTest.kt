package daphnis.analysis.theory

import daphnis.core.space.Space
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sqrt

class ShearInstabilityTest {
    /** k_c² = ζρ/2η from Enskog's η of elastic spheres and the loss of energy, for ε → 1. */
    @Test
    fun `of nearly elastic spheres it is that of Enskog's viscosity and the rate of losses`() {
        for (filling in listOf(0.01, 0.1, 0.3)) {
            val e = 0.999
            val n = filling * 6 / PI
            // Where noise of intensity 1 balances losses, ζ t = 1.
            val t = HeatedGas.temperature(1.0, 0.0, e, n, 1.0)
            val viscosity = EnskogGas.viscosity(1.0, 1.0, filling, t)
            val known = 2 * PI / sqrt(n / t / (2 * viscosity))
            assertEquals(known, ShearInstability.criticalLength(e, filling, Space.VOLUME), 0.01 * known)
        }
    }

    @Test
    fun `discs of nearly no density have that of Jenkins and Richman's viscosity`() {
        // η = 1/(2σ) √(mT/π), ζ = √π n σ (1 − ε²) √T.
        val e = 0.99
        val filling = 1e-4
        val n = filling * 4 / PI
        val known = 2 * PI / sqrt(sqrt(PI) * n * (1 - e * e) * n / (2 * 0.5 / sqrt(PI)))
        assertEquals(known, ShearInstability.criticalLength(e, filling, Space.PLANE), 0.01 * known)
    }

    /** Gass 1971, J. Chem. Phys. 54, 1898: 1.022 η₀ (1/χ + 2ν + 0.8729 · 4ν² χ); 1.022 is of further approximations. */
    @Test
    fun `nearly elastic discs have that of Gass's viscosity`() {
        val e = 0.999
        for (filling in listOf(0.1, 0.3, 0.5)) {
            val n = filling * 4 / PI
            val contact = HardDiscs.hendersonContact(filling)
            val close = 2 * filling
            val viscosity = 1.022 * 0.5 / sqrt(PI) * (1 / contact + close + 0.8729 * close * close * contact)
            val rate = sqrt(PI) * n * contact * (1 - e * e)
            val known = 2 * PI / sqrt(rate * n / (2 * viscosity))
            assertEquals(known, ShearInstability.criticalLength(e, filling, Space.PLANE), 0.012 * known)
        }
    }

    @Test
    fun `spheres have that of the gas that cools`() {
        for ((e, filling) in listOf(0.7 to 0.1, 0.9 to 0.4)) {
            val n = filling * 6 / PI
            val rate = CoolingGas.coolingRate(1.0, e, filling, 1.0)
            val known = 2 * PI / sqrt(rate * n / (2 * CoolingGas.viscosity(1.0, 1.0, e, filling, 1.0)))
            assertEquals(known, ShearInstability.criticalLength(e, filling, Space.VOLUME), 1e-12 * known)
        }
    }

    /** Numbers of the formulas of Lutsko 2005 and of van Noije & Ernst, arranged in another way than in the code. */
    @Test
    fun `inelastic discs have their own cumulant, rate and viscosity`() {
        assertEquals(-0.0219393, coolingCumulant(0.8, 2), 1e-7)
        assertEquals(37.659454, ShearInstability.criticalLength(0.7, 0.1, Space.PLANE), 1e-6)
        assertEquals(11.310141, ShearInstability.criticalLength(0.8, 0.4, Space.PLANE), 1e-6)
    }

    @Test
    fun `it falls with density and with losses, and elastic gases have none`() {
        for (space in listOf(Space.VOLUME, Space.PLANE)) {
            val lengths = listOf(0.05, 0.1, 0.2, 0.4).map { ShearInstability.criticalLength(0.9, it, space) }
            assertTrue(lengths.zipWithNext().all { (a, b) -> a > b }) { "$lengths" }
            assertTrue(ShearInstability.criticalLength(0.8, 0.1, space) < lengths[1])
            assertEquals(Double.POSITIVE_INFINITY, ShearInstability.criticalLength(1.0, 0.1, space))
        }
        assertThrows(IllegalArgumentException::class.java) { ShearInstability.criticalLength(0.9, 0.0, Space.VOLUME) }
        assertThrows(IllegalArgumentException::class.java) { ShearInstability.criticalLength(1.1, 0.1, Space.VOLUME) }
    }
}
