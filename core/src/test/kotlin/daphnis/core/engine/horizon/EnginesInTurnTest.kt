package daphnis.core.engine.horizon

import daphnis.core.Simulation
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.Draws
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.engine.failure
import daphnis.core.engine.islands.IslandsEngine
import daphnis.core.engine.lists.ListTuning
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Engines that keep the order of spheres and engines that change it write to the same two sets of columns. */
class EnginesInTurnTest {
    @Test
    fun `engines in turn on one population give the serial engine's bits, and steps that fail leave it as before`() {
        var failed = 0
        var collisions = 0L
        for (seed in 1..DRAWS) {
            val draw = LongDraw(seed)
            val serial = draw.simulation(SerialEngine())
            val engines = InTurn(seed)
            val mixed = draw.simulation(engines)
            for (step in 1..STEPS) {
                val story = "$draw, step $step"
                val expected = failure(serial)
                while (true) {
                    val before = everything(mixed)
                    val failure = failure(mixed)
                    if (failure == null || THROWN !in failure) {
                        assertEquals(expected, failure) { story }
                        break
                    }
                    failed++
                    assertEquals(before, everything(mixed)) { story }
                }
                assertSameStep(serial, mixed, story)
                assertEquals(everything(serial), everything(mixed)) { story }
                if (draw.isMeddled) draw.meddle(step, listOf(serial, mixed))
            }
            collisions += serial.collisions!!.counters.collisions
            engines.close()
        }
        println("$failed steps taken back, $collisions collisions")
        assertTrue(failed > DRAWS && collisions > 50 * DRAWS) { "$failed failures, $collisions collisions" }
    }

    /** All that is known of each sphere, by id. */
    private fun everything(simulation: Simulation): Map<Int, List<Any>> = simulation.population.run {
        (0 until size).associate { k ->
            val state = listOf(x[k], y[k], z[k], vx[k], vy[k], vz[k], radius[k], mass[k], lastCollision[k])
            id[k] to state + List(3) { axis -> boxesCrossed(id[k], axis) }
        }
    }

    /** Another engine every few steps; a quarter of the steps fails after it has written them. */
    private class InTurn(seed: Long) : CollisionEngine {
        private val random = SeededRandom(seed)
        private val engines = listOf(
            HorizonEngine(FixedPool(1), 0, HorizonTuning(64)),
            HorizonEngine(FixedPool(1 + random.nextInt(4)), 0, HorizonTuning(1 + random.nextInt(6))),
            SerialEngine(),
            IslandsEngine(FixedPool(2), 0),
            HorizonEngine(FixedPool(2), 1, null, ScalarFilter, ListTuning.ALWAYS, null, null),
        )
        private var present = 0
        override val name = "in turn"
        override val threads = 1
        override val loop: RangeLoop get() = engines[1].loop

        override fun advance(step: CollisionStep) {
            if (random.nextInt(3) == 0) present = random.nextInt(engines.size)
            engines[present].advance(step)
            check(random.nextInt(4) != 0) { THROWN }
        }

        override fun close() {
            for (engine in engines) engine.close()
        }
    }

    private companion object {
        const val STEPS = 16
        const val THROWN = "thrown after the step"
        val DRAWS = Draws.share(usual = 100, long = 2500)
    }
}
