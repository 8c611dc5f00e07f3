package daphnis.core.physics

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionRecord
import daphnis.core.engine.CollisionForcing
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.potential.PairInteraction
import daphnis.core.potential.PairInteractions
import daphnis.core.potential.SteppedPotential
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.exp
import kotlin.math.sqrt

/** Numbers of equilibrium that events at edges must give. */
class SquareWellTest {
    private val well = SteppedPotential.squareWell(1.5, 1.0)

    private fun simulation(start: Population, box: Box, potential: PairInteraction, dt: Double) = Simulation(
        start,
        Periodic(box),
        CollisionForcing.builder(ConstantRestitution(1.0)).interactions(PairInteractions(potential))
            .recordCollisions().build(),
        FixedTimeStep(dt),
    )

    /** Makes the temperature [to] in [dimensions], again and again until the gas has forgotten its start. */
    private fun Simulation.settle(to: Double, dimensions: Int = 3, times: Int = 5, lasts: Double = 2.0) =
        repeat(times) {
            val end = time + lasts
            while (time < end) advance()
            val by = sqrt(to / temperature(dimensions))
            for (axis in 0 until dimensions) population.velocity(axis).let { v -> for (k in v.indices) v[k] *= by }
        }

    private fun Simulation.temperature(dimensions: Int) =
        conserved().let { 2 * it.kineticEnergy / it.mass / dimensions }

    /** Advances to [end], shows each record to [look], and returns the mean temperature. */
    private fun Simulation.watch(end: Double, dimensions: Int = 3, look: (CollisionRecord) -> Unit): Double {
        var sum = 0.0
        var steps = 0
        while (time < end) {
            advance()
            look(collisions!!.record!!)
            sum += temperature(dimensions)
            steps++
        }
        return sum / steps
    }

    @Test
    fun `the pair distribution jumps at the edge by the Boltzmann factor`() {
        val box = cube(864, 0.3 * Math.PI / 6)
        val simulation = simulation(gas(864, box, 5, lattice = true), box, well, 0.05)
        simulation.settle(2.0)
        var within = 0L
        var without = 0L
        val temperature = simulation.watch(simulation.time + 25) { record ->
            for (k in 0 until record.size) {
                // Those who come to the edge from within recede.
                if (record.isEdge(k)) if (record.impactSpeed(k) < 0) within++ else without++
            }
        }
        assertEquals(exp(1 / temperature), within.toDouble() / without, 0.01)
    }

    @Test
    fun `the second virial coefficient of a thin gas`() {
        val density = 0.02
        val box = cube(2048, density * Math.PI / 6)
        val simulation = simulation(gas(2048, box, 7, lattice = true), box, well, 0.2)
        simulation.settle(1.5, lasts = 5.0)
        val began = simulation.time
        var virial = 0.0
        val temperature = simulation.watch(began + 150) { record ->
            for (k in 0 until record.size) {
                val d = sqrt((0..2).sumOf { record.separation(k, it) * record.separation(k, it) })
                virial += record.impulse(k) * d
            }
        }
        val z = virial / (3 * 2048 * temperature * (simulation.time - began))
        val hard = 2 * Math.PI / 3
        // B₂ over that of hard spheres, and some hundredths of the third coefficient: B₃ n is not nothing.
        assertEquals(1 - 2.375 * (exp(1 / temperature) - 1), z / density / hard, 0.06)
    }

    @Test
    fun `discs with ten steps and no core meet edges as often as in DynamO's test`() {
        val side = 64
        val count = side * side
        val random = SeededRandom(3)
        fun column(value: (Int) -> Double) = DoubleArray(count, value)
        // A square lattice, all neighbours of which are exactly at the outermost edge. It melts without a thermostat.
        val start = Population(
            column { it % side + 0.5 - side / 2.0 },
            column { it / side + 0.5 - side / 2.0 },
            column { 0.0 },
            column { random.nextGaussian() },
            column { random.nextGaussian() },
            column { 0.0 },
            column { 0.05 },
            column { 1.0 },
        )
        val ratios = DoubleArray(10) { 10.0 - it }
        val energies = DoubleArray(10) { (it + 1) / 10.0 }
        val box = Box.flat(side.toDouble(), side.toDouble())
        val simulation = simulation(start, box, SteppedPotential(ratios, energies), 0.05)
        simulation.settle(1.0, 2, times = 1, lasts = 0.0)
        while (simulation.time < 5) simulation.advance()
        val before = simulation.collisions!!.counters.edgeEvents
        simulation.watch(20.0, 2) {}
        val events = simulation.collisions!!.counters.edgeEvents - before
        val free = (simulation.time - 5) * count / 2 / events
        // src/dynamo/tests/2dstepped_potential_test.cpp, commit 08346f1, which allows 1 %.
        assertEquals(0.0419518, free, 0.01 * 0.0419518)
    }
}
