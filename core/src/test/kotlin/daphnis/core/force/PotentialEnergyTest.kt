package daphnis.core.force

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.boundary.Walls
import daphnis.core.boundary.prepare
import daphnis.core.engine.CollisionForcing
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.hill.Satellite
import daphnis.core.initial.SeededRandom
import daphnis.core.permuted
import daphnis.core.population.Conserved
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class PotentialEnergyTest {
    private val box = Box.centred(10.0, 12.0, 8.0)

    private fun total(s: Simulation): Double = Conserved.of(s.population).kineticEnergy +
        s.forces.sumOf { it.potentialEnergy(s.population, s.boundary, s.time) }

    @Test
    fun `two spheres by hand`() {
        val p = populationOf(Sphere(x = -2.0, m = 3.0), Sphere(x = 1.0, y = 4.0, m = 2.0))
        assertEquals(-0.7 * 6 / 5, SelfGravity(Open, 0.7).potentialEnergy(p, Open, 0.0), 1e-15)
        assertEquals(
            -0.7 * 6 / sqrt(26.0),
            SelfGravity(Open, 0.7, softening = 1.0).potentialEnergy(p, Open, 0.0),
            1e-15,
        )
        assertEquals(-0.7 * 6 / 5, BodyGravity(intArrayOf(1), Open, 0.7).potentialEnergy(p, Open, 0.0), 1e-15)
        // Each pair once, also when both are bodies; what was removed is passed over.
        assertEquals(-0.7 * 6 / 5, BodyGravity(intArrayOf(0, 1, 9), Open, 0.7).potentialEnergy(p, Open, 0.0), 1e-15)
        assertEquals(
            -(3 * (-2 * 0.5 + 0) + 2 * (1 * 0.5 + 4 * 2)),
            UniformAcceleration(0.5, 2.0, 0.0).potentialEnergy(p, Open, 0.0),
        )
        val moon = Satellite(5.0, Epicycle(1.0, 0.0, 0.0, 0.0), omega = 2.0)
        // At time 0 it is at (1, 0, 0), a time later at (1, −3, 0).
        assertEquals(-5.0 * (3 / 3.0 + 2 / 4.0), moon.potentialEnergy(p, Open, 0.0), 1e-14)
        assertEquals(-5.0 * (3 / sqrt(18.0) + 2 / 7.0), moon.potentialEnergy(p, Open, 1.0), 1e-14)
        val hill = HillFrame(
            2.0,
            3.0,
        ).potentialEnergy(populationOf(Sphere(x = 5.0, y = 7.0, z = 0.5, m = 2.0)), Open, 0.0)
        assertEquals(2 * (-1.5 * 4 * 25 + 0.5 * 36 * 0.25), hill, 1e-12)
    }

    @Test
    fun `through a periodic face a body has the nearest image, and uniform gravity has no potential energy`() {
        val p = populationOf(Sphere(x = -4.0), Sphere(x = 4.0, m = 3.0))
        assertEquals(
            -3 / 2.0,
            BodyGravity(intArrayOf(0), Periodic(box), 1.0).potentialEnergy(p, Periodic(box), 0.0),
            1e-15,
        )
        val down = UniformAcceleration(0.0, 0.0, -1.0)
        for (boundary in listOf(
            Periodic(box),
            LeesEdwards(box, 1.0),
            ShearedPeriodic(box, 1.0),
            Walls(box, walled = booleanArrayOf(true, true, false)),
        )) {
            assertTrue(down.potentialEnergy(p, boundary, 0.0).isNaN())
        }
        for (boundary in listOf(
            Open,
            Walls(box),
            Periodic(box, periodicZ = false),
            HillSheet(box, 1.0),
        )) {
            assertEquals(0.0, down.potentialEnergy(p, boundary, 0.0))
        }
        assertTrue(Kick { _, _, _ -> }.potentialEnergy(p, Open, 0.0).isNaN()) { "a force that does not say has none" }
    }

    @Tag("thorough")
    @Test
    fun `self-gravity has the direct sum over images that slide, in any order of the arrays`() {
        val sheet = HillSheet(box, 1.0)
        val random = SeededRandom(6)
        val p = randomSpheres(120, sheet, 3, 1.0) { 0.1 + 0.2 * random.nextDouble() }
        val time = 1.3
        val shifts = Images().also { it.prepare(sheet, time) }
        var expected = 0.0
        for (ix in -2..2) {
            val nearest = -Math.rint(ix * shifts.shearOffset / box.length(1)).toInt()
            for (iy in nearest - 2..nearest + 2) expected += pairs(p, shifts, Images.code(ix, iy, 0))
        }
        assertEquals(expected, SelfGravity(sheet, 2.0, 0.0, 0.1).potentialEnergy(p, sheet, time), 1e-9 * abs(expected))
        val tree = SelfGravity(sheet, 2.0, 0.5, 0.1).potentialEnergy(p, sheet, time)
        assertEquals(expected, tree, 1e-2 * abs(expected))
        assertEquals(tree, SelfGravity(sheet, 2.0, 0.5, 0.1).potentialEnergy(p.permuted(4), sheet, time))
    }

    private fun pairs(p: Population, shifts: Images, code: Int): Double {
        var energy = 0.0
        for (i in 0 until p.size) {
            for (j in 0 until p.size) {
                val dx = p.x[j] - p.x[i] + shifts.shift(code, 0)
                val dy = p.y[j] - p.y[i] + shifts.shift(code, 1)
                val dz = p.z[j] - p.z[i]
                if (i != j || code != 0) energy -= p.mass[i] * p.mass[j] * depth(sqrt(dx * dx + dy * dy), dz)
            }
        }
        return energy
    }

    /** −Φ/G of a unit of mass with softening 0.1 whose pull fades from 7.5 to 15, by Simpson's rule. */
    private fun depth(rho: Double, z: Double): Double {
        val from = maxOf(rho, 7.5)
        val h = maxOf(0.0, 15 - from) / 200
        var work = 0.0
        for (k in 0..200) {
            val a = from + k * h
            val t = (225 - a * a) / (225 - 56.25)
            val weight = if (k == 0 || k == 200) {
                1
            } else if (k % 2 == 1) {
                4
            } else {
                2
            }
            work += weight * h / 3 * t * t * (3 - 2 * t) * a / Math.pow(a * a + 0.01, 1.5)
        }
        return if (rho >= 7.5) work else work + 1 / sqrt(rho * rho + z * z + 0.01) - 1 / sqrt(7.5 * 7.5 + 0.01)
    }

    @Test
    fun `the slope of the potential is the force, also where it fades`() {
        // One pair in range: the box is so long that images are far away along it.
        val sheet = HillSheet(Box.centred(100.0, 90.0, 8.0), 1.0)
        fun at(x: Double) = populationOf(Sphere(x = -20.0, y = 3.0, m = 2.0), Sphere(x = x, y = 3.0, m = 5.0))
        fun gravity() = SelfGravity(sheet, 0.7, 0.0, 0.5, images = 0)
        for (x in listOf(-15.0, 2.0, 5.0, 15.0, 24.0)) {
            val h = 1e-3
            val slope =
                (gravity().potentialEnergy(at(x + h), sheet, 0.0) - gravity().potentialEnergy(at(x - h), sheet, 0.0)) /
                    (2 * h)
            val force = 5.0 * gravity().accelerations(at(x), 0.0)[0][1]
            assertEquals(-slope, force, 1e-6 * abs(force)) { "at $x" }
            assertTrue(force < 0)
        }
        assertEquals(0.0, gravity().potentialEnergy(at(25.1), sheet, 0.0))
    }

    @Test
    fun `two spheres in orbit keep their energy, four times better with half the step`() {
        fun drift(dt: Double): Double {
            val p =
                populationOf(
                    Sphere(x = -1.0, vy = -0.4, m = 1.0, r = 0.01),
                    Sphere(x = 1.0, vy = 0.4, m = 1.0, r = 0.01),
                )
            val s = Simulation(p, Open, null, FixedTimeStep(dt), listOf(SelfGravity(Open, 1.0)))
            val start = total(s)
            assertEquals(0.16 - 0.5, start, 1e-15)
            var worst = 0.0
            while (s.time < 20.0) {
                s.advance()
                worst = maxOf(worst, abs(total(s) - start))
            }
            return worst
        }
        val coarse = drift(0.02)
        assertTrue(coarse in 1e-7..2e-3) { "drift $coarse" }
        assertEquals(4.0, coarse / drift(0.01), 0.4)
    }

    @Test
    fun `elastic spheres that fall keep their energy to round-off, walls change it by a step's fall at each bounce`() {
        fun gas() = randomSpheres(150, Walls(box), 9, 1.0) { 0.35 }
        val dt = 0.02
        val falling =
            Simulation(
                gas(),
                Open,
                CollisionForcing(ConstantRestitution(1.0)),
                FixedTimeStep(dt),
                listOf(UniformAcceleration(0.3, 0.0, -2.0)),
            )
        val start = total(falling)
        repeat(200) { falling.advance() }
        assertTrue(falling.collisions!!.counters.collisions > 20)
        assertEquals(start, total(falling), 1e-11 * Conserved.of(falling.population).kineticEnergy)
        val boxed =
            Simulation(
                gas(),
                Walls(box),
                CollisionForcing(ConstantRestitution(1.0)),
                FixedTimeStep(dt),
                listOf(UniformAcceleration(0.0, 0.0, -2.0)),
            )
        val before = total(boxed)
        repeat(500) { boxed.advance() }
        // A bounce at s within the step changes the energy by m a v (2s − dt): of either sign.
        val bounces = boxed.collisions!!.counters.wallCollisions
        val change = abs(total(boxed) - before)
        assertTrue(bounces > 300)
        assertTrue(change < 3 * sqrt(bounces.toDouble()) * boxed.population.mass[0] * 2.0 * 3.0 * dt) {
            "$change after $bounces bounces"
        }
    }

    @Test
    fun `free epicycles keep Hill's energy to round-off, and a wrap changes it by what is known`() {
        val omega = 1.7
        val sheet = HillSheet(box, omega)
        val random = SeededRandom(3)
        val spheres = Array(60) {
            val state = Epicycle(
                random.nextDouble(-3.0, 3.0),
                0.0,
                random.nextDouble(),
                random.nextDouble(0.0, 6.0),
                random.nextDouble(),
                1.0,
            ).state(omega, 2.0)
            Sphere(state[0], state[1], state[2], state[3], state[4], state[5], m = 1 + random.nextDouble())
        }
        val s = Simulation(populationOf(*spheres), sheet, null, FixedTimeStep(0.05), listOf(HillFrame(omega, 2.0)))
        val start = total(s)
        repeat(400) { s.advance() }
        assertEquals(start, total(s), 1e-11 * abs(start))
        // e = 3 around X = 4 crosses the face at 5: ΔE = m (¾ Ω² L X − ⅜ Ω² L²).
        val state = Epicycle(4.0, 0.0, 3.0, 0.0).state(omega)
        val one =
            Simulation(
                populationOf(Sphere(state[0], state[1], 0.0, state[3], state[4], m = 2.0)),
                sheet,
                null,
                FixedTimeStep(0.05),
                listOf(HillFrame(omega)),
            )
        val before = total(one)
        while (one.population.x[0] > 0) one.advance()
        val l = box.length(0)
        assertEquals(2.0 * omega * omega * l * (0.75 * 4 - 0.375 * l), total(one) - before, 1e-10)
    }
}
