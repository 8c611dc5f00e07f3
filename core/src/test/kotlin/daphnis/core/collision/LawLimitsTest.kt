package daphnis.core.collision

import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.engine.CoreEngines
import daphnis.core.engine.Draw
import daphnis.core.engine.SerialEngine
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.simulationOf
import daphnis.core.surface.BorderiesRestitution
import daphnis.core.surface.BridgesRestitution
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The ends of what parameters of laws and guards may be. */
class LawLimitsTest {
    @Test
    fun `the ends that belong to the range make a law`() {
        for (e in listOf(0.0, 1.0)) assertEquals(e, ConstantRestitution(e).coefficient(5.0))
        // A power of zero is a constant, but at rest a collision is elastic.
        for ((speed, e) in listOf(0.0 to 1.0, 1e-9 to 0.5, 5.0 to 0.5)) {
            assertEquals(e, BridgesRestitution(0.5, exponent = 0.0).coefficient(speed)) { "speed $speed" }
        }
        assertEquals(false, FloorSpeedGuard(0.0).makesElastic(0.0, 0.0, 0.0))
    }

    @Test
    fun `the ends that do not make none`() {
        val infinity = Double.POSITIVE_INFINITY
        val none = listOf<() -> Any>(
            { ConstantRestitution(Math.nextDown(0.0)) },
            { ConstantRestitution(Math.nextUp(1.0)) },
            { BridgesRestitution(0.0) },
            { BridgesRestitution(infinity) },
            { BridgesRestitution(exponent = Double.MIN_VALUE) },
            { BridgesRestitution(exponent = -infinity) },
            { BridgesRestitution(cmPerSecond = 0.0) },
            { BridgesRestitution(cmPerSecond = infinity) },
            { BorderiesRestitution(0.0) },
            { BorderiesRestitution(infinity) },
            { BorderiesRestitution(0.01, cmPerSecond = 0.0) },
            { BorderiesRestitution(0.01, cmPerSecond = infinity) },
            { FloorSpeedGuard(Math.nextDown(0.0)) },
            { FloorSpeedGuard(infinity) },
            { ContactDurationGuard(0.0) },
            { ContactDurationGuard(infinity) },
        )
        for ((k, make) in none.withIndex()) assertThrows(IllegalArgumentException::class.java, { make() }, "number $k")
    }

    @Test
    fun `a law that leaves the range ends the step with its number, and the step is as if it had not begun`() {
        for (engine in CoreEngines.others(Draw(1)) + SerialEngine()) {
            for ((bad, word) in listOf(
                3.0 to "3.0",
                -1.0 to "-1.0",
                Double.NaN to "NaN",
                Math.nextUp(1.0) to "1.0000",
            )) {
                val start = populationOf(Sphere(x = -3.0, vx = 2.0), Sphere(x = 3.0), Sphere(x = 3.0, y = 9.0))
                val simulation = simulationOf(start, Open, 10.0, { bad }, engine = engine)
                val before = stateDigest(start)
                val e = assertThrows(IllegalArgumentException::class.java) { simulation.advance() }
                val says = "the coefficient of restitution is $word"
                assertTrue(e.message!!.startsWith(says) && "at an impact speed of 2.0" in e.message!!) {
                    "${e.message}"
                }
                assertEquals(before, stateDigest(start))
            }
            engine.close()
        }
        // The ends of the range, and zeros of either sign, belong to it.
        for (good in listOf(0.0, -0.0, 1.0)) {
            val pair = populationOf(Sphere(x = -3.0, vx = 2.0), Sphere(x = 3.0))
            simulationOf(pair, Open, 10.0, { good }).advance()
        }
    }

    @Test
    fun `a law of ice is elastic up to its speed, the speed included`() {
        val law = BridgesRestitution(0.34, exponent = -1.0)
        assertEquals(1.0, law.coefficient(0.34), 1e-15)
        assertEquals(0.5, law.coefficient(0.68), 1e-15)
        val plastic = BorderiesRestitution(0.25)
        assertEquals(1.0, plastic.coefficient(0.25))
        // x = 1/4: the root of −1/6 + √(5/6 − 5/144).
        val expected = Math.sqrt(-1.0 / 6 + Math.sqrt(5.0 / 6 - 5.0 / 144))
        assertEquals(expected, plastic.coefficient(0.5), 1e-15)
    }
}
