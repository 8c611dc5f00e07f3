package daphnis.core.hill

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Open
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs

/** Moons out of the plane, and moons that come back after a synodic period. */
class ReturningMoonTest {
    private val orbits = OrbitalFrequencies(1.0, 0.95, 1.04)

    @Test
    fun `an inclined moon rises through the plane at its node and is highest a quarter of its swing later`() {
        val spec = SatelliteSpec(mass = 1.0, x = -5.0, y = 3.0, inclination = 0.7, node = 0.0)
        val moon = Satellite(1.0, spec.orbit, orbits)
        assertEquals(0.0, moon.state(0.0)[2], 1e-15)
        assertEquals(0.7 * 1.04, moon.state(0.0)[5], 1e-15)
        assertEquals(0.7, moon.state(PI / 2 / 1.04)[2], 1e-15)
        val later = SatelliteSpec(mass = 1.0, x = -5.0, y = 3.0, inclination = 0.7, node = 1.2)
        assertEquals(0.7, Satellite(1.0, later.orbit, orbits).state((PI / 2 - 1.2) / 1.04)[2], 1e-15)
    }

    @Test
    fun `a returning moon is where it was after a synodic period, with the phases of its own frequencies`() {
        val circumference = 700.0
        val orbit = Epicycle(-5.0, 3.0, 0.5, 0.3, 0.2, 0.1)
        val moon = Satellite(1.0, orbit, orbits, circumference = circumference)
        val once = Satellite(1.0, orbit, orbits)
        val period = circumference / (orbits.shearRate * 5)
        for (t in listOf(0.0, 11.0, 0.4 * period)) {
            val returned = orbit.after(t, orbits).let {
                Epicycle(
                    it.guidingX,
                    it.guidingY,
                    it.e,
                    it.phase + orbits.kappa * 3 * period,
                    it.i,
                    it.verticalPhase + orbits.nu * 3 * period,
                )
            }
            val expected = returned.state(orbits)
            val seen = moon.state(t + 3 * period)
            for (k in expected.indices) assertEquals(expected[k], seen[k], 1e-10) { "component $k at $t" }
            // Until it first goes far, it is the moon that passes once, to the bit.
            assertTrue(once.state(t).contentEquals(moon.state(t)))
        }
        for (k in 0..400) assertTrue(abs(moon.state(k * period / 37)[1]) <= circumference / 2 + 2 / 0.95 * 0.5)
        assertThrows(IllegalArgumentException::class.java) { Satellite(1.0, orbit, orbits, circumference = 0.0) }
    }

    /**
     * Eccentricity of a particle at x = 0 after one passage and after two of a moon at −10 Hill radii, which returns
     * after [epicycles] of the frame's κ.
     */
    private fun afterPassages(epicycles: Double): Pair<Double, Double> {
        val distance = 10.0
        val period = epicycles * 2 * PI / orbits.kappa
        val circumference = period * orbits.shearRate * distance
        val start = Epicycle(-distance, -circumference / 2, 0.0, 0.0)
        val moon = Satellite(3.0, start, orbits, circumference = circumference)
        val zero = { DoubleArray(1) }
        val p = Population(
            zero(),
            zero(),
            zero(),
            zero(),
            zero(),
            zero(),
            doubleArrayOf(1e-3),
            doubleArrayOf(1.0),
        )
        val simulation = Simulation(p, Open, null, FixedTimeStep(period / 2000), listOf(moon, HillFrame(orbits)))
        fun e() = Epicycle.of(p.x[0], p.y[0], p.z[0], p.vx[0], p.vy[0], p.vz[0], orbits).e
        repeat(2000) { simulation.advance() }
        val once = e()
        repeat(2000) { simulation.advance() }
        return once to e()
    }

    /** The resonance is with κ: with Kepler's, six periods would be 5.7 epicycles. */
    @Test
    fun `passages add up where a moon returns after whole epicycles, and cancel half-way between`() {
        val (first, resonant) = afterPassages(6.0)
        assertEquals(2.0, resonant / first, 0.05)
        val (other, cancelled) = afterPassages(6.5)
        assertTrue(cancelled < 0.1 * other) { "$cancelled after $other" }
    }
}
