package daphnis.core.hill

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.hypot

class HillFrameTest {
    private val omega = 1.3
    private val orbit = 2 * Math.PI / omega

    private fun at(e: Epicycle, verticalFactor: Double = 1.0): Population {
        val s = e.state(omega, verticalFactor)
        return populationOf(Sphere(s[0], s[1], s[2], s[3], s[4], s[5]))
    }

    @Test
    fun `a free particle keeps its epicycle to 1e-12 an orbit, for steps of a thousandth to a quarter of an orbit`() {
        for (steps in listOf(4, 7, 100, 1000)) {
            for (verticalFactor in listOf(1.0, 0.0, 0.7)) {
                val start = Epicycle(
                    1.5,
                    -0.5,
                    0.8,
                    0.3,
                    if (verticalFactor == 0.0) {
                        0.0
                    } else {
                        0.4
                    },
                    if (verticalFactor == 0.0) 0.0 else 2.0,
                )
                val p = at(start, verticalFactor.coerceAtLeast(0.1))
                if (verticalFactor == 0.0) p.z[0] = 0.0
                val simulation =
                    Simulation(p, Open, null, FixedTimeStep(orbit / steps), listOf(HillFrame(omega, verticalFactor)))
                val orbits = 10
                repeat(steps * orbits) { simulation.advance() }
                val expected = start.after(
                    simulation.time,
                    omega,
                    verticalFactor,
                ).state(omega, verticalFactor.coerceAtLeast(0.1))
                val found = doubleArrayOf(p.x[0], p.y[0], p.z[0], p.vx[0], p.vy[0], p.vz[0])
                // y runs away with the shear: its scale is how far it has come.
                val scale = maxOf(1.0, abs(expected[1]))
                for (k in 0..5) {
                    assertEquals(expected[k], found[k], 1e-12 * orbits * scale) {
                        "component $k, $steps steps, vertical factor $verticalFactor"
                    }
                }
            }
        }
    }

    @Test
    fun `elements and state are each other's inverse, and the two phases stand where the definition says`() {
        val e = Epicycle(2.0, 3.0, 0.5, 1.0, 0.2, -0.7)
        val s = e.state(omega, 1.4)
        val back = Epicycle.of(s[0], s[1], s[2], s[3], s[4], s[5], omega, 1.4)
        assertEquals(e.guidingX, back.guidingX, 1e-14)
        assertEquals(e.guidingY, back.guidingY, 1e-14)
        assertEquals(e.e, back.e, 1e-14)
        assertEquals(e.phase, back.phase, 1e-14)
        assertEquals(e.i, back.i, 1e-14)
        assertEquals(e.verticalPhase, back.verticalPhase, 1e-14)
        // φ = atan2(y − Y, 2(X − x)), i = √(z² + v_z²) in units of Ω = 1.
        assertEquals(e.phase, Math.atan2(s[1] - e.guidingY, 2 * (e.guidingX - s[0])), 1e-14)
        assertEquals(2.0 - 0.5 * Math.cos(1.0), s[0], 1e-15)
    }

    @Test
    fun `a particle that comes back through a face keeps e, i and phases, its guiding centre shifts with the image`() {
        val box = Box.centred(10.0, 20.0, 4.0)
        val sheet = HillSheet(box, omega)
        val time = 3.7
        for (side in listOf(1.0, -1.0)) {
            val p =
                populationOf(
                    Sphere(x = side * 5.3, y = 1.0, z = 0.3, vx = 0.4, vy = -1.5 * omega * side * 5.3 + 0.2, vz = -0.1),
                )
            fun elements() = Epicycle.of(p.x[0], p.y[0], p.z[0], p.vx[0], p.vy[0], p.vz[0], omega)
            val before = elements()
            sheet.endStep(p, time)
            val after = elements()
            assertEquals(before.guidingX - side * 10.0, after.guidingX, 1e-13)
            assertEquals(before.e, after.e, 1e-13)
            assertEquals(before.phase, after.phase, 1e-13)
            assertEquals(before.i, after.i, 1e-15)
            assertEquals(before.verticalPhase, after.verticalPhase, 1e-15)
            // x by −L_x: y by +1.5 Ω L_x t (mod L_y), v_y by +1.5 Ω L_x.
            val shift = (p.y[0] - 1.0 - side * 1.5 * omega * 10.0 * time) / 20.0
            assertEquals(Math.rint(shift), shift, 1e-12)
        }
    }

