package daphnis.core.physics

import daphnis.core.Output
import daphnis.core.boundary.LeesEdwards
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.run.CollisionStatistics
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

/**
 * Section 4 of the validation targets: uniform shear flow between Lees–Edwards images, γ = 1, N = 2048, measured by an
 * independent code.
 */
@Tag("physics")
class ShearFlowTest {
    private class Case(
        val e: Double,
        val filling: Double,
        val temperature: Double,
        val pressure: Double,
        val stress: Double,
    )

    private val cases = listOf(
        Case(0.8, 0.01, 297.0, 3.08, 1.335), Case(0.8, 0.1, 3.00, 0.440, 0.170), Case(0.8, 0.3, 0.514, 0.596, 0.230),
        Case(0.9, 0.01, 631.0, 6.55, 2.130), Case(0.9, 0.1, 6.36, 0.951, 0.275), Case(0.9, 0.3, 1.137, 1.339, 0.374),
        Case(
            0.95,
            0.01,
            1302.0,
            13.54,
            3.208,
        ),
        Case(0.95, 0.1, 13.06, 1.970, 0.411), Case(0.95, 0.3, 2.390, 2.837, 0.565),
    )

    @Test
    fun `temperature, pressure, shear stress and dissipation of uniform shear flow`() {
        val wanted = when {
            fullPhysics -> cases
            quickPhysics -> cases.filter { it.e == 0.9 && it.filling == 0.1 }
            else -> cases.filter { it.e == 0.9 && it.filling > 0.05 || it.e == 0.8 && it.filling == 0.3 }
        }
        for (case in wanted) {
            // One run of 160 strains scatters by one to two per cent.
            val runs = (if (fullPhysics) 1L..3L else 1L..1L).map { measure(case, it) }
            fun mean(k: Int) = runs.map { it[k] }.average()
            val name = "e = ${case.e}, φ = ${case.filling}"
            assertPhysics("T*, $name", case.temperature, mean(0), if (fullPhysics) 0.03 else 0.04)
            assertPhysics("p*, $name", case.pressure, mean(1), 0.04)
            assertPhysics("τ*, $name", case.stress, mean(2), 0.04)
            assertPhysics("loss/(τγ), $name", 1.0, mean(3), if (fullPhysics) 0.01 else 0.02)
        }
    }

    /**
     * DynamO's own test (src/dynamo/tests/shearing_test.cpp, revision 08346f1): 1372 spheres from an fcc lattice, nσ³ =
     * 0.5, e = 0.9, after some 80 strains; a mean free time of 0.113195634 to 1 %.
     */
    @Test
    fun `spheres collide as often as those of DynamO`() {
        val count = 1372
        val box = cube(count, 0.5 * Math.PI / 6)
        val settle = if (fullPhysics) 80.0 else 30.0
        val statistics = CollisionStatistics(from = settle)
        val p = gas(count, box, 1, true, shearRate = 1.0)
        val guard = FloorSpeedGuard(1e-6)
        val end = settle + if (fullPhysics) 165.0 else 40.0
        gasSimulation(p, LeesEdwards(box, 1.0), 0.02, 0.9, guard, record = true, outputs = listOf(statistics)).use {
            while (it.time < end) it.advance()
            val rate = 2.0 * statistics.count / count / (it.time - settle)
            assertPhysics("ν, e = 0.9, nσ³ = 0.5, γ = 1", 1 / 0.113195634, rate, if (fullPhysics) 0.01 else 0.015)
        }
    }

    /** @return temperature, pressure, shear stress, loss over work */
    private fun measure(case: Case, seed: Long): DoubleArray {
        val count = 2048
        val box = cube(count, case.filling)
        val settle = 40.0
        val strain = if (fullPhysics) 160.0 else 60.0
        val p = gas(count, box, seed, true, shearRate = 1.0)
        // Start near the steady temperature: peculiar velocities scaled, the flow kept.
        val hot = sqrt(case.temperature)
        for (k in 0 until count) {
            p.vx[k] = (p.vx[k] - p.y[k]) * hot + p.y[k]
            p.vy[k] *= hot
            p.vz[k] *= hot
        }
        val statistics = CollisionStatistics(from = settle)
        val kinetic = DoubleArray(2)
        var samples = 0
        val sampling = Output { s ->
            if (s.time > settle) {
                samples++
                for (k in 0 until count) {
                    val c = s.population.vx[k] - s.population.y[k]
                    kinetic[0] +=
                        c * c + s.population.vy[k] * s.population.vy[k] + s.population.vz[k] * s.population.vz[k]
                    kinetic[1] += c * s.population.vy[k]
                }
            }
        }
        // About a fifth of a collision a sphere and step, and less than a tenth of the box.
        val dt = minOf(0.15 / (13.5 * case.filling * hot), 0.1 * box.length(0) / (4 * hot + box.length(0)))
        val simulation =
            gasSimulation(
                p,
                LeesEdwards(box, 1.0),
                dt,
                case.e,
                FloorSpeedGuard(1e-6),
                record = true,
                outputs = listOf(statistics, sampling),
            )
        while (simulation.time < settle + strain) simulation.advance()
        val elapsed = simulation.time - settle
        // Stresses in ρ_p σ² γ² with ρ_p = mass / volume of a sphere.
        val unit = box.volume * (6 / Math.PI)
        val temperature = kinetic[0] / samples / count / 3
        val collisional = (statistics.virial[0] + statistics.virial[4] + statistics.virial[8]) / 3 / elapsed
        val pressure = (kinetic[0] / samples / 3 + collisional) / unit
        val stress = -(kinetic[1] / samples + statistics.virial[1] / elapsed) / unit
        return doubleArrayOf(temperature, pressure, stress, statistics.dissipated / elapsed / (stress * unit))
    }
}
