package daphnis.core.search

import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.hill.HillSheet
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.Population
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The bound on how far spheres go in a step, worked out by hand: 5 % of headroom, a tenth of the fastest at least. */
class ReachTest {
    private val population =
        populationOf(Sphere(vx = 1.0, vy = -2.0, r = 0.1), Sphere(x = 9.0, y = 5.0, z = -7.0, vx = -4.0, r = 0.1))

    private fun reach(p: Population = population, boundary: BoundaryConditions = Open, duration: Double = 0.5) =
        Reach().apply { measure(p, boundary, duration) }

    /** The second sphere, in slot 1, has got [v] along [axis] at [time]. */
    private fun rows(axis: Int, v: Double, time: Double = 0.0, p: Population = population, duration: Double = 0.5) =
        StepRows().apply {
            load(p, intArrayOf(0, 1), duration, false)
            state[STRIDE + VX + axis] = v
            state[STRIDE + TIME] = time
        }

    private fun assertNear(expected: List<Double>, actual: DoubleArray) {
        for (axis in 0..2) assertEquals(expected[axis], actual[axis], 1e-10) { "axis $axis of ${actual.asList()}" }
    }

    @Test
    fun `it is the fastest along each axis, with headroom, for the length of the step`() {
        val reach = reach()
        assertNear(listOf(4.2, 2.1, 0.42), reach.speed)
        assertNear(listOf(2.1, 1.05, 0.21), reach.bound)
        for (axis in 0..2) assertTrue(reach.bound[axis] > reach.speed[axis] * 0.5) { "no room for rounding" }
    }

    @Test
    fun `the headroom that one part of the spheres needed is had by all parts in the next step`() {
        val parts = List(2) { reach() }
        parts[0].enlarge(rows(0, 4.3), 1, -1, population, 0.5)
        for (part in parts) part.look(population, Open, everywhere = false, InlineLoop)
        val numbers = parts.map { it.measured.numbers() }
        val greatest = DoubleArray(numbers[0].size) { k -> maxOf(numbers[0][k], numbers[1][k]) }
        for (part in parts) {
            part.measured.take(greatest)
            part.apply(Open, 0.5)
            // Half as much again as the least headroom, and a fiftieth of it lost with the step.
            assertNear(listOf(4.0 * 1.0735, 2.0 * 1.0735, 0.4 * 1.0735), part.speed)
        }
    }

    @Test
    fun `a sphere outruns it along any axis by its speed, if enough of the step is left`() {
        val reach = reach()
        for (axis in 0..2) {
            for (sign in listOf(-1, 1)) {
                val fast = sign * (reach.speed[axis] + 0.1)
                assertEquals(true, reach.isOutrun(rows(axis, fast), 1, population, 0.5)) { "axis $axis, $sign" }
                assertEquals(false, reach.isOutrun(rows(axis, fast, 0.4), 1, population, 0.5)) { "axis $axis, $sign" }
                val within = sign * reach.speed[axis]
                assertEquals(false, reach.isOutrun(rows(axis, within), 1, population, 0.5)) { "axis $axis, $sign" }
            }
        }
    }

    @Test
    fun `what counts is where a sphere ends, not how fast it got there`() {
        // Half way it is 1 to the left of its start, and from there goes 1.5: 0.5 or 2.5 away in the end, of 2.1.
        for ((v, isOutrun) in listOf(6.0 to false, -6.0 to true)) {
            val rows = rows(0, v, 0.25).apply { state[STRIDE] -= 1.0 }
            assertEquals(isOutrun, reach().isOutrun(rows, 1, population, 0.5)) { "$v" }
        }
    }

    @Test
    fun `spheres that contacts cannot be computed for are refused, and no sphere at all is not`() {
        val tiny = populationOf(Sphere(r = 1e-80))
        val message = assertThrows(IllegalArgumentException::class.java) { reach(tiny) }.message!!
        assertTrue("smallest radius" in message) { message }
        assertNear(listOf(0.0, 0.0, 0.0), reach(populationOf()).bound)
    }

    @Test
    fun `after an excess there is room for twice as much, and more headroom, which fades`() {
        // Whichever of the two is named first.
        for ((first, second) in listOf(1 to -1, 1 to 0, 0 to 1)) {
            val reach = reach()
            val rows = rows(1, -3.5)
            reach.enlarge(rows, first, second, population, 0.5)
            // 2 + 2 · (3.5 − 2) along y, a tenth of it along z; 5 % by half as much again.
            assertNear(listOf(4 * 1.075, 5 * 1.075, 0.5 * 1.075), reach.speed)
            assertEquals(false, reach.isOutrun(rows, 1, population, 0.5))
            reach.measure(population, Open, 0.5)
            assertNear(listOf(4 * 1.0735, 2 * 1.0735, 0.4 * 1.0735), reach.speed)
            repeat(30) { reach.measure(population, Open, 0.5) }
            assertNear(listOf(4.2, 2.1, 0.42), reach.speed)
        }
    }

