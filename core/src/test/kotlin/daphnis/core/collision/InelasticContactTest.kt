package daphnis.core.collision

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.boundary.prepare
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.CoreEngines
import daphnis.core.engine.Draw
import daphnis.core.engine.SerialEngine
import daphnis.core.force.UniformAcceleration
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

/** Two that touch after a collision do not approach by round-off, or they would collide at once for ever. */
class InelasticContactTest {
    // Without one, clusters of many collapse.
    private val guards = listOf(FloorSpeedGuard(1e-6), ContactDurationGuard(1e-6))
    private val plastic = ConstantRestitution(0.0)
    private val images = Images().apply { prepare(Open, 0.0) }

    /** Spheres 0 and 1 at contact at time 0, in a direction, with velocities around a common one and masses as drawn. */
    private fun touching(random: SeededRandom, common: Double, approach: Double): StepRows {
        val n = DoubleArray(3) { random.nextGaussian() }
        val length = sqrt(n.sumOf { it * it })
        for (k in n.indices) n[k] /= length
        val v = DoubleArray(3) { common * random.nextGaussian() }
        val u = DoubleArray(3) { -approach * n[it] + 0.3 * approach * random.nextGaussian() }
        fun mass() = Math.pow(10.0, random.nextDouble(-6.0, 6.0))
        val p = populationOf(
            Sphere(3.0, -2.0, 0.7, v[0], v[1], v[2], 0.6, mass()),
            Sphere(3.0 + n[0], -2.0 + n[1], 0.7 + n[2], v[0] + u[0], v[1] + u[1], v[2] + u[2], 0.4, mass()),
        )
        return StepRows().apply { load(p, intArrayOf(0, 1), 1.0, false) }
    }

    @Test
    fun `they never approach after an impact, whatever the coefficient, however slow it is`() {
        val random = SeededRandom(1)
        val outcome = CollisionOutcome()
        var lost = 0
        for (draw in 1..20_000) {
            val coefficient = if (draw % 2 == 0) 0.0 else random.nextDouble(0.0, 1.0)
            // Down to what the rounding of the velocities swallows.
            val approach = Math.pow(10.0, random.nextDouble(-18.0, 0.0))
            val rows = touching(random, 1.0, approach)
            val before = rows.state.copyOf()
            if (!CollisionLaw(ConstantRestitution(coefficient)).collide(rows, 0, 1, 0, images, 0.0, outcome)) continue
            val impulse = (1 + coefficient) * outcome.impactSpeed
            assertEquals(NEVER, contactTime(rows, 0, 1, 0, images)) { "draw $draw" }
            assertEquals(NEVER, contactTime(rows, 1, 0, 0, images)) { "draw $draw, from the other side" }
            for (k in listOf(3, 4, 5, 11, 12, 13)) {
                val change = abs(rows.state[k] - before[k])
                assertTrue(change <= impulse + 1e-14) { "draw $draw: a velocity changes by $change" }
            }
            if (impulse < 1e-15) lost++
        }
        assertTrue(lost > 100) { "only $lost impulses were lost" }
    }

    @Test
    fun `the result is the same from either side`() {
        val random = SeededRandom(2)
        repeat(2000) {
            val rows = touching(random, 1.0, Math.pow(10.0, random.nextDouble(-17.0, 0.0)))
            val other = StepRows().apply { repeat(2) { k -> take(rows, k) } }
            val law = CollisionLaw(plastic)
            assertEquals(
                law.collide(rows, 0, 1, 0, images, 0.0, CollisionOutcome()),
                law.collide(other, 1, 0, 0, images, 0.0, CollisionOutcome()),
            )
            for (k in 0 until 16) assertEquals(rows.state[k].toRawBits(), other.state[k].toRawBits()) { "number $k" }
        }
    }