    @Test
    fun `a pair that meets through a radial face meets as its images inside do`() {
        val box = Box.centred(10.0, 20.0, 4.0)
        fun outcome(x: Double, wrapped: Boolean): DoubleArray {
            // Two spheres on one circle, the inner one catching up; displaced by half a box radially they straddle the
            // face.
            val a = Epicycle(x - 0.3, -1.5, 0.1, 0.4).state(omega)
            val b = Epicycle(x + 0.3, 1.5, 0.1, 2.0).state(omega)
            val p =
                populationOf(Sphere(a[0], a[1], 0.0, a[3], a[4], r = 0.5), Sphere(b[0], b[1], 0.0, b[3], b[4], r = 0.5))
            val boundary = if (wrapped) HillSheet(box, omega) else Open
            if (wrapped) boundary.endStep(p, 0.0)
            val simulation =
                Simulation(
                    p,
                    boundary,
                    CollisionForcing(ConstantRestitution(0.5)),
                    FixedTimeStep(0.02),
                    listOf(HillFrame(omega)),
                )
            repeat(150) { simulation.advance() }
            assertEquals(1L, simulation.collisions!!.counters.collisions) { "x $x, wrapped $wrapped" }
            val q = (0..1).map { p.indexOf(it) }
            return doubleArrayOf(
                p.vx[q[0]],
                p.vx[q[1]],
                p.vz[q[0]],
                p.x[q[1]] - p.x[q[0]] - 10 * Math.rint((p.x[q[1]] - p.x[q[0]]) / 10),
            )
        }
        val inside = outcome(0.0, false)
        for (x in listOf(0.0, 5.0, 4.8, -5.1)) {
            val through = outcome(x, true)
            for (k in inside.indices) assertEquals(inside[k], through[k], 1e-11) { "x $x, number $k" }
        }
    }

    @Test
    fun `collisions conserve Σ m X and Σ m Y to round-off, however many and however long the step`() {
        val random = SeededRandom(4)
        val spheres = Array(60) {
            val x = it % 4 * 1.2 - 2
            Sphere(
                x,
                it / 4 % 4 * 1.2,
                it / 16 * 1.2,
                0.3 * random.nextGaussian(),
                -1.5 * omega * x + 0.3 * random.nextGaussian(),
                0.3 * random.nextGaussian(),
                r = 0.5,
                m =
                1 + it % 3.0,
            )
        }
        for (dt in listOf(0.01, 0.3)) {
            val p = populationOf(*spheres)
            fun sums(): DoubleArray {
                var gx = 0.0
                var gy = 0.0
                for (k in 0 until p.size) {
                    gx += p.mass[k] * Epicycle.guidingX(p.x[k], p.vy[k], omega)
                    gy += p.mass[k] * Epicycle.guidingY(p.y[k], p.vx[k], omega)
                }
                return doubleArrayOf(gx, gy)
            }
            val before = sums()
            val simulation =
                Simulation(
                    p,
                    Open,
                    CollisionForcing(ConstantRestitution(0.5)),
                    FixedTimeStep(dt),
                    listOf(HillFrame(omega)),
                )
            repeat(100) { simulation.advance() }
            assertTrue(simulation.collisions!!.counters.collisions > 50)
            val after = sums()
            val mass = p.mass.sum()
            assertEquals(before[0], after[0], 1e-12 * mass * 10)
            assertEquals(
                before[1] - 1.5 * omega * before[0] * simulation.time,
                after[1],
                1e-12 * mass * hypot(10.0, simulation.time * 10),
            )
        }
    }

    @Test
    fun `steps beyond a quarter of an orbit and two frames are refused`() {
        val p = populationOf(Sphere())
        val long = Simulation(p, Open, null, FixedTimeStep(0.3 * orbit), listOf(HillFrame(omega)))
        assertTrue(assertThrows(IllegalArgumentException::class.java) { long.advance() }.message!!.contains("quarter"))
        assertThrows(IllegalArgumentException::class.java) {
            Simulation(p, Open, null, FixedTimeStep(0.1), listOf(HillFrame(1.0), HillFrame(1.0)))
        }
        assertThrows(IllegalArgumentException::class.java) { HillFrame(0.0) }
    }
}
