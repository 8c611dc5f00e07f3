package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Open
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillFrame
import daphnis.core.hill.Satellite
import daphnis.core.population.Population
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI

/**
 * Section 6 of the validation targets: what a moon does to a ring it passes, without collisions. Hill's problem with Ω
 * = 1 and the Hill radius 1, so G m = 3. Julian & Toomre 1966 and Goldreich & Tremaine 1982 have the impulse: e =
 * 2.2396 G m / b² for a passage at distance b.
 */
@Tag("physics")
class SatelliteWakeTest {
    private val moon = Satellite(3.0, Epicycle(0.0, 0.0, 0.0, 0.0), 1.0)

    /** Particles on circles at radial distance [b], along [along] of azimuth upstream, carried past the moon. */
    private fun passed(b: Double, along: DoubleArray, dt: Double): Population {
        val n = along.size
        val far = 400 * b
        val p = Population(
            DoubleArray(n) { b },
            DoubleArray(n) { far + along[it] },
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n) { -1.5 * b },
            DoubleArray(n),
            DoubleArray(n) { 1e-3 },
            DoubleArray(n) { 1.0 },
        )
        val simulation = Simulation(p, Open, null, FixedTimeStep(dt), listOf(moon, HillFrame(1.0)))
        while (simulation.time < 2 * far / (1.5 * b)) simulation.advance()
        return p
    }

    private fun elements(p: Population, k: Int) = Epicycle.of(p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k], 1.0)

    @Test
    fun `eccentricity that a passing moon leaves, and Jacobi's constant`() {
        for ((b, ratio) in listOf(10.0 to 1.0084, 8.0 to 1.017, 6.0 to 1.041, 4.0 to 1.16)) {
            val p = passed(b, doubleArrayOf(0.0), 0.004)
            val e = elements(p, 0)
            assertPhysics("e / (2.2396 μ/x²) at $b Hill radii", ratio, e.e / (2.2396 * 3.0 / (b * b)), 0.002)
            assertPhysics(
                "Jacobi, (X² − x²)·3/(4e²), at $b Hill radii",
                1.0,
                (e.guidingX * e.guidingX - b * b) * 0.75 / (e.e * e.e),
                0.0004,
            )
        }
    }

    @Test
    fun `wavelength of the wake along the orbit`() {
        val b = 10.0
        val wavelength = 3 * PI * b
        // A fit of the phases of particles spread over two waves: φ grows by 2π a wavelength.
        val n = 41
        val p = passed(b, DoubleArray(n) { it * 2 * wavelength / (n - 1) }, 0.02)
        var last = 0.0
        val phases = DoubleArray(n)
        val places = DoubleArray(n)
        for (k in 0 until n) {
            val e = elements(p, k)
            var phase = e.phase
            while (k > 0 && phase - last > PI) phase -= 2 * PI
            while (k > 0 && phase - last < -PI) phase += 2 * PI
            phases[k] = phase
            places[k] = e.guidingY
            last = phase
        }
        assertPhysics("λ / 3πΔa of a satellite wake", 1.0, 2 * PI / Math.abs(slope(places, phases)) / wavelength, 0.005)
    }

    private fun slope(x: DoubleArray, y: DoubleArray): Double {
        val mx = x.average()
        val my = y.average()
        return x.indices.sumOf { (x[it] - mx) * (y[it] - my) } / x.sumOf { (it - mx) * (it - mx) }
    }

    @Test
    fun `Pan and the edge of the Encke gap`() {
        // μ = 8.71e-12 at a = 133,584 km, Δa = 162 km; lengths in km, Ω = 1.
        val a = 133_584.0
        val strength = 8.71e-12 * a * a * a
        val pan = Satellite(strength, Epicycle(-162.0, -16_200.0, 0.0, 0.0), 1.0)
        val p =
            Population(
                DoubleArray(1),
                DoubleArray(1),
                DoubleArray(1),
                DoubleArray(1),
                DoubleArray(1),
                DoubleArray(1),
                doubleArrayOf(1e-3),
                doubleArrayOf(1.0),
            )
        val simulation = Simulation(p, Open, null, FixedTimeStep(0.02), listOf(pan, HillFrame(1.0)))
        while (simulation.time < 32_400 / 243.0) simulation.advance()
        assertPhysics("a·e at the Encke gap after Pan has passed, km", 1.80, elements(p, 0).e, 0.01)
    }
}
