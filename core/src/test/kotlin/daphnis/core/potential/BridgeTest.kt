package daphnis.core.potential

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.collision.FloorSpeedGuard
import daphnis.core.collision.PairStates
import daphnis.core.engine.CollisionForcing
import daphnis.core.physics.cube
import daphnis.core.physics.gas
import daphnis.core.populationOf
import daphnis.core.run.CollisionStatistics
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class BridgeTest {
    private val bridge = Bridge(1.2, 0.1)

    private fun collisions(e: Double) = CollisionForcing.builder(ConstantRestitution(e))
        .guard(FloorSpeedGuard(1e-9)).interactions(PairInteractions(bridge)).recordCollisions().build()

    /** Two spheres of mass 1 and diameter 1 that approach with [speed] from beyond the distance of rupture. */
    private fun two(speed: Double, e: Double, statistics: CollisionStatistics) = Simulation(
        populationOf(
            Sphere(x = -1.0, vx = speed / 2, r = 0.5),
            Sphere(x = 1.0, vx = -speed / 2, r = 0.5),
        ),
        Open,
        collisions(e),
        FixedTimeStep(0.1),
        outputs = listOf(statistics),
    )

    private fun Simulation.speed() = population.let { it.vx[it.indexOf(1)] - it.vx[it.indexOf(0)] }

    private fun Simulation.distance() = population.let { it.x[it.indexOf(1)] - it.x[it.indexOf(0)] }

    @Test
    fun `two that are fast enough part, and have lost the energy of the bridge`() {
        // μ = 1/2: the rupture takes 2 · 0.1/μ = 0.4 of the square of the speed.
        val statistics = CollisionStatistics()
        val simulation = two(2.0, 0.8, statistics)
        while (simulation.time < 2) simulation.advance()
        assertTrue(simulation.distance() > 1.2)
        assertEquals(sqrt(1.6 * 1.6 - 0.4), simulation.speed(), 1e-15)
        assertEquals(0.25 * (4 - 2.56) + 0.1, statistics.dissipated, 1e-15)
        assertEquals(1, statistics.count)
        assertEquals(1, simulation.collisions!!.counters.edgeEvents)
    }

    @Test
    fun `two below the critical speed stay together, and meet without a bridge only once`() {
        val critical = sqrt(0.4) / 0.8
        val statistics = CollisionStatistics()
        val fast = two(critical * 1.001, 0.8, statistics)
        val slow = two(critical * 0.999, 0.8, CollisionStatistics())
        repeat(1000) {
            fast.advance()
            slow.advance()
            if (slow.time > 2) assertTrue(slow.distance() in 1 - 1e-12..1.2 + 1e-12) { "${slow.distance()}" }
        }
        assertTrue(fast.distance() > 1.2)
        assertTrue(abs(slow.speed()) < critical / 10)
        assertTrue(slow.collisions!!.counters.let { it.edgeEvents > 5 && it.collisions - it.edgeEvents in 0..1 })
    }

    @Test
    fun `the energy of a bridge goes with the effective radius`() {
        // Two of radius 1 and 1/3 have the effective radius 1/4, as two of radius 1/2 have.
        val law = SizeLaw(0.25, 4.0 / 3)
        assertEquals(1.0, law.factor(1.0, 1.0 / 3), 1e-15)
        assertEquals(Math.pow(2.0, 4.0 / 3), law.factor(1.0, 1.0), 1e-14)
        val states = PairStates(PairInteractions(Bridge(1.1, 0.3, 0.5, 4.0 / 3)))
        assertEquals(0.3 * Math.pow(2.0, 4.0 / 3), states.cost(1, isOuter = true, 1.0, 1.0), 1e-15)
    }

    @Test
    fun `what a wet gas loses is what impacts and bridges have taken`() {
        val box = cube(500, 0.1)
        val statistics = CollisionStatistics()
        val simulation = Simulation(
            gas(500, box, 3, lattice = false),
            Periodic(box),
            collisions(0.9),
            FixedTimeStep(0.05),
            outputs = listOf(statistics),
        )
        val before = simulation.conserved().kineticEnergy
        while (simulation.time < 20) simulation.advance()
        val lost = before - simulation.conserved().kineticEnergy
        assertTrue(lost > before / 10)
        assertEquals(lost, statistics.dissipated, 1e-11 * before)
        val pairs = simulation.population.bonds.sumOf { it.size / 2 } / 2
        assertTrue(pairs > 5) { "$pairs bridges" }
    }

    @Test
    fun `bridges that are none are refused`() {
        fun refused(ratio: Double, energy: Double) =
            assertThrows(IllegalArgumentException::class.java) { Bridge(ratio, energy) }.message!!
        assertTrue("ratio 1.0" in refused(1.0, 1.0))
        assertTrue("NaN" in refused(Double.NaN, 1.0))
        assertTrue("energy 0.0" in refused(1.1, 0.0))
        assertTrue("NaN" in refused(1.1, Double.NaN))
    }
}
