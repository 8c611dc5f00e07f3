package daphnis.core.engine.horizon

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class EpochPlanTest {
    private val space = EpochSpace(InlineLoop)
    private var size = 0

    private var threads = 1

    init {
        gas()
    }

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
    fun `epochs that looked through many roamers rest, and are tried again some time`() {
        val plan = EpochPlan()
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
    fun `an epoch that was given up is not tried at once again, each time later, until one comes to its end`() {
        val plan = EpochPlan()
        plan.observe(FEW)
        fun restAfterGivingUp(): Int {
            assertNotNull(choose(plan))
            plan.abandoned(roamers = 0.0)
            return generateSequence { plan.rests() }.takeWhile { it }.count()
        }
        assertEquals(listOf(4, 8, 16, 32, 64, 64), List(6) { restAfterGivingUp() })
        plan.ended(4, FEW, strays = 0.0, roamers = 0.0, isBroken = false)
        assertEquals(4, restAfterGivingUp())
    }

    @Test
    fun `a fixed layout is refused where it is expected to be far too much work, unless it is wanted always`() {
        fun admit(plan: EpochPlan, tuning: HorizonTuning, always: Boolean = false) =
            plan.admit(tuning, size, space.frame, space.cells, ScalarFilter, threads, always)
        val plan = EpochPlan()
        plan.observe(FEW)
        val usual = HorizonTuning(4)
        val coarse = HorizonTuning(64, 5.0, 0.06, 0.01, 0.01)
        assertEquals(usual, admit(plan, usual))
        assertNull(admit(plan, coarse))
        assertTrue(plan.rests())
        assertEquals(coarse, admit(plan, coarse, always = true))
        // What an epoch that was given up has looked at counts, however good its layout is.
        assertEquals(usual, admit(plan, usual))
        plan.abandoned(roamers = 500.0)
        assertNull(admit(plan, usual))
    }

    @Test
    fun `one thread has no groups, and rests where epochs do not pay`() {
        val plan = EpochPlan()
        plan.observe(FEW)
        assertNotNull(choose(plan))
        assertFalse(plan.sharesCollisions)
        assertFalse(plan.rests())
        plan.observe(20 * MANY)
        // The more often they have not paid, the longer, up to a limit, and from the beginning once one has paid.
        for (rest in listOf(1, 2, 4, 8, 16, 16)) {
            assertNull(choose(plan))
            assertEquals(rest, generateSequence { plan.rests() }.takeWhile { it }.count())
        }
        plan.observe(FEW)
        assertNotNull(choose(plan))
        plan.observe(20 * MANY)
        assertNull(choose(plan))
        assertEquals(1, generateSequence { plan.rests() }.takeWhile { it }.count())
    }

    @Test
    fun `the longer the step, the more windows it is cut into, and a short one into none`() {
        val windows = listOf(0.01, 0.1, 2.0, 4.0, 8.0).map { dt ->
            gas(dt)
            choose(EpochPlan())?.windows ?: 0
        }
        assertEquals(listOf(1, 1), windows.take(2))
        assertTrue(windows[2] in 2..4 && windows[3] > windows[2] && windows[4] in 2 * windows[2]..32) { "$windows" }
    }

    @Test
    fun `a search in each of many windows tells no more than one`() {
        gas(dt = 8.0)
        val (once, often) = listOf(1, 12).map { searches ->
            val plan = EpochPlan()
            assertTrue(choose(plan)!!.windows > 4)
            // More than was expected, as where spheres are in clumps.
            repeat(searches) { plan.searched(30.0) }
            choose(plan)!!
        }
        assertEquals(once.windows, often.windows)
        assertEquals(once.cellsAcross, often.cellsAcross)
    }

    @Test
    fun `the larger the system, the shorter its epochs, since searches go farther over memory`() {
        val steps = listOf(16, 64).map { edge ->
            gas(edge = edge)
            EpochPlan().also { it.observe(SOME) }.let { choose(it)!!.steps }
        }
        assertTrue(steps[0] > steps[1]) { "$steps" }
    }

    @Test
    fun `very short steps make long epochs, but none in which spheres would go too far for lines`() {
        gas(dt = 1e-4)
        assertEquals(64, EpochPlan().also { it.observe(0.0) }.let { choose(it)!!.steps })
        // One of them goes through a quarter of the box in each step.
        val calm = Array(1000) { Sphere(it % 10 + 0.5, it / 10 % 10 + 0.5, it / 100 + 0.5, r = 0.1) }
        size = calm.size
        space.measure(populationOf(Sphere(0.2, 0.2, 0.2, vx = 2.5, r = 0.1), *calm), BOX, 1.0)
        assertEquals(8, EpochPlan().also { it.observe(0.0) }.let { choose(it)!!.steps })
        // Not even for one step: others take it, and the next ones too.
        gas(dt = 30.0)
        val plan = EpochPlan()
        plan.observe(0.0)
        assertNull(choose(plan))
        assertTrue(plan.rests())
    }

    @Test
    fun `many roamers make epochs shorter, since the longer one is the farther they fly, and searches for them`() {
        val steps = listOf(0.0, 20.0).map { roamers ->
            val plan = EpochPlan()
            plan.observe(FEW)
            val first = choose(plan)!!.steps
            plan.ended(first, FEW, strays = 0.0, roamers = roamers, isBroken = false)
            assertTrue(first > 3) { "$first steps" }
            choose(plan)?.steps ?: 0
        }
        assertTrue(steps[1] in 1 until steps[0]) { "$steps" }
        val bad = EpochPlan()
        bad.observe(FEW)
        choose(bad)
        bad.abandoned(roamers = 1000.0)
        assertNull(choose(bad))
    }

    @Test
    fun `where all leave their lines in each step there are epochs of one, if these pay`() {
        gas(dt = 2.0)
        val plan = EpochPlan()
        repeat(100) { plan.ended(2, FEW, strays = 1.0, roamers = 0.0, isBroken = true) }
        assertFalse(plan.rests())
        assertEquals(1, choose(plan)!!.steps)
    }

    @Test
    fun `a body among small spheres makes the steps of the serial engine longer`() {
        fun serial(memberRadius: Double): Double {
            space.frame.memberRadius = memberRadius
            return EpochCost(size, space.frame, space.cells, ScalarFilter, 1, SeenWork()).serial()
        }
        assertTrue(serial(0.499) > 1.5 * serial(0.5))
    }

    @Test
    fun `where many are much faster than most, more of them have cells`() {
        for ((part, bound) in listOf(0 to 3.0, 100 to 3.0, 20 to 5.0)) {
            gas { k -> if (part > 0 && k % part == 0) 4.0 else 1.0 }
            assertEquals(bound, choose(EpochPlan().also { it.observe(FEW) })!!.classBound) { "one of $part" }
        }
    }

    /** One for two threads. */
    private fun plan() = EpochPlan().also { threads = 2 }

    private fun choose(plan: EpochPlan): HorizonTuning? =
        plan.choose(size, space.frame, space.cells, ScalarFilter, threads)

    /** Measures a gas at a filling factor of 0.03, of so many spheres along each [edge] of its box. */
    private fun gas(dt: Double = 0.1, edge: Int = 16, speed: (k: Int) -> Double = { 1.0 }) {
        val n = edge * edge * edge
        size = n
        val random = SeededRandom(1)
        fun gauss() = DoubleArray(n) { random.nextGaussian() }
        val p = Population(
            DoubleArray(n) { SPACING * (it % edge + 0.5) },
            DoubleArray(n) { SPACING * (it / edge % edge + 0.5) },
            DoubleArray(n) { SPACING * (it / (edge * edge) + 0.5) },
            DoubleArray(n) { random.nextGaussian() * speed(it) },
            gauss(),
            gauss(),
            DoubleArray(n) { 0.5 },
            DoubleArray(n) { 1.0 },
        )
        val box = Box(0.0, 0.0, 0.0, edge * SPACING, edge * SPACING, edge * SPACING)
        space.measure(p, Periodic(box), dt)
    }

    private companion object {
        const val SPACING = 2.6
        val BOX = Periodic(Box(0.0, 0.0, 0.0, 10.0, 10.0, 10.0))

        /** Collisions per sphere and step. */
        const val FEW = 0.03
        const val SOME = 0.08
        const val MANY = 0.4
    }
}
