package daphnis.core.engine.horizon

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.ConstantRestitution
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class EpochPlanTest {
    private val space = EpochSpace(InlineLoop)
    private val start = gas()

    @Test
    fun `groups are not asked where it is expected, or was seen, that joining their work is more than it saves`() {
        val plan = plan()
        plan.observe(FEW)
        assertNotNull(choose(plan))
        assertTrue(plan.sharesCollisions)
        plan.joined(FEW, anew = 0.01 * FEW, compared = FEW)
        assertNotNull(choose(plan))
        assertTrue(plan.sharesCollisions)
        // All was processed three times, by one thread.
        plan.joined(FEW, anew = 3 * FEW, compared = 300 * FEW)
        assertFalse(choose(plan) != null && plan.sharesCollisions)
        val dense = plan()
        dense.observe(MANY)
        assertFalse(choose(dense) != null && dense.sharesCollisions)
    }

    @Test
    fun `after some time groups are asked again`() {
        val plan = plan()
        plan.observe(FEW)
        choose(plan)
        plan.joined(FEW, anew = 3 * FEW, compared = 300 * FEW)
        var asked = 0
        while (choose(plan) == null || !plan.sharesCollisions) asked++
        assertTrue(asked in 3..200) { "$asked times" }
        // One step in which nothing was dropped does not make up for that.
        plan.joined(FEW, anew = 3 * FEW, compared = 300 * FEW)
        plan.joined(FEW, anew = 0.0, compared = 0.0)
        assertFalse(choose(plan) != null && plan.sharesCollisions)
    }

    @Test
    fun `groups are asked again also where nothing but groups would make epochs pay`() {
        val plan = plan()
        plan.observe(SOME)
        assertNotNull(choose(plan))
        assertTrue(plan.sharesCollisions)
        plan.joined(SOME, anew = 3 * SOME, compared = 300 * SOME)
        assertNull(choose(plan))
        var asked = 0
        while (asked < 300 && choose(plan) == null) asked++
        assertTrue(asked in 3..200 && plan.sharesCollisions) { "$asked times" }
    }

    @Test
    fun `epochs that looked through many roamers rest, and are tried again some time`() {
        val plan = EpochPlan(1)
        plan.observe(FEW)
        assertNotNull(choose(plan))
        plan.ended(4, FEW, strays = 0.0, roamers = 1.0, isBroken = false)
        assertNotNull(choose(plan))
        plan.ended(4, FEW, strays = 0.0, roamers = 200.0, isBroken = false)
        var asked = 0
        while (choose(plan) == null) asked++
        assertTrue(asked in 10..200) { "$asked times" }
    }

    @Test
    fun `one thread has no groups, and rests where epochs do not pay`() {
        val plan = EpochPlan(1)
        plan.observe(FEW)
        assertNotNull(choose(plan))
        assertFalse(plan.sharesCollisions)
        assertFalse(plan.rests())
        plan.observe(20 * MANY)
        assertNull(choose(plan))
        assertEquals(16, generateSequence { plan.rests() }.takeWhile { it }.count())
    }

    @Test
    fun `the longer the step, the more windows it is cut into, and a short one into none`() {
        val windows = listOf(0.01, 0.1, 2.0, 4.0, 8.0).map { dt ->
            gas(dt)
            choose(EpochPlan(1))?.windows ?: 0
        }
        assertEquals(listOf(1, 1), windows.take(2))
        assertTrue(windows[2] in 2..4 && windows[3] > windows[2] && windows[4] in 2 * windows[2]..32) { "$windows" }
        assertFalse(EpochPlan(2).also { choose(it) }.sharesCollisions)
    }

    private fun plan() = EpochPlan(2)

    private fun choose(plan: EpochPlan): HorizonTuning? =
        plan.choose(start.size, space.frame, space.cells, ScalarFilter)

    /** A gas at a filling factor of 0.03, measured. */
    private fun gas(dt: Double = 0.1): Population {
        val n = 16 * 16 * 16
        val random = SeededRandom(1)
        fun gauss() = DoubleArray(n) { random.nextGaussian() }
        val p = Population(
            DoubleArray(n) { 2.6 * (it % 16 - 7.5) },
            DoubleArray(n) { 2.6 * (it / 16 % 16 - 7.5) },
            DoubleArray(n) { 2.6 * (it / 256 - 7.5) },
            gauss(),
            gauss(),
            gauss(),
            DoubleArray(n) { 0.5 },
            DoubleArray(n) { 1.0 },
        )
        val law = CollisionLaw(ConstantRestitution(1.0))
        val step = CollisionStep(p, Periodic(Box.centred(EDGE, EDGE, EDGE)), law, CollisionCounters())
        step.duration = dt
        val prepared = PreparedStep()
        prepared.measure(step, InlineLoop)
        space.frame.takeOver(step, prepared.reach, InlineLoop)
        space.cells.measure(p)
        return p
    }

    private companion object {
        const val EDGE = 16 * 2.6

        /** Collisions per sphere and step. */
        const val FEW = 0.03
        const val SOME = 0.08
        const val MANY = 0.4
    }
}
