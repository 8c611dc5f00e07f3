package daphnis.core.step

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.contactTime
import daphnis.core.engine.SerialEngine
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.queue.EventSink
import daphnis.core.randomSpheres
import daphnis.core.search.GridSort
import daphnis.core.search.SearchStructure
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** The contract of [Candidates]: the fast ones find what the slow ones find, over all boundaries, images and sizes. */
class CandidatesTest {
    private data class Event(val time: Double, val lower: Int, val higher: Int, val image: Int)

    /** Keeps what is found, of each pair from the lower slot; places are slots unless [slotOf] says otherwise. */
    private class Found(private val slotOf: (Int) -> Int = { it }) : EventSink {
        val events = ArrayList<Event>()

        override fun add(time: Double, first: Int, second: Int, image: Int) {
            val slot = slotOf(first)
            val swap = second in 0 until slot
            events += if (swap) Event(time, second, slot, Images.negated(image)) else Event(time, slot, second, image)
        }
    }

    private class Case(val seed: Long) {
        val random = SeededRandom(seed)
        private val box = Box.centred(random.nextDouble(4.0, 9.0), random.nextDouble(4.0, 9.0), height())
        private val boundary = boundaries(box)[random.nextInt(9)]
        private val least = listOf(0.02, 0.2, 0.6)[random.nextInt(3)]
        val population = randomSpheres(2 + random.nextInt(60), boundary, seed, 2.0) { it.nextDouble(least, 0.8) }
        val step = CollisionStep(
            population,
            boundary,
            CollisionLaw(ConstantRestitution(1.0)),
            CollisionCounters(),
            SearchStructure.entries[random.nextInt(SearchStructure.entries.size)],
        )
        val prepared = PreparedStep(GridSort.entries[random.nextInt(GridSort.entries.size)])
        val rows get() = prepared.rows

        /** Whether the grid has cells over a part of the box only. */
        val isPart get() = prepared.grid.levels[0].let { it.count.asList() != it.cells.asList() }
        val story = "seed $seed, ${boundary.javaClass.simpleName}, ${population.size} spheres, ${step.search}"

        private fun height() = if (random.nextInt(3) == 0) 2.1 else random.nextDouble(4.0, 9.0)

        init {
            step.start = random.nextDouble(0.0, 9.0)
            step.duration = Math.pow(10.0, random.nextDouble(-2.0, 0.3))
            // A mean flow on top, which close bounds follow.
            for (k in 0 until population.size) population.vx[k] += population.y[k] / 5
            if (random.nextInt(3) == 0) measurePart() else prepared.measure(step)
            prepared.prepare()
            // Closer bounds in half of the cases, few as the spheres are.
            if (random.nextInt(2) == 0) {
                prepared.bounds.measure(prepared.grid, rows, step.duration, InlineLoop, fewest = 0.0)
            }
        }

        /** Only the spheres in a part of the box are left, over which the cells of the grid are laid. */
        private fun measurePart() {
            val whole = PreparedStep().also { it.measure(step) }
            val middle = DoubleArray(3) { axis ->
                val isPart = boundary.hasImages(axis) && random.nextInt(3) > 0
                if (isPart) random.nextDouble(box.lower(axis), box.upper(axis)) else Double.NaN
            }
            val part = random.nextDouble(0.1, 0.5)
            fun isKept(k: Int) = (0..2).all { isNear(it, population.position(it)[k], middle[it], part) }
            val kept = BooleanArray(population.size) { isKept(it) }
            if (kept.count { it } > 1) {
                population.retain { kept[it] }
                prepared.takePart(whole, population, middle)
            } else {
                prepared.measure(step)
            }
        }

        private fun isNear(axis: Int, x: Double, middle: Double, part: Double): Boolean {
            if (middle.isNaN()) return true
            val boxes = (x - middle) / box.length(axis)
            return Math.abs(boxes - Math.rint(boxes)) <= part
        }

        private fun boundaries(box: Box): List<BoundaryConditions> = listOf(
            Open,
            Periodic(box),
            Periodic(box, true, true, false),
            Walls(box, 0.9),
            ShearedPeriodic(box, 0.7),
            LeesEdwards(box, random.nextDouble(-1.0, 1.0)),
            LeesEdwards(box, 1.4),
            HillSheet(box, 0.2),
            HillSheet(box, 0.2, radiallyOpen = true),
        )

        /** Sphere [slot] has a collision at [time], after which it goes as fast as the bound allows, or slower. */
        fun collide(slot: Int, time: Double) {
            rows.advance(slot, time)
            for (axis in 0..2) {
                val speed = prepared.reach.speed[axis]
                rows.state[slot * STRIDE + VX + axis] = random.nextDouble(-speed, speed)
            }
            prepared.bounds.include(slot, rows, slot)
        }
    }

    private fun assertSame(story: String, exact: Found, fast: Found): Int {
        assertEquals(fast.events.size, fast.events.toSet().size) { "$story: found twice" }
        assertEquals(exact.events.toSet(), fast.events.toSet()) { story }
        return fast.events.size
    }

