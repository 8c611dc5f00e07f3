package daphnis.core.engine.lists

import daphnis.core.Engines
import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.engine.CoreEngines
import daphnis.core.engine.Draws
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.engine.failure
import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.simulationOf
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import daphnis.core.surface.Restitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

class ListStepsTest {
    @Test
    fun `lists give the serial engine's bits after every step, whatever is done between steps`() {
        var collisions = 0L
        var steps = 0L
        var built = 0L
        var refreshed = 0L
        var changed = 0L
        var wrapped = 0L
        for (seed in (1..DRAWS) + FASTER_THAN_ALLOWED) {
            val draw = DenseDraw(seed)
            val engine = engine()
            val serial = draw.simulation(SerialEngine())
            val listed = draw.simulation(engine)
            var failed = 0
            for (step in 1..STEPS) {
                val story = "$draw, step $step"
                val failure = failure(serial)
                assertEquals(failure, failure(listed)) { story }
                // Millions of collisions lead to it.
                if (failure != null && ++failed == 2) break
                assertSameStep(serial, listed, story)
                assertSameLastCollisions(serial, listed, story)
                if (draw.isMeddled) draw.meddle(step, listOf(serial, listed))
            }
            collisions += serial.collisions!!.counters.collisions
            val lists = engine.lists
            steps += lists.steps
            built += lists.built
            refreshed += lists.refreshed
            changed += lists.changed
            wrapped += lists.wrapped
            engine.close()
        }
        println("$collisions collisions, $steps steps, $built built, $refreshed refreshed")
        println("$changed changed, $wrapped wrapped")
        assertTrue(collisions > 300 * DRAWS) { "$collisions collisions" }
        assertTrue(steps > STEPS * DRAWS / 3) { "$steps steps" }
        assertTrue(built < steps / 3) { "$built built" }
        assertTrue(refreshed > 100 * DRAWS) { "$refreshed refreshed" }
        assertTrue(changed > 10 * DRAWS && wrapped > 10 * DRAWS) { "$changed changed, $wrapped wrapped" }
    }

    @Test
    fun `after a law has thrown at any collision of a step, it goes on with the serial engine's bits`() {
        var thrown = 0
        for (seed in 1..DRAWS / 10) {
            val draw = DenseDraw(seed)
            val engine = engine()
            val fuses = List(2) { Fuse() }
            val serial = draw.simulation(SerialEngine(), fuses[0])
            val listed = draw.simulation(engine, fuses[1])
            for (step in 1..STEPS) {
                for (fuse in fuses) fuse.rarity = if (step % 2 == 0) 4L shl step / 4 else Long.MAX_VALUE
                val story = "$draw, step $step"
                val failure = failure(serial)
                assertEquals(failure, failure(listed)) { story }
                if (failure != null && "on purpose" !in failure) break
                if (failure != null) thrown++
                assertSameStep(serial, listed, story)
            }
            engine.close()
        }
        assertTrue(thrown > DRAWS / 4) { "$thrown thrown" }
    }

    /** Throws at one collision in so many, whoever asks how often. */
    private class Fuse : Restitution {
        var rarity = Long.MAX_VALUE

        override fun coefficient(impactSpeed: Double): Double {
            if (impactSpeed.toRawBits() % rarity == 0L) throw ArithmeticException("on purpose at $impactSpeed")
            return 0.9
        }
    }

    @Test
    fun `a step that is taken back is done again in the same bits`() {
        val serial = simulationOf(crowd(), BOX, 0.05)
        val engine = engine()
        var isBroken = false
        val output = object : Output {
            override fun write(simulation: Simulation) {
                if (isBroken) throw ArithmeticException("on purpose")
            }
        }
        val listed = simulationOf(crowd(), BOX, 0.05, engine = engine, outputs = listOf(output))
        for (step in 1..12) {
            isBroken = step % 3 == 0
            if (isBroken) assertTrue("on purpose" in failure(listed)!!)
            isBroken = false
            serial.advance()
            listed.advance()
            assertSameStep(serial, listed, "step $step")
        }
        assertEquals(16L, engine.lists.steps)
    }

    @Tag("thorough")
    @Test
    fun `lists that are too short for a large sphere among small ones, or become so in mid-step, are made longer`() {
        val random = SeededRandom(4)
        val n = 2000
        fun place() = DoubleArray(n) { random.nextDouble(-12.0, 12.0) }
        val x = place()
        val y = place()
        val z = place()

        // All fly to the middle, slowly at its edge.
        fun inward(a: DoubleArray) = DoubleArray(n) { -a[it] + 0.1 * random.nextGaussian() }
        val radii = DoubleArray(n) { if (it % 50 == 0) 0.4 else 0.14 }
        val start = Population(x, y, z, inward(x), inward(y), inward(z), radii, DoubleArray(n) { 1.0 })
        val engine = engine()
        // At a step that is not the first, spheres may overlap.
        val serial = simulationOf(start.copy(), Open, 0.1, startStep = 1)
        val listed = simulationOf(start.copy(), Open, 0.1, engine = engine, startStep = 1)
        for (step in 1..15) {
            serial.advance()
            listed.advance()
            assertSameStep(serial, listed, "step $step")
        }
        assertTrue(serial.collisions!!.counters.collisions > 20_000) { "${serial.collisions!!.counters.collisions}" }
        assertTrue(engine.lists.voided > 0 && engine.lists.steps > 5) {
            "${engine.lists.voided} given up, ${engine.lists.steps} taken"
        }
    }

