package daphnis.core.engine.lists

import daphnis.core.boundary.Open
import daphnis.core.engine.CoreEngines
import daphnis.core.engine.assertSameStep
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.simulationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class BorderCollisionsTest {
    /**
     * 0 is pushed by 1 along y, and 3 by 4 against it, so that 0 and 3 graze one another and part before 0 comes to
     * touch 5. Sphere 3 is of another region, and so is 5; on its old path neither 0 nor 3 would be touched by then.
     */
    @Test
    fun `two that have changed graze one another before one of them is frozen`() {
        val random = SeededRandom(1)
        repeat(20) {
            val depth = random.nextDouble(1e-7, 1e-6)
            val pushed = random.nextDouble(1e-3, 3e-3)
            val pushedToo = random.nextDouble(1e-3, 3e-3)
            val graze = random.nextDouble(0.012, 0.014)
            val frozen = graze + sqrt(2 * depth) + random.nextDouble(2e-3, 5e-3)
            val third = graze - pushed + graze - pushedToo
            val start = Population(
                doubleArrayOf(0.0, 0.0, -8.0, 1 - depth, 1 - depth, 0.3),
                doubleArrayOf(0.0, -1 - pushed, 0.0, third, third + 1 + pushedToo, frozen - pushed + 0.4),
                doubleArrayOf(0.0, 0.0, 0.0, 0.0, 0.0, sqrt(0.75)),
                DoubleArray(6),
                doubleArrayOf(0.0, 1.0, 0.0, 0.0, -1.0, 0.0),
                DoubleArray(6),
                DoubleArray(6) { 0.5 },
                DoubleArray(6) { 1.0 },
            )
            val engine = CoreEngines.lists(1, ListTuning.always(3))
            // At a step that is not the first, spheres may overlap.
            val serial = simulationOf(start.copy(), Open, 0.5, startStep = 1)
            val listed = simulationOf(start.copy(), Open, 0.5, engine = engine, startStep = 1)
            serial.advance()
            listed.advance()
            assertEquals(1L, engine.lists.steps)
            val record = serial.collisions!!.record!!
            val pairs = (0 until record.size).map { record.lower[it] to record.higher[it] }
            assertTrue(pairs.containsAll(listOf(0 to 1, 3 to 4, 0 to 3, 0 to 5))) { "$pairs" }
            assertSameStep(serial, listed, "depth $depth")
            engine.close()
        }
    }
}
