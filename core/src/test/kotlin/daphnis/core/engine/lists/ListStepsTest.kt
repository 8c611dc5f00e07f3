package daphnis.core.engine.lists

import daphnis.core.Simulation
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.engine.failure
import daphnis.core.engine.horizon.HorizonEngine
import daphnis.core.engine.horizon.HorizonSteps
import daphnis.core.engine.horizon.ScalarFilter
import daphnis.core.parallel.FixedPool
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
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
        for (seed in 1..DRAWS) {
            val draw = DenseDraw(seed)
            val engine = engine()
            val serial = draw.simulation(SerialEngine())
            val listed = draw.simulation(engine)
            for (step in 1..STEPS) {
                val story = "$draw, step $step"
                assertEquals(failure(serial), failure(listed)) { story }
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
        println("$collisions collisions, $steps steps, $built built, $refreshed refreshed, $changed changed, $wrapped wrapped")
        assertTrue(collisions > 1000 * DRAWS) { "$collisions collisions" }
        assertTrue(steps > STEPS * DRAWS / 3) { "$steps steps" }
        assertTrue(built < steps / 3) { "$built built" }
        assertTrue(refreshed > 100 * DRAWS) { "$refreshed refreshed" }
        assertTrue(changed > 10 * DRAWS && wrapped > 10 * DRAWS) { "$changed changed, $wrapped wrapped" }
    }

    private fun engine() =
        HorizonEngine(FixedPool(1), HorizonSteps.WORTH_SPHERES, null, ScalarFilter, ListTuning.ALWAYS)

    private fun assertSameLastCollisions(expected: Simulation, actual: Simulation, story: String) {
        fun times(s: Simulation) = s.population.run { (0 until size).associate { id[it] to lastCollision[it] } }
        assertEquals(times(expected), times(actual)) { story }
    }

    private companion object {
        val DRAWS = if (System.getProperty("daphnis.long") == "true") 3000L else 300L
        const val STEPS = 20
    }
}
