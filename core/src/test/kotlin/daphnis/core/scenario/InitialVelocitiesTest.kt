package daphnis.core.scenario

import daphnis.core.input.InputException
import daphnis.core.population.Conserved
import daphnis.core.population.Population
import daphnis.core.population.granularTemperature
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class InitialVelocitiesTest {
    private fun scenario(
        velocities: String,
        count: Int = 2000,
        sizes: String = WIDE,
        boundary: String = """{ "type": "periodic" }""",
    ) = ScenarioJson.parse(
        """{
          "box": { "lengths": [60, 60, 60] }, "boundary": $boundary,
          "particles": { "count": $count, "sizes": $sizes }, "velocities": $velocities,
          "restitution": { "type": "constant", "coefficient": 1 },
          "timeStep": { "type": "fixed", "dt": 0.01 }, "until": 1
        }""",
        "test",
    )

    private fun population(velocities: String, count: Int = 2000, sizes: String = WIDE): Population =
        ScenarioSetup.of(scenario(velocities, count, sizes), "test").population

    private fun Population.speeds2() = DoubleArray(size) { vx[it] * vx[it] + vy[it] * vy[it] + vz[it] * vz[it] }

    @Test
    fun `spheres of unequal mass start without momentum, not only without mean velocity`() {
        for (velocities in listOf(
            """{ "type": "gaussian", "sigma": 1 }""",
            """{ "type": "uniform", "halfWidth": 1 }""",
        )) {
            val sums = Conserved.of(population(velocities))
            for (p in listOf(sums.momentumX, sums.momentumY, sums.momentumZ)) {
                assertEquals(0.0, p / sums.mass, 1e-14) {
                    velocities
                }
            }
        }
        val left = Conserved.of(population("""{ "type": "gaussian", "sigma": 1, "zeroMomentum": false }"""))
        assertTrue(Math.abs(left.momentumX / left.mass) > 1e-3)
    }

    @Test
    fun `one temperature gives all sizes the same mean energy`() {
        val p = population("""{ "type": "gaussian", "temperature": 0.7 }""", count = 6000)
        val square = p.speeds2()
        for ((from, to) in listOf(0.2 to 0.4, 0.4 to 0.6, 0.6 to 0.81)) {
            val some = (0 until p.size).filter { p.radius[it] >= from && p.radius[it] < to }
            val t = some.sumOf { p.mass[it] * square[it] } / 3 / some.size
            // The relative error of a mean of n squares of three components is sqrt(2/3n).
            assertEquals(0.7, t, 4 * 0.7 * sqrt(2.0 / 3 / some.size)) { "radii from $from to $to: ${some.size}" }
        }
    }

    /** ⟨c²⟩/3 by mass around the centre of mass. */
    private fun plainTemperature(p: Population): Double {
        val all = Conserved.of(p)
        val mean = all.momentumX * all.momentumX + all.momentumY * all.momentumY + all.momentumZ * all.momentumZ
        return (2 * all.kineticEnergy / all.mass - mean / all.mass / all.mass) / 3
    }

    @Test
    fun `exact is exact, for the dispersion as for the temperature, with the momentum that was asked for`() {
        val sigma = population("""{ "type": "gaussian", "sigma": 0.3, "exact": true }""", count = 50)
        assertEquals(0.09, granularTemperature(sigma, null), 1e-15)
        // In each component the centre of mass has taken one of 50 degrees of freedom.
        assertEquals(0.09 * 49 / 50, plainTemperature(sigma), 1e-15)
        assertEquals(0.0, Conserved.of(sigma).momentumX / Conserved.of(sigma).mass, 1e-15)
        val hot = population("""{ "type": "gaussian", "temperature": 2, "exact": true }""", count = 50)
        assertEquals(2.0, (0 until 50).sumOf { hot.mass[it] * hot.speeds2()[it] } / 147, 1e-13)
        val drawn = population("""{ "type": "gaussian", "sigma": 0.3, "zeroMomentum": false }""", count = 50)
        val moving =
            population("""{ "type": "gaussian", "sigma": 0.3, "zeroMomentum": false, "exact": true }""", count = 50)
        assertEquals(Conserved.of(drawn).momentumY, Conserved.of(moving).momentumY, 1e-14) {
            "the centre of mass goes on as drawn"
        }
        assertEquals(0.09, granularTemperature(moving, null), 1e-15)
        val rest = population("""{ "type": "gaussian", "sigma": 0, "exact": true }""", count = 50)
        assertTrue(rest.speeds2().all { it == 0.0 })
    }

    @Test
    fun `the temperature that is asked for is the one that is read, in every box`() {
        val boundaries = listOf(
            """{ "type": "periodic" }""",
            """{ "type": "lees-edwards", "shearRate": 0.2 }""",
            """{ "type": "sheared-periodic", "velocityJump": 3 }""",
        )
        for (boundary in boundaries) {
            for (count in listOf(2, 3, 5, 300, 2000)) {
                for (flow in setOf(false, "periodic" !in boundary)) {
                    val hot = """"type": "gaussian", "temperature": 1, "exact": true"""
                    val velocities = """{ $hot, "shearProfile": $flow }"""
                    val setup = ScenarioSetup.of(scenario(velocities, count, boundary = boundary), "test")
                    val p = setup.population
                    // Of two spheres the straight flow of the boundary is taken as it is, whether it is there or not.
                    if (count == 2 && !flow && setup.boundary.meanFlow != null) continue
                    val read = granularTemperature(p, setup.boundary.meanFlow) * p.mass.average()
                    assertEquals(1.0, read, 1e-12) { "$boundary, $count spheres, flow $flow" }
                }
            }
        }
    }

    @Test
    fun `equal masses give the bits they gave with the plain mean`() {
        val equal = """{ "type": "equal", "radius": 0.5 }"""
        val p = population("""{ "type": "gaussian", "sigma": 1.3 }""", 777, equal)
        val drawn = population("""{ "type": "gaussian", "sigma": 1.3, "zeroMomentum": false }""", 777, equal)
        val mean = drawn.vx.sum() / 777
        assertArrayEquals(DoubleArray(777) { drawn.vx[it] - mean }, p.vx)
        // With mass 1 a temperature of σ² is the same draw.
        val unit = """{ "type": "equal", "radius": ${Math.cbrt(0.75 / Math.PI)} }"""
        val hot = population("""{ "type": "gaussian", "temperature": 1.69 }""", 777, unit)
        val cold = population("""{ "type": "gaussian", "sigma": 1.3 }""", 777, unit)
        assertArrayEquals(cold.vy, hot.vy, 1e-14)
    }

    @Test
    fun `what contradicts itself is one line that names the key`() {
        fun wrong(velocities: String, vararg words: String, count: Int = 10) {
            val e = assertThrows(InputException::class.java) { ScenarioSetup.of(scenario(velocities, count), "test") }
            for (word in words) assertTrue(word in e.message.orEmpty()) { e.message }
        }
        wrong("""{ "type": "gaussian" }""", "velocities", "exactly one of sigma and temperature")
        wrong("""{ "type": "gaussian", "sigma": 1, "temperature": 1 }""", "exactly one of sigma and temperature")
        wrong("""{ "type": "gaussian", "temperature": -1 }""", "velocities.temperature", "-1.0", "at least 0")
        wrong("""{ "type": "gaussian", "sigma": 1, "exact": true }""", "velocities.exact", "two particles", count = 1)
        assertThrows(InputException::class.java) {
            scenario("""{ "type": "uniform", "halfWidth": 1, "exact": true }""")
        }
    }

    private companion object {
        const val WIDE = """{ "type": "power-law", "minimum": 0.2, "maximum": 0.8, "exponent": 2 }"""
    }
}
