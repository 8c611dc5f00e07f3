package daphnis.core.potential

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.physics.cube
import daphnis.core.physics.gas
import daphnis.core.physics.temperature
import daphnis.core.populationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class SteppedPotentialTest {
    private val well = SteppedPotential.squareWell(1.5, 1.0)

    private fun collisions(potential: PairInteraction, e: Double = 1.0) =
        CollisionForcing.builder(ConstantRestitution(e))
            .interactions(PairInteractions(potential)).recordCollisions().build()

    /** Two spheres of mass 1 and diameter 1, [apart] along x, that approach with [speed]. */
    private fun two(potential: PairInteraction, apart: Double, speed: Double) = Simulation(
        populationOf(
            Sphere(x = -apart / 2, vx = speed / 2, r = 0.5),
            Sphere(x = apart / 2, vx = -speed / 2, r = 0.5),
        ),
        Open,
        collisions(potential),
        FixedTimeStep(0.1),
    )

    private fun Simulation.relative() = population.let { it.vx[it.indexOf(1)] - it.vx[it.indexOf(0)] }

    private fun Simulation.distance() = population.let { it.x[it.indexOf(1)] - it.x[it.indexOf(0)] }

    private fun Simulation.until(time: Double) = apply { while (this.time < time - 1e-9) advance() }

    @Test
    fun `a pair enters a well with the speed that energy gives, meets, and leaves with the speed it had`() {
        val simulation = two(well, 2.0, 0.5)
        // μ = 1/2, so v² grows by 2/μ = 4.
        simulation.until(1.1)
        assertTrue(simulation.distance() < 1.5)
        assertEquals(-sqrt(0.25 + 4.0), simulation.relative(), 1e-15)
        simulation.until(1.4)
        assertEquals(sqrt(0.25 + 4.0), simulation.relative(), 1e-15)
        simulation.until(3.0)
        assertTrue(simulation.distance() > 1.5)
        assertEquals(0.5, simulation.relative(), 1e-14)
        val counters = simulation.collisions!!.counters
        assertEquals(1, counters.collisions)
        assertEquals(2, counters.edgeEvents)
    }

    @Test
    fun `a pair that is bound stays so, and turns at the edge of the well`() {
        // It begins inside, with less than the depth.
        val simulation = two(well, 1.2, 0.5)
        var turns = 0
        var last = simulation.relative()
        repeat(1000) {
            simulation.advance()
            assertEquals(0.5, abs(simulation.relative()), 1e-12)
            assertTrue(simulation.distance() in 1.0 - 1e-12..1.5 + 1e-12) { "${simulation.distance()}" }
            if (simulation.relative() != last) turns++
            last = simulation.relative()
        }
        assertEquals(simulation.collisions!!.counters.edgeEvents, simulation.collisions!!.counters.collisions, 1)
        assertTrue(turns > 80)
    }

    private fun assertEquals(expected: Long, actual: Long, within: Long) =
        assertTrue(abs(expected - actual) <= within) { "$expected, $actual" }

    @Test
    fun `a shoulder turns back what is too slow and lets the rest in slower`() {
        val shoulder = SteppedPotential.squareShoulder(1.5, 1.0)
        // ½ μ v² < 1 for v < 2.
        val slow = two(shoulder, 2.0, 1.99).until(1.0)
        assertTrue(slow.distance() > 1.5)
        assertEquals(1.99, slow.relative(), 1e-15)
        val fast = two(shoulder, 2.0, 2.5).until(0.3)
        assertTrue(fast.distance() < 1.5)
        assertEquals(-1.5, fast.relative(), 1e-14)
        fast.until(3.0)
        assertEquals(2.5, fast.relative(), 1e-14)
    }

    @Test
    fun `with a step at contact spheres pass through one another`() {
        val soft = SteppedPotential(doubleArrayOf(2.0, 1.0), doubleArrayOf(0.5, 1.0))
        val simulation = two(soft, 3.0, 3.0)
        simulation.until(0.6)
        assertEquals(-sqrt(9.0 - 2.0), simulation.relative(), 1e-14)
        simulation.until(1.0)
        assertEquals(-sqrt(9.0 - 4.0), simulation.relative(), 1e-14)
        simulation.until(3.0)
        assertTrue(simulation.distance() < -2.0)
        assertEquals(-3.0, simulation.relative(), 1e-14)
        assertEquals(0, simulation.collisions!!.counters.collisions)
        assertEquals(4, simulation.collisions!!.counters.edgeEvents)
    }

    @Test
    fun `energy and momentum of a gas are kept, and its mean free time is that of others`() {
        val count = 1372
        val box = cube(count, Math.PI / 12)
        val simulation =
            Simulation(gas(count, box, 3, lattice = true), Periodic(box), collisions(well), FixedTimeStep(0.02))
        fun energy() = simulation.conserved().kineticEnergy +
            simulation.forces.sumOf { it.potentialEnergy(simulation.population, simulation.boundary, simulation.time) }
        // The lattice melts, which takes energy.
        repeat(4) { simulation.until(simulation.time + 2).scaleTo(1.0) }
        val before = energy()
        val counters = simulation.collisions!!.counters
        val events = counters.collisions + counters.edgeEvents
        var sum = 0.0
        repeat(100) {
            simulation.until(simulation.time + 0.1)
            sum += temperature(simulation.population) / 100
        }
        assertEquals(before, energy(), 1e-11 * count)
        val sums = simulation.conserved()
        for (p in listOf(sums.momentumX, sums.momentumY, sums.momentumZ)) assertEquals(0.0, p, 1e-11)
        val free = 10.0 * count / 2 / (counters.collisions + counters.edgeEvents - events)
        // src/dynamo/tests/squarewell_test.cpp of DynamO, commit 08346f1, which allows 5 %.
        assertEquals(0.0368185, free * sqrt(sum), 0.05 * 0.0368185)
    }

    /** Makes the temperature [to]. */
    private fun Simulation.scaleTo(to: Double) {
        val by = sqrt(to / temperature(population))
        for (axis in 0..2) population.velocity(axis).let { v -> for (k in v.indices) v[k] *= by }
    }

    @Test
    fun `steps that are none are refused`() {
        fun refused(vararg steps: Pair<Double, Double>) = assertThrows(IllegalArgumentException::class.java) {
            SteppedPotential(
                DoubleArray(steps.size) { steps[it].first },
                DoubleArray(steps.size) { steps[it].second },
            )
        }.message!!
        assertTrue("no steps" in refused())
        assertTrue("0.9" in refused(0.9 to 1.0))
        assertTrue("NaN" in refused(1.5 to Double.NaN))
        assertTrue("NaN" in refused(Double.NaN to 1.0))
        assertTrue("must fall" in refused(1.5 to 1.0, 1.5 to 2.0))
        assertTrue("changes no energy" in refused(1.5 to 0.0))
        assertTrue("changes no energy" in refused(2.0 to 1.0, 1.5 to 1.0))
    }
}
