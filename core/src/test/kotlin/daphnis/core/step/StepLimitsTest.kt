package daphnis.core.step

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.StepRows
import daphnis.core.populationOf
import daphnis.core.simulationOf
import daphnis.core.surface.ConstantRestitution
import daphnis.core.wall.WallContact
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class StepLimitsTest {
    private val law = CollisionLaw(ConstantRestitution(1.0))
    private val walls = WallContact().apply { prepare(Walls(Box.centred(9.0, 9.0, 9.0)).walls, law) }
    private val rows = StepRows().apply {
        load(populationOf(Sphere(), Sphere(x = 3.0)), IntArray(2) { it }, 2.0, false)
    }
    private val limits = StepLimits().apply { start(2, 5.0) }

    private fun hit(slot: Int, time: Double) {
        walls.reflect(rows, slot, 0, time, CollisionOutcome())
        limits.checkProgress(rows, slot, WallContact.partner(0), time)
    }

    @Test
    fun `ten thousand collisions of a sphere pass while time stands still, one more is a collapse`() {
        // A ten-thousandth of 1e-13 of the step apart.
        repeat(10_000) { hit(0, 2e-17 * it) }
        assertEquals(10_000, rows.streak(0))
        // The other has a count of its own.
        hit(1, 2e-13)
        val e = assertThrows(CollapseException::class.java) { hit(0, 2e-13) }
        assertTrue("sphere 0 and a wall" in e.message.orEmpty() && "guard" in e.message.orEmpty()) { e.message }
    }

    @Test
    fun `any number pass while time goes on`() {
        repeat(30_000) { hit(0, 2.1e-13 * it) }
        assertEquals(1, rows.streak(0))
    }

    @Test
    fun `the collapse names the lower id first, whichever was named first`() {
        repeat(10_000) { hit(1, 0.0) }
        rows.advance(1, 0.0)
        for ((first, second) in listOf(0 to 1, 1 to 0)) {
            val e = assertThrows(CollapseException::class.java) { limits.checkProgress(rows, first, second, 0.0) }
            assertTrue("at time 5.0, of spheres 0 and 1" in e.message.orEmpty()) { e.message }
        }
    }

    @Test
    fun `two million collisions and a thousand for each sphere pass, one more is refused`() {
        limits.checkWork(2_002_000)
        val e = assertThrows(IllegalArgumentException::class.java) { limits.checkWork(2_002_001) }
        assertTrue("smaller dt" in e.message.orEmpty()) { e.message }
    }

    @Test
    fun `a step with more collisions than that is refused, and the population is as it was`() {
        // Between two walls, less than a two-millionth of a step apart.
        val p = populationOf(Sphere(vz = 2.0016e6))
        val simulation = simulationOf(p, Walls(Box.centred(4.0, 4.0, 3.0)), 1.0)
        assertThrows(IllegalArgumentException::class.java) { simulation.advance() }
        assertEquals(0.0, p.x[0])
        assertEquals(0L, simulation.collisions!!.counters.wallCollisions)
    }
}
