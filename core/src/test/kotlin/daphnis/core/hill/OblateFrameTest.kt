package daphnis.core.hill

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.PopulationSums
import daphnis.core.populationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

/** Hill's frame around a planet whose orbits have κ ≠ Ω ≠ ν. */
class OblateFrameTest {
    private val omega = 1.3
    private val cases = listOf(OrbitalFrequencies(omega, 0.95, 1.05), OrbitalFrequencies(omega, 1.4, 0.3))
    private val start = Epicycle(1.5, -0.5, 0.8, 0.3, 0.4, 2.0)

    @Test
    fun `free paths keep their epicycle to 1e-12 an orbit`() {
        for (f in cases) {
            for (steps in listOf(6, 100)) {
                val s = start.state(f)
                val p = populationOf(Sphere(s[0], s[1], s[2], s[3], s[4], s[5]))
                val simulation =
                    Simulation(p, Open, null, FixedTimeStep(2 * Math.PI / omega / steps), listOf(HillFrame(f)))
                repeat(steps * 10) { simulation.advance() }
                val expected = start.after(simulation.time, f).state(f)
                val found = doubleArrayOf(p.x[0], p.y[0], p.z[0], p.vx[0], p.vy[0], p.vz[0])
                val scale = maxOf(1.0, abs(expected[1]))
                for (k in 0..5) {
                    assertEquals(expected[k], found[k], 1e-11 * scale) {
                        "component $k of $f, $steps steps"
                    }
                }
            }
        }
    }

    /** The epicycle itself, against the equations of motion: a step of Runge and Kutta's, without elements. */
    @Test
    fun `an epicycle solves the equations of motion`() {
        for (f in cases) {
            fun rate(s: DoubleArray) = doubleArrayOf(
                s[3],
                s[4],
                s[5],
                2 * omega * s[4] + (4 * omega * omega - f.kappa * f.kappa) * s[0],
                -2 * omega * s[3],
                -f.nu * f.nu * s[2],
            )
            fun moved(s: DoubleArray, by: DoubleArray, h: Double) = DoubleArray(6) { s[it] + h * by[it] }
            var s = start.state(f)
            val h = 1e-3
            repeat(3000) {
                val a = rate(s)
                val b = rate(moved(s, a, h / 2))
                val c = rate(moved(s, b, h / 2))
                val d = rate(moved(s, c, h))
                s = DoubleArray(6) { k -> s[k] + h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]) }
            }
            val expected = start.after(3.0, f).state(f)
            for (k in 0..5) assertEquals(expected[k], s[k], 1e-10) { "component $k" }
        }
    }

    @Test
    fun `elements and state are each other's inverse`() {
        for (f in cases) {
            val s = start.state(f)
            val back = Epicycle.of(s[0], s[1], s[2], s[3], s[4], s[5], f)
            assertEquals(start.guidingX, back.guidingX, 1e-14)
            assertEquals(start.guidingY, back.guidingY, 1e-14)
            assertEquals(start.e, back.e, 1e-14)
            assertEquals(start.phase, back.phase, 1e-14)
            assertEquals(start.i, back.i, 1e-14)
            assertEquals(start.verticalPhase, back.verticalPhase, 1e-14)
            assertEquals(back.guidingX - s[0], f.inwards(s[0], s[4]), 1e-14)
        }
    }

    @Test
    fun `satellites and sums are of these orbits`() {
        for (f in cases) {
            val moon = Satellite(1.0, start, f)
            assertArrayEquals(start.after(2.0, f).state(f), moon.state(2.0))
            val s = start.state(f)
            val sums = PopulationSums(HillSheet(Box.centred(10.0, 20.0, 4.0), f).meanFlow, f)
            sums.take(populationOf(Sphere(s[0], s[1], s[2], s[3], s[4], s[5])))
            assertEquals(start.guidingX, sums.guidingX, 1e-13)
        }
    }

    @Test
    fun `a particle that comes back through a face keeps e, i and phases`() {
        for (f in cases) {
            val sheet = HillSheet(Box.centred(10.0, 20.0, 4.0), f)
            for (side in listOf(1.0, -1.0)) {
                val p = populationOf(
                    Sphere(x = side * 5.3, y = 1.0, z = 0.3, vx = 0.4, vy = -f.shearRate * side * 5.3 + 0.2, vz = -0.1),
                )
                fun elements() = Epicycle.of(p.x[0], p.y[0], p.z[0], p.vx[0], p.vy[0], p.vz[0], f)
                val before = elements()
                sheet.endStep(p, 3.7)
                val after = elements()
                assertEquals(before.guidingX - side * 10.0, after.guidingX, 1e-13)
                assertEquals(before.e, after.e, 1e-13)
                assertEquals(before.phase, after.phase, 1e-13)
                val shift = (p.y[0] - 1.0 - side * f.shearRate * 10.0 * 3.7) / 20.0
                assertEquals(Math.rint(shift), shift, 1e-12)
            }
        }
    }

    /** Chords are the same map for all, so a collision changes no sum of guiding centres. */
    @Test
    fun `collisions conserve Σ m X, and with ε = 1 the energy, as short steps show`() {
        for (f in cases) {
            val random = SeededRandom(4)
            val p = populationOf(
                *Array(60) {
                    val x = it % 4 * 1.2 - 2
                    fun some() = 0.3 * random.nextGaussian()
                    Sphere(x, it / 4 % 4 * 1.2, it / 16 * 1.2, some(), some() - f.shearRate * x, some(), r = 0.5)
                },
            )
            val frame = HillFrame(f)
            fun sum() = (0 until p.size).sumOf { f.guidingX(p.x[it], p.vy[it]) }
            fun energy(): Double {
                val potential = DoubleArray(p.size).also { frame.potentialEnergies(p, 0.0, 0, p.size, it) }
                return potential.sum() + (0 until p.size).sumOf {
                    (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) / 2
                }
            }
            val before = sum()
            val energyBefore = energy()
            val forcing = CollisionForcing(ConstantRestitution(1.0))
            val simulation = Simulation(p, Open, forcing, FixedTimeStep(1e-4), listOf(frame))
            repeat(5000) { simulation.advance() }
            assertTrue(forcing.counters.collisions > 10)
            assertEquals(before, sum(), 1e-10)
            assertEquals(energyBefore, energy(), 1e-5 * abs(energyBefore))
        }
    }
}