    @Test
    fun `two that hit plastically move on together, with one collision`() {
        val start = populationOf(
            Sphere(-2.0, 0.0, 0.0, 1.0, -0.14148602935423477, -0.11414327458831523, 0.5),
            Sphere(2.0, -0.17843957233684182, -0.32491415784824884, -1.0, 0.40857012084676597, 0.047518279, 0.5),
        )
        for (guard in guards + NoGuard) {
            val simulation = simulationOf(start.copy(), Open, 0.1, plastic, guard)
            repeat(60) { simulation.advance() }
            assertEquals(1L, simulation.collisions!!.counters.collisions)
        }
        val headOn =
            simulationOf(populationOf(Sphere(x = -3.0, vx = 1.0), Sphere(x = 3.0, vx = -0.3)), Open, 0.1, plastic)
        repeat(200) { headOn.advance() }
        assertEquals(1L, headOn.collisions!!.counters.collisions)
        val x = headOn.population.x
        assertEquals(2.0, abs(x[1] - x[0]), 1e-12)
    }

    private fun cooled(
        boundary: BoundaryConditions,
        guard: CollapseGuard,
        engine: CollisionEngine = SerialEngine(),
    ): Simulation {
        val start = randomSpheres(300, boundary, 5, 1.0) { 0.5 }
        return simulationOf(start, boundary, 0.1, plastic, guard, engine).also { s -> repeat(60) { s.advance() } }
    }

    @Test
    fun `a gas of plastic spheres cools, in every box and with every guard`() {
        val box = Box.centred(9.0, 9.0, 9.0)
        for (boundary in listOf(Periodic(box), LeesEdwards(box, 0.1), Walls(box, 0.5))) {
            for (guard in guards) {
                val gas = cooled(boundary, guard)
                assertTrue(gas.collisions!!.counters.collisions > 500)
                assertTrue(gas.conserved().kineticEnergy < 150) { "energy ${gas.conserved().kineticEnergy}" }
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `engines agree on a gas of plastic spheres`() {
        val boundary = Periodic(Box.centred(9.0, 9.0, 9.0))
        for (guard in guards) {
            val expected = stateDigest(cooled(boundary, guard).population)
            for (engine in CoreEngines.others(Draw(3))) {
                engine.use { assertEquals(expected, stateDigest(cooled(boundary, guard, it).population)) { it.name } }
            }
        }
    }

    @Test
    fun `three in line that are pushed together stay together`() {
        val random = SeededRandom(4)
        repeat(200) { draw ->
            val drift = random.nextGaussian()
            val tilt = random.nextDouble(-0.3, 0.3)
            val start = populationOf(
                Sphere(x = -4.0, vx = 1.0 + drift, vy = drift),
                Sphere(vx = drift, vy = drift),
                Sphere(x = 2.0, y = tilt, vx = drift, vy = drift),
                Sphere(x = 7.0, y = tilt, vx = drift - 1.0, vy = drift),
            )
            val simulation = simulationOf(start, Open, 0.5, plastic, startStep = 1)
            repeat(40) { simulation.advance() }
            val collisions = simulation.collisions!!.counters.collisions
            assertTrue(collisions in 3..10_000) { "draw $draw: $collisions collisions" }
        }
    }

    @Test
    fun `a sphere that falls onto a plastic floor stays there, but for what it rattles`() {
        val start: Population = populationOf(Sphere(z = 2.0))
        val fall = Simulation(
            start,
            Walls(Box(-5.0, -5.0, 0.0, 5.0, 5.0, 20.0), 0.0),
            CollisionForcing(plastic),
            FixedTimeStep(0.01),
            listOf(UniformAcceleration(0.0, 0.0, -1.0)),
        )
        repeat(500) { fall.advance() }
        val rattles = (0.01 / 16).let { it * it / 2 }
        assertTrue(start.z[0] > 1.0 - 1e-12 && start.z[0] < 1.0 + 1.001 * rattles) { "at ${start.z[0]}" }
    }
}
