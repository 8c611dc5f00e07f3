package daphnis.core.engine.horizon

import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.SerialEngine
import daphnis.core.engine.assertSameStep
import daphnis.core.initial.Lattice
import daphnis.core.initial.LatticePlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.population.Population
import daphnis.core.simulationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** Work is counted, in the nanoseconds of a model: the clock is not asked. */
class EpochLimitsTest {
    @Test
    fun `an epoch that turns out to be far too much work is given up, and not tried at once again`() {
        for (classBound in listOf(0.1, 0.5)) {
            for (threads in 1..2) {
                val engine =
                    HorizonEngine(FixedPool(threads), fewest = 1, HorizonTuning(1, classBound, deviation = 0.0))
                val most = mostWork(engine, STEPS, "class bound $classBound, $threads threads")
                // Without limits it is 36 and more.
                assertTrue(most < 20) { "class bound $classBound, $threads threads: $most" }
                assertEquals(0, engine.epochSteps)
                assertTrue(engine.epochs in 1..2) { "${engine.epochs} epochs" }
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `where epochs are wanted in all steps, they may be more work, but not any`() {
        for (tuning in LONG) {
            val engine = HorizonEngine(FixedPool(2), fewest = 0, tuning)
            val most = mostWork(engine, 1, "eager")
            // Without limits it is 1,096 and more.
            assertTrue(most > 20 && most < 800) { "$most" }
            assertEquals(0, engine.epochSteps)
            assertEquals(1, engine.epochs)
        }
    }

    @Test
    fun `no epoch begins that is expected to be far more work than the steps of another engine`() {
        for (tuning in LONG) {
            val engine = HorizonEngine(FixedPool(1), fewest = 1, tuning)
            assertEquals(0.0, mostWork(engine, STEPS, "not begun"))
            assertEquals(0, engine.epochs)
        }
    }

    @Test
    fun `a search for all ends on the way where spheres are far more crowded than was expected`() {
        for (classBound in listOf(0.01, 5.0)) {
            for (threads in 1..2) {
                val engine = HorizonEngine(FixedPool(threads), 1, HorizonTuning(4, classBound))
                val crowd = crowd(engine)
                crowd.advance()
                assertEquals(1, engine.epochs)
                assertEquals(0, engine.epochSteps)
                // To the end it is 6.8e6 in cells, and 3.0e8 among roamers.
                val most = if (classBound > 1 && threads == 1) 6e6 else 2e7
                assertTrue(engine.work < most) { "class bound $classBound, $threads threads: ${engine.work}" }
                crowd.close()
            }
        }
    }

    /** A small part of a large box. */
    private fun crowd(engine: CollisionEngine): Simulation {
        val random = SeededRandom(2)
        fun lattice(stride: Int) = DoubleArray(CROWD) { 1.2 * (it / stride % CROWD_EDGE) }
        fun gauss() = DoubleArray(CROWD) { random.nextGaussian() }
        val start = Population(
            lattice(1),
            lattice(CROWD_EDGE),
            lattice(CROWD_EDGE * CROWD_EDGE),
            gauss(),
            gauss(),
            gauss(),
            DoubleArray(CROWD) { 0.5 },
            DoubleArray(CROWD) { 1.0 },
        )
        return simulationOf(start, Periodic(Box.centred(400.0, 400.0, 400.0)), 0.01, engine = engine)
    }

    /** The most work of a step, as a multiple of what the model has for one of the serial engine. */
    private fun mostWork(engine: HorizonEngine, steps: Int, story: String): Double {
        val serial = dense(SerialEngine())
        val horizon = dense(engine)
        var most = 0.0
        for (step in 1..steps) {
            val before = serial.collisions!!.counters.collisions
            serial.advance()
            horizon.advance()
            assertSameStep(serial, horizon, "$story, step $step")
            val collisions = serial.collisions!!.counters.collisions - before
            most = maxOf(most, engine.work / (collisions * SERIAL_COLLISION))
        }
        horizon.close()
        return most
    }

    /** Spheres as on a lattice, in a sheared box, in a step of several collisions each. */
    private fun dense(engine: CollisionEngine): Simulation {
        val boundary = LeesEdwards(Box.centred(EDGE, EDGE, EDGE), 0.2)
        return simulationOf(spheres(boundary), boundary, 0.5, engine = engine)
    }

    private fun spheres(boundary: BoundaryConditions): Population {
        val random = SeededRandom(1)
        val radii = DoubleArray(SPHERES) { 0.5 }
        val p = LatticePlacement(Lattice.FACE_CENTRED_CUBIC).place(radii, boundary.box, BooleanArray(3), random)
        fun gauss() = DoubleArray(SPHERES) { 0.5 * random.nextGaussian() }
        return Population(p.x, p.y, p.z, gauss(), gauss(), gauss(), radii, DoubleArray(SPHERES) { 1.0 })
    }

    private companion object {
        const val SPHERES = 500
        const val EDGE = 8.06
        const val STEPS = 3
        const val CROWD_EDGE = 16
        const val CROWD = CROWD_EDGE * CROWD_EDGE * CROWD_EDGE

        /** Of a collision of the serial engine in [dense], by the model. */
        const val SERIAL_COLLISION = 1e3

        /** With nearly all spheres as roamers, and with lines of which all are always near. */
        val LONG = listOf(HorizonTuning(6, 0.1, 0.0, 8.0, 4.0), HorizonTuning(6, 3.0, 0.3, 8.0, 4.0))
    }
}
