package daphnis.core.step

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.randomSpheres
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class PreparedStepTest {
    private val prepared = PreparedStep()
    private val boundary = Periodic(Box.centred(9.0, 9.0, 9.0))
    private val law = CollisionLaw(ConstantRestitution(0.9))
    private val step = CollisionStep(randomSpheres(20, boundary, 1, 1.0) { 0.3 }, boundary, law, CollisionCounters())

    init {
        step.duration = 1e-3
    }

    private fun assertOutOfTurn(call: () -> Unit) {
        assertThrows(IllegalStateException::class.java, call)
    }

    /** Calls that need a prepared step. */
    private fun assertNotPrepared() {
        assertOutOfTurn { prepared.store() }
        assertOutOfTurn { prepared.enlarge(prepared.rows, 0, 1) }
    }

    @Test
    fun `a step is measured, prepared and stored in this order, once`() {
        assertOutOfTurn { prepared.prepare() }
        assertNotPrepared()
        prepared.measure(step)
        assertNotPrepared()
        prepared.prepare()
        assertOutOfTurn { prepared.prepare() }
        prepared.store()
        assertNotPrepared()
        assertOutOfTurn { prepared.prepare() }
    }

    @Test
    fun `a larger bound is for a step that is prepared again, and a step can be begun again at any time`() {
        prepared.measure(step)
        prepared.prepare()
        // Faster than any sphere was.
        prepared.rows.state[3] = 1e3
        prepared.enlarge(prepared.rows, 0, -1)
        assertNotPrepared()
        prepared.prepare()
        prepared.measure(step)
        assertNotPrepared()
        prepared.prepare()
        assertEquals(3, prepared.version)
    }

    @Test
    fun `a step that is refused is not measured`() {
        prepared.measure(step)
        step.population.vx[0] = Double.NaN
        assertThrows(IllegalArgumentException::class.java) { prepared.measure(step) }
        assertOutOfTurn { prepared.prepare() }
    }
}