    @Test
    fun `in a flow in which images slide, what every axis gets is of speeds relative to it`() {
        val sheet = HillSheet(Box.centred(200.0, 200.0, 10.0), 0.2)
        val rate = sheet.meanFlow!!.rate
        fun sphere(x: Double, vx: Double, slower: Double) = Sphere(x = x, vx = vx, vy = rate * x - slower, r = 0.5)
        // 0.3 a sphere across; then a tenth of 5 along the flow, or of 8 across it; and a part of 30, which all go at.
        for ((vx, slower, least) in listOf(
            Triple(0.0, 0.0, 0.3),
            Triple(0.0, 5.0, 0.5),
            Triple(0.0, -5.0, 0.5),
            Triple(8.0, 5.0, 0.8),
            Triple(0.0, 90.0, 8.9),
        )) {
            val reach = reach(populationOf(sphere(-99.0, 0.0, 0.0), sphere(10.0, vx, slower)), sheet)
            assertEquals(least * 1.05, reach.speed[2], 0.11) { "$vx, $slower" }
            assertEquals(maxOf(vx, least) * 1.05, reach.speed[0], 0.11) { "$vx, $slower" }
        }
    }

    @Test
    fun `along a periodic axis it ends at half of sixteen boxes less the radius, and headroom gives way`() {
        for (axis in 0..2) {
            val box = Periodic(Box.centred(2.0, 2.0, 2.0))
            fun gas(v: Double) = DoubleArray(3) { if (it == axis) v else 0.0 }.let {
                populationOf(Sphere(vx = it[0], vy = it[1], vz = it[2], r = 0.5), Sphere(x = 0.9, r = 0.25))
            }
            val p = gas(30.9)
            val reach = reach(p, box)
            assertEquals(31.0, reach.speed[axis], 1e-6)
            val refusal = assertThrows(IllegalArgumentException::class.java) { reach(gas(31.1), box) }
            assertTrue("16 boxes away along ${"xyz"[axis]} within" in refusal.message!!) { refusal.message!! }
            // A collision may not lead there either, whoever is named first.
            val rows = rows(axis, 40.0, p = p)
            assertThrows(IllegalArgumentException::class.java) { reach.enlarge(rows, 1, 0, p, 0.5) }
            assertThrows(IllegalArgumentException::class.java) { reach.enlarge(rows, 0, 1, p, 0.5) }
            assertEquals(31.0, reach.speed[axis], 1e-6)
            // One that no sphere outruns is no obstacle.
            reach.enlarge(rows(axis, 30.0, p = p), 1, -1, p, 0.5)
        }
    }

    @Test
    fun `images that slide far in a step are looked for in fewer boxes`() {
        val box = Box.centred(10.0, 8.0, 6.0)
        // Slides by 8 · 5 · 0.5 = 20, two boxes: (127 − 16 − 2) / 3 − 2 would be more than are looked for.
        val fast = LeesEdwards(box, 5.0)
        assertEquals(16.0, ImageRange.boxes(fast, 1, 0.5))
        // By 80, eight boxes: 109 / 9 − 2.
        assertEquals(109.0 / 9 - 2, ImageRange.boxes(fast, 1, 2.0), 1e-12)
        assertEquals(listOf(16.0, 16.0), listOf(0, 2).map { ImageRange.boxes(fast, it, 2.0) })
        assertEquals(109.0 / 9 - 2, ImageRange.boxes(LeesEdwards(box, -5.0), 1, 2.0), 1e-12)
        assertEquals(8 * (109.0 / 9 - 2) / 2 - 0.5, ImageRange.mostReach(fast, 1, 0.5, 2.0), 1e-6)
        assertEquals(Double.POSITIVE_INFINITY, ImageRange.mostReach(Open, 1, 0.5, 2.0))
    }

    @Test
    fun `room for rounding is that of the end farther from the origin`() {
        for ((low, high) in listOf(-1024.0 to 1.0, -1.0 to 1024.0)) {
            assertEquals(16 * Math.ulp(1024.0), ImageRange.rounding(low, high))
        }
    }
}
