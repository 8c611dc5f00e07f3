package daphnis.core.engine.horizon

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.NoGuard
import daphnis.core.engine.horizon.Prospect.Companion.LONG
import daphnis.core.engine.horizon.Prospect.Companion.VERY_LONG
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.concurrent.atomic.AtomicLong

class ProspectTest {
    private val done = AtomicLong()
    private val step = CollisionStep(
        Population(zeros(), zeros(), zeros(), zeros(), zeros(), zeros(), ones(), ones()),
        Periodic(Box.centred(1.0, 1.0, 1.0)),
        CollisionLaw(ConstantRestitution(1.0), NoGuard),
        CollisionCounters(),
    )

    private fun zeros() = DoubleArray(SPHERES)

    private fun ones() = DoubleArray(SPHERES) { 1.0 }

    /** Looks at the next step of [steps], after which the run ends; the step has so many [collisions]. */
    private fun Prospect.take(steps: Long, collisions: Long = 0) {
        step.toCome = steps - 1
        look(step)
        passed(step, collisions)
    }

    @Test
    fun `a run is long from its spheres and steps on`() {
        val short = Prospect(done)
        short.take(LONG / SPHERES - 1)
        assertFalse(short.isLong)
        done.set(0)
        val long = Prospect(done)
        long.take(LONG / SPHERES)
        assertTrue(long.isLong && !long.isVeryLong)
        done.set(0)
        assertTrue(Prospect(done).also { it.take(VERY_LONG / SPHERES) }.isVeryLong)
    }

    @Test
    fun `collisions make a run longer, which it remains`() {
        val prospect = Prospect(done)
        prospect.take(10_000, collisions = 100)
        assertFalse(prospect.isLong)
        prospect.take(9_999)
        assertTrue(prospect.isLong)
        prospect.take(9_998)
        prospect.take(1)
        assertTrue(prospect.isLong && !prospect.isVeryLong)
        prospect.take(10_000, collisions = 1000)
        prospect.take(9_999)
        assertTrue(prospect.isVeryLong)
        prospect.take(9_998)
        prospect.take(1)
        assertTrue(prospect.isVeryLong)
    }

    @Test
    fun `the work of a run does not change while it goes on, however long it is`() {
        val short = Prospect(done)
        for (steps in LONG / SPHERES - 1 downTo 1) short.take(steps)
        assertFalse(short.isLong)
        assertEquals(LONG - SPHERES, done.get())
        done.set(0)
        val long = Prospect(done)
        for (steps in VERY_LONG / SPHERES + 10 downTo 1) {
            long.take(steps)
            assertTrue(long.isVeryLong)
        }
        assertEquals(VERY_LONG + 10 * SPHERES, done.get())
    }

    @Test
    fun `the second of two runs in one process may be long, and one without an end is so at once`() {
        val half = LONG / SPHERES / 2 + 1
        val first = Prospect(done)
        for (steps in half downTo 1) first.take(steps)
        assertFalse(first.isLong)
        assertTrue(Prospect(done).also { it.take(half) }.isLong)
        val endless = Prospect(done).also { it.take(CollisionStep.UNKNOWN) }
        assertTrue(endless.isLong && endless.isVeryLong)
    }

    @Test
    fun `steps in which spheres fly far are for epochs, however few they are`() {
        step.population.vy[7] = -3.0
        step.duration = 2.5
        assertFalse(Prospect(done).also { it.take(1) }.isLong)
        step.duration = 2.7
        assertTrue(Prospect(done).also { it.take(1) }.run { isLong && !isVeryLong })
    }

    private companion object {
        const val SPHERES = 1000
    }
}
