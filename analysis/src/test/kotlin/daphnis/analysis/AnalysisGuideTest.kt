package daphnis.analysis

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.order.RadialKey
import daphnis.analysis.order.RadialOrder
import daphnis.analysis.profile.Profile
import daphnis.analysis.streamline.Streamlines
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.Box
import daphnis.core.engine.CollisionForcing
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.surface.BridgesRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The code of docs/analysis.md, as it stands there. */
class AnalysisGuideTest {
    @Test
    fun `the example of the guide fills while a simulation runs, and copies nothing`() {
        val omega = 1.0
        val orbit = 2 * Math.PI
        val dt = orbit / 100
        val sheet = HillSheet(Box.centred(40.0, 40.0, 20.0), omega)
        // Far enough apart not to touch at the start.
        val population = uniform(100, sheet, radius = 0.01, omega = omega) { it.nextGaussian() }.population
        for (k in 0 until 100) {
            population.x[k] = -20 + 4.0 * (k % 10) + 2
            population.y[k] = -20 + 4.0 * (k / 10) + 2
            population.vy[k] = -1.5 * population.x[k]
            population.radius[k] = 1.0
        }
        val collisions = CollisionForcing(BridgesRestitution(cmPerSecond = 0.02))
        // example: averages
        val profile = Profile(axis = 2, from = -15.0, to = 15.0, bins = 30)
        val frame = HillFrame(omega)
        val averages = Averages(profile, from = orbit / 2, every = 10, frame.frequencies)
        val steps = FixedTimeStep(dt)
        val simulation = Simulation(population, sheet, collisions, steps, listOf(frame), outputs = listOf(averages))
        while (simulation.time < orbit) simulation.advance()
        val middle = averages.average(15 * Profile.COLUMNS.size + Profile.COLUMNS.indexOf("filling_factor"))
        println(middle) // mean ± error, or that states are too few
        if (!middle.isLevelled) println("worth ${middle.independent} independent states")
        // end
        assertTrue(middle.mean > 0)
        assertFalse(middle.isLevelled) { "six states in half an orbit tell no error" }
        assertEquals(6, averages.size)

        // example: analysis
        val state = State.of(simulation, frame.frequencies) // or State(population, boundary, time, frame.frequencies)
        val order = RadialOrder().sort(state, RadialKey.X) // order.order[rank] is an index; no sphere is moved
        val lines = Streamlines.of(state, slabs = 4, groups = 5, RadialKey.GUIDING_CENTRE)
        val crossing = lines.q.count { it >= 1 }
        // end
        assertEquals(lines.q.size, crossing + lines.q.count { !(it >= 1) })
        assertTrue(state.population === population)
        for (rank in 1 until order.size) {
            assertTrue(population.x[order.order[rank - 1]] <= population.x[order.order[rank]])
        }
        assertEquals(100, lines.count.sum())
        assertTrue(lines.q.any { it > 0 })
    }
}
