package daphnis.core

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonTuning
import daphnis.core.engine.threadpool.ThreadPoolEngine
import daphnis.core.force.Force
import daphnis.core.force.Kick
import daphnis.core.force.UniformAcceleration
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.Pieces
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class StepPhasesTest {
    private val boundary = Periodic(Box.centred(12.0, 12.0, 12.0))
    private val gas = randomSpheres(300, boundary, 2, 1.0) { 0.4 }
    private val swirl = Kick { p, _, h -> for (k in 0 until p.size) p.vx[k] += h * p.y[k] }
    private val forces = listOf(UniformAcceleration(0.0, 0.3, 0.0), swirl)
    private val timeStep = CellCrossingTimeStep(0.5, 2.0, 1.0)

    private fun forcing() = CollisionForcing(ConstantRestitution(0.9), recordCollisions = true)

    @Test
    fun `phases driven by hand are the step of a simulation`() {
        val simulation = Simulation(gas.copy(), boundary, forcing(), timeStep, forces)
        val p = gas.copy()
        val phases = StepPhases(p, boundary, forcing(), forces, InlineLoop)
        var time = 0.0
        repeat(5) {
            simulation.advance()
            phases.begin()
            val duration = phases.duration(timeStep)
            phases.kick(time, duration)
            phases.drift(time, duration)
            time += duration
            phases.applyBoundary(time)
            phases.kickAgain(time, duration)
            phases.checkFinite { "nothing" }
            phases.commit()
            assertEquals(simulation.time, time)
            assertEquals(stateDigest(simulation.population), stateDigest(p))
        }
    }

    @Test
    fun `phases are taken back together from wherever they stopped`() {
        val before = stateDigest(gas)
        val end: List<StepPhases.() -> Unit> = listOf(
            { kick(0.0, 0.5) },
            { drift(0.0, 0.5) },
            { applyBoundary(0.5) },
            { kickAgain(0.5, 0.5) },
        )
        for (done in 1..end.size) {
            val p = gas.copy()
            val forcing = forcing()
            val phases = StepPhases(p, boundary, forcing, forces, InlineLoop)
            phases.begin()
            for (phase in end.take(done)) phases.phase()
            assertNotEquals(before, stateDigest(p)) { "after $done phases" }
            phases.takeBack()
            assertEquals(before, stateDigest(p)) { "after $done phases" }
            assertEquals(0L, forcing.counters.collisions)
            assertEquals(0, forcing.record!!.size)
        }
    }

    @Test
    fun `spheres that a boundary adds stay, and go again when the step fails`() {
        val inflow = object : BoundaryConditions by boundary {
            var fails = false

            override fun endStep(population: Population, time: Double) {
                boundary.endStep(population, time)
                population.addCrossing(population.indexOf(0), 1, 5)
                val one = populationOf(Sphere(x = 1.0, y = 2.0, z = 3.0, r = 1e-3))
                val id = intArrayOf(1_000_000_000 + population.size)
                population.add(Population(one.x, one.y, one.z, one.vx, one.vy, one.vz, one.radius, one.mass, id))
                population.addCrossing(population.indexOf(id[0]), 2, 7)
                check(!fails) { "no more" }
            }
        }
        val simulation = Simulation(gas.copy(), inflow, forcing(), FixedTimeStep(0.1), forces)
        simulation.advance()
        inflow.fails = true
        val digest = stateDigest(simulation.population)
        val crossed = simulation.population.boxesCrossed(0, 1)
        assertThrows(IllegalStateException::class.java) { simulation.advance() }
        assertEquals(301, simulation.population.size)
        assertEquals(digest, stateDigest(simulation.population))
        assertEquals(crossed, simulation.population.boxesCrossed(0, 1))
        assertEquals(-1, simulation.population.indexOf(1_000_000_301))
        inflow.fails = false
        repeat(3) { simulation.advance() }
        assertEquals(304, simulation.population.size)
        assertEquals(7, simulation.population.boxesCrossed(1_000_000_301, 2))
    }

    @Test
    fun `a state that is not finite at the end of a step is noticed, whoever made it so`() {
        val fine = Kick { _, _, _ -> }
        val late = object : Force by fine {
            override fun afterDrift(population: Population, end: Double, duration: Double) {
                population.vy[3] = Double.NaN
            }
        }
        val carrying = object : PerSphereBoundary by boundary {
            override fun endStep(population: Population, time: Double, from: Int, to: Int) {
                boundary.endStep(population, time, from, to)
                for (k in from until to) if (population.id[k] == 5) population.z[k] = Double.POSITIVE_INFINITY
            }
        }
        // The same, from one call for all.
        val whole = object : BoundaryConditions by carrying {
            override fun endStep(population: Population, time: Double) {
                carrying.endStep(population, time, 0, population.size)
            }
        }
        val cases = listOf(
            Triple(boundary, listOf(late), "vy of particle"),
            Triple(carrying, emptyList(), "z of particle 5 is Infinity"),
            Triple(carrying, listOf(fine), "z of particle 5 is Infinity"),
            Triple(whole, emptyList(), "z of particle 5 is Infinity"),
        )
        for ((around, forces, said) in cases) {
            val simulation = Simulation(gas.copy(), around, forcing(), FixedTimeStep(0.01), forces)
            val digest = stateDigest(simulation.population)
            val failure = assertThrows(IllegalStateException::class.java) { simulation.advance() }
            assertTrue(said in failure.message!!) { failure.message }
            assertEquals(digest, stateDigest(simulation.population))
        }
    }

    @Test
    fun `after a step in an epoch all is known to be finite, of that step, with that engine, behind such a boundary`() {
        val delegating = object : PerSphereBoundary by boundary {}

        /** Whether a number that is NaN after the drift passes; that of step 1 if the population is not smaller then. */
        fun passes(
            around: BoundaryConditions,
            drifts: Boolean = true,
            kept: Int = gas.size,
            wraps: Boolean = false,
        ): Boolean {
            val horizon = HorizonEngine(FixedPool(1), 256, HorizonTuning(4))
            val engine = if (wraps) object : CollisionEngine by horizon {} else horizon
            return CollisionForcing(ConstantRestitution(1.0), engine = engine).use { forcing ->
                val p = gas.copy()
                val phases = StepPhases(p, around, forcing, emptyList(), InlineLoop)
                for (step in 0..1) {
                    phases.begin()
                    if (step == 0 || drifts) phases.drift(0.0, 0.01)
                    if (step == 1) p.vx[0] = Double.NaN
                    phases.applyBoundary(0.01)
                    if (step == 0) {
                        phases.commit()
                        p.retain { it < kept }
                    }
                }
                assertEquals(if (drifts && kept == gas.size) 2L else 1L, horizon.epochSteps)
                runCatching { phases.checkFinite { "a step" } }.isSuccess
            }
        }
        assertTrue(passes(boundary))
        assertFalse(passes(delegating))
        assertFalse(passes(boundary, drifts = false))
        assertFalse(passes(boundary, kept = 200))
        assertFalse(passes(boundary, wraps = true))
    }

    @Test
    fun `a boundary of somebody else that spoils a sphere in the middle of an epoch is noticed`() {
        val spoiling = object : PerSphereBoundary by boundary {
            var isOn = false

            override fun endStep(population: Population, time: Double, from: Int, to: Int) {
                boundary.endStep(population, time, from, to)
                for (k in from until to) if (isOn && population.id[k] == 5) population.vz[k] = Double.NaN
            }
        }
        val engine = HorizonEngine(FixedPool(2), 0, HorizonTuning(8))
        val forcing = CollisionForcing(ConstantRestitution(0.9), engine = engine)
        Simulation(gas.copy(), spoiling, forcing, FixedTimeStep(0.01)).use { simulation ->
            repeat(4) { simulation.advance() }
            spoiling.isOn = true
            val failure = assertThrows(IllegalStateException::class.java) { simulation.advance() }
            assertTrue("vz of particle 5 is NaN" in failure.message!!) { failure.message }
            spoiling.isOn = false
            simulation.advance()
            assertEquals(1L to 5L, engine.epochs to engine.epochSteps - 1)
        }
    }

    @Test
    fun `what one step knows of its end is not believed in the next`() {
        val phases = StepPhases(gas.copy().also { it.vx[0] = 1.0 }, boundary, null, emptyList(), InlineLoop)
        phases.begin()
        phases.drift(0.0, 0.1)
        phases.applyBoundary(0.1)
        phases.checkFinite { "step 1" }
        phases.commit()
        phases.begin()
        phases.drift(0.1, Double.POSITIVE_INFINITY)
        assertThrows(IllegalStateException::class.java) { phases.checkFinite { "step 2" } }
    }

    @Test
    fun `a time step is measured by the threads of the engine to the same bits`() {
        val pieces = java.util.concurrent.ConcurrentLinkedQueue<Int>()
        val watched = object : PerSphereTimeStep by timeStep {
            override fun measure(population: Population, from: Int, to: Int): Double {
                pieces += to - from
                return timeStep.measure(population, from, to)
            }
        }
        val many = randomSpheres(5000, Periodic(Box.centred(60.0, 60.0, 60.0)), 4, 1.0) { 0.3 }
        for (p in listOf(gas, many)) {
            CollisionForcing(ConstantRestitution(0.9), engine = ThreadPoolEngine(3)).use {
                val phases = StepPhases(p, boundary, it, emptyList(), it.engine.loop)
                assertEquals(timeStep.next(p), phases.duration(watched))
            }
        }
        assertEquals(gas.size + many.size, pieces.sum())
        assertEquals(listOf(1, 1, 1), pieces.filter { it > 1000 }.map { 1 })
        val parts = timeStep.combine(timeStep.measure(gas, 99, 300), timeStep.measure(gas, 0, 99))
        assertEquals(timeStep.next(gas), timeStep.next(parts))
    }

    @Test
    fun `what threads share of a step comes out the same in small pieces, in any order`() {
        val sheet = HillSheet(Box.centred(12.0, 12.0, 12.0), 1.0)
        val digests = listOf(InlineLoop, Pieces).map { loop ->
            val p = gas.copy()
            val hill = HillFrame(1.0).also { it.useLoop(loop) }
            val phases = StepPhases(p, sheet, forcing(), listOf(hill), loop)
            phases.begin()
            phases.kick(0.0, 0.5)
            phases.drift(0.0, 0.5)
            phases.takeBack()
            assertEquals(stateDigest(gas), stateDigest(p))
            phases.begin()
            phases.kick(0.0, 0.5)
            phases.drift(0.0, 0.5)
            phases.applyBoundary(0.5)
            phases.kickAgain(0.5, 0.5)
            phases.checkFinite { "nothing" }
            p.mass[p.size - 1] = Double.POSITIVE_INFINITY
            val words = assertThrows(IllegalStateException::class.java) { phases.checkFinite { "it" } }.message!!
            assertTrue("mass of particle" in words) { words }
            p.mass[p.size - 1] = 1.0
            phases.commit()
            stateDigest(p)
        }
        assertEquals(digests[0], digests[1])
        assertNotEquals(stateDigest(gas), digests[0])
    }

    @Test
    fun `a time step can be a function of the population`() {
        val simulation = Simulation(gas.copy(), boundary, forcing(), TimeStep { 1.0 / it.size })
        simulation.advance()
        assertEquals(1.0 / 300, simulation.time)
    }
}
