package daphnis.core.collision

import daphnis.core.surface.BorderiesRestitution
import daphnis.core.surface.BridgesRestitution
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class RestitutionTest {
    @Test
    fun `Bridges' law in Lewis's form has the published values`() {
        val law = BridgesRestitution()
        assertEquals(0.685362, law.coefficient(0.05), 1e-6)
        assertEquals(0.582745, law.coefficient(0.1), 1e-6)
        assertEquals(0.34, law.coefficient(1.0), 1e-6)
        assertEquals(1.0, law.coefficient(0.005))
    }

    @Test
    fun `Bridges' laws reach 1 at their published speeds`() {
        for ((prefactor, speed) in listOf(0.34 to 0.009949, 0.32 to 0.007678)) {
            val law = BridgesRestitution(prefactor)
            assertEquals(1.0, law.coefficient(speed * 0.9999))
            assertTrue(law.coefficient(speed * 1.001) < 1.0)
            assertEquals(1.0, law.coefficient(speed * 1.001), 1e-3)
        }
    }

    @Test
    fun `Borderies' law has the published values and is elastic up to the critical speed`() {
        val law = BorderiesRestitution(0.01)
        assertEquals(0.8526, law.coefficient(0.02), 1e-4)
        assertEquals(0.4192, law.coefficient(0.1), 1e-4)
        assertEquals(1.0, law.coefficient(0.01))
        assertEquals(1.0, law.coefficient(0.0))
        assertEquals(1.0, law.coefficient(0.01 * (1 + 1e-9)), 1e-6)
    }

    @Test
    fun `speeds are turned into cm per second`() {
        assertEquals(
            BridgesRestitution().coefficient(2.5),
            BridgesRestitution(cmPerSecond = 100.0).coefficient(0.025),
            1e-15,
        )
        assertEquals(
            BorderiesRestitution(0.01).coefficient(0.05),
            BorderiesRestitution(0.01, cmPerSecond = 10.0).coefficient(0.005),
            1e-15,
        )
    }

    @Test
    fun `every law stays in 0 to 1 over thirty decades and at both ends`() {
        val laws =
            listOf(
                BridgesRestitution(),
                BridgesRestitution(0.32),
                BridgesRestitution(1.5),
                BorderiesRestitution(0.01),
                ConstantRestitution(0.5),
            )
        for (law in laws) {
            for (power in -20..10) assertTrue(law.coefficient(Math.pow(10.0, power.toDouble())) in 0.0..1.0)
            assertTrue(law.coefficient(0.0) in 0.0..1.0)
            assertTrue(law.coefficient(Double.MAX_VALUE) in 0.0..1.0)
        }
    }

    @Test
    fun `parameters that make no law are refused`() {
        assertThrows(IllegalArgumentException::class.java) { ConstantRestitution(1.1) }
        assertThrows(IllegalArgumentException::class.java) { ConstantRestitution(Double.NaN) }
        assertThrows(IllegalArgumentException::class.java) { BridgesRestitution(0.0) }
        assertThrows(IllegalArgumentException::class.java) { BridgesRestitution(exponent = 0.1) }
        assertThrows(IllegalArgumentException::class.java) { BorderiesRestitution(-1.0) }
    }
}