    @Test
    fun `they are used where they pay, on any number of threads, and nowhere else`() {
        fun listed(population: Population, boundary: BoundaryConditions, threads: Int = 1): Long {
            val engine = Engines.horizon(threads)
            simulationOf(population, boundary, 0.05, engine = engine).use { s -> repeat(20) { s.advance() } }
            // Only a step in an epoch is known to end finite.
            if (engine.lists.steps > 0L) assertFalse(engine.endedFinite)
            return engine.lists.steps
        }
        assertEquals(20L, listed(crowd(), BOX))
        assertEquals(20L, listed(crowd(), BOX, threads = 2))
        assertEquals(20L, listed(crowd(), BOX, threads = 3))
        assertEquals(0L, listed(crowd(apart = 1.4), Periodic(Box.centred(11.2, 11.2, 11.2))))
        assertEquals(0L, listed(crowd(), Walls(CUBE, 1.0)))
        assertEquals(0L, listed(crowd(), LeesEdwards(CUBE, 0.1)))
        assertEquals(0L, listed(crowd().also { it.retain { k -> k < 90 } }, BOX))
        assertEquals(0L, listed(crowd().also { it.radius[7] *= 0.1 }, BOX))
    }

    @Tag("thorough")
    @Test
    fun `a long step asks on the way whether it is wanted, and is done again when it was not`() {
        val population = crowd()
        val law = CollisionLaw(ConstantRestitution(1.0))
        val step = CollisionStep(population, BOX, law, CollisionCounters())
        step.duration = 2.0
        val expected = crowd()
        SerialEngine().advance(CollisionStep(expected, BOX, law, CollisionCounters()).also { it.duration = 2.0 })
        val before = stateDigest(population)
        val steps = HorizonSteps(InlineLoop)
        var asked = 0
        while (true) {
            var toGo = ++asked
            val isWanted = Runnable { check(--toGo > 0) { "not wanted" } }
            if (runCatching { assertTrue(steps.take(step, isWanted)) }.isSuccess) break
            assertEquals(before, stateDigest(population))
            assertEquals(0L, step.counters.collisions)
        }
        assertEquals(stateDigest(expected), stateDigest(population))
        assertEquals(1L, steps.lists.steps)
        // A short one at its beginning, and before it is written.
        var times = 0
        BOX.endStep(population, 0.0)
        step.duration = 0.02
        assertTrue(steps.take(step) { times++ })
        assertEquals(2, times)
        assertTrue(step.counters.collisions > 10_000 && asked in 3..12) { "${step.counters.collisions}, $asked" }
    }

    @Test
    fun `a gas that has spread out gets no new lists`() {
        val engine = Engines.horizon(1)
        simulationOf(crowd(), Open, 0.05, engine = engine).use { s -> repeat(1100) { s.advance() } }
        assertTrue(engine.lists.steps in 5..1000) { "${engine.lists.steps} steps" }
    }

    @Test
    fun `a wrap keeps all lists, a kick needs none, and a sphere put elsewhere one`() {
        val engine = engine()
        val simulation = simulationOf(crowd(), BOX, 5e-3, engine = engine)
        repeat(200) { simulation.advance() }
        assertTrue(engine.lists.wrapped > 50) { "${engine.lists.wrapped} wraps" }
        assertEquals(0L, engine.lists.changed)
        val before = engine.lists.refreshed
        simulation.population.vx[3] += 0.1
        simulation.advance()
        assertEquals(1L, engine.lists.changed)
        simulation.population.z[5] = -simulation.population.z[5]
        simulation.advance()
        assertEquals(2L, engine.lists.changed)
        assertTrue(engine.lists.refreshed > before)
        assertEquals(1L, engine.lists.built)
    }

    private fun engine() = CoreEngines.lists()

    private fun assertSameLastCollisions(expected: Simulation, actual: Simulation, story: String) {
        fun times(s: Simulation) = s.population.run { (0 until size).associate { id[it] to lastCollision[it] } }
        assertEquals(times(expected), times(actual)) { story }
    }

    private companion object {
        val DRAWS = Draws.share(usual = 300, long = 3000)
        const val STEPS = 20

        /** A draw in which a collision makes a sphere too fast for the step. */
        const val FASTER_THAN_ALLOWED = 2864L
        val CUBE = Box.centred(8.4, 8.4, 8.4)
        val BOX = Periodic(CUBE)
    }
}