    @Tag("thorough")
    @Test
    fun `at the start each potential collision is found once, at the same time to the last bit`() {
        var events = 0
        var parts = 0
        for (seed in 1L..400L) {
            val case = Case(seed)
            val n = case.rows.size
            val exact = Found().also { ExactCandidates(case.prepared).start(0, n, it) }
            val fast = Found()
            val middle = case.random.nextInt(n + 1)
            case.prepared.candidates().start(middle, n, fast)
            case.prepared.candidates().start(0, middle, fast)
            events += assertSame(case.story, exact, fast)
            if (case.isPart) parts++
        }
        assertTrue(events > 3000) { "only $events" }
        assertTrue(parts > 15) { "only $parts grids have cells over a part of the box" }
    }

    @Tag("thorough")
    @Test
    fun `around a sphere that has just collided the same is found, whoever has collided before`() {
        var events = 0
        for (seed in 1L..400L) {
            val case = Case(seed)
            val exact = ExactCandidates(case.prepared)
            val fast = case.prepared.candidates()
            val times = DoubleArray(12) { case.random.nextDouble() * case.step.duration }.sorted()
            for (time in listOf(0.0) + times + times.last()) {
                val slot = case.random.nextInt(case.rows.size)
                case.collide(slot, time)
                val except = case.random.nextInt(case.rows.size + 1) - 1
                val slow = Found().also { exact.around(case.rows, slot, except, it) }
                val quick = Found().also { fast.around(case.rows, slot, except, it) }
                val names = quick.events.any { it.lower == except || it.higher == except }
                assertFalse(except >= 0 && except != slot && names) { "${case.story}: $except is not left out" }
                events += assertSame("${case.story}: $slot at $time", slow, quick)
            }
        }
        assertTrue(events > 2000) { "only $events" }
    }

    @Test
    fun `from copies the same is found, and of a sphere whose time is unknown every image that it may be`() {
        var unknown = 0
        for (seed in 1L..300L) {
            val case = Case(seed)
            val now = case.random.nextDouble() * case.step.duration
            val slot = case.random.nextInt(case.rows.size)
            case.collide(slot, now)
            val copies = StepRows().apply { take(case.rows, slot) }
            val known = Found().also { ExactCandidates(case.prepared).around(copies, 0, -1, it) }.events
            val taken = (0 until case.rows.size).filter { it == slot || case.random.nextInt(3) == 0 }
            for (other in taken) case.rows.state[other * STRIDE + TIME] = Double.NaN
            val found = Found { slot }.also { case.prepared.candidates().around(copies, 0, -1, it) }.events
            for (event in Found { slot }.also { sink -> known.forEach { it.resend(sink) } }.events) {
                val other = if (event.lower == slot) event.higher else event.lower
                val time = if (other in taken) Double.NaN else event.time
                assertTrue(event.copy(time = time) in found) { "${case.story}: $event of $slot is missing" }
                if (time.isNaN()) unknown++
            }
            assertTrue(found.all { it.time.isNaN() == (it.higher in taken && it.lower in taken) }) { case.story }
        }
        assertTrue(unknown > 20) { "only $unknown" }
    }

    /** Hands an event that was found from place 0 on to [sink] as it was found. */
    private fun Event.resend(sink: EventSink) {
        if (lower == 0) sink.add(time, 0, higher, image) else sink.add(time, 0, lower, Images.negated(image))
    }

    @Tag("thorough")
    @Test
    fun `a view shows all who can be hit, also those ahead in time, until the viewer wants no more`() {
        var seen = 0
        for (seed in 1L..200L) {
            val case = Case(seed)
            val now = case.random.nextDouble() * case.step.duration
            val slot = case.random.nextInt(case.rows.size)
            for (k in 0 until case.rows.size) if (k != slot && k % 3 == 0) case.collide(k, case.step.duration * 0.9)
            case.collide(slot, now)
            fun hits(candidates: Candidates): Set<Event> {
                val hits = Found()
                val isWhole = candidates.view(slot) { other, image ->
                    val t = contactTime(case.rows, slot, other, image, case.prepared.images)
                    if (t <= case.step.duration) hits.add(t, slot, other, image)
                    true
                }
                assertTrue(isWhole)
                return hits.events.toSet()
            }
            val exact = hits(ExactCandidates(case.prepared))
            assertEquals(exact, hits(case.prepared.candidates())) { case.story }
            seen += exact.size
            var looks = 0
            assertFalse(case.prepared.candidates().view(slot) { _, _ -> looks++ < 0 })
            assertEquals(1, looks)
        }
        assertTrue(seen > 60) { "only $seen" }
    }

    @Test
    fun `an engine does not notice who has worked on its prepared step before`() {
        for (seed in 1L..20L) {
            val case = Case(seed)
            for (slot in 0 until case.rows.size) case.rows.state.fill(Double.NaN, slot * STRIDE, slot * STRIDE + RADIUS)
            val expected = digest(case, SerialEngine())
            assertEquals(expected, digest(case, SerialEngine(prepared = case.prepared))) { case.story }
        }
    }

    private fun digest(case: Case, engine: SerialEngine): String {
        val population: Population = case.population.copy()
        val law = CollisionLaw(ConstantRestitution(0.8))
        val step = CollisionStep(population, case.step.boundary, law, CollisionCounters())
        step.start = case.step.start
        step.duration = 0.3
        repeat(3) {
            engine.advance(step)
            step.boundary.endStep(population, step.start + step.duration)
        }
        return stateDigest(population)
    }
}
