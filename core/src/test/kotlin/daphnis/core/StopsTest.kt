package daphnis.core

import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.parallel.InlineLoop
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class StopsTest {
    private fun stops(vararg lengths: Double, end: Double = Double.POSITIVE_INFINITY) =
        Stops(lengths.map { Interval(it) }, end)

    /** The times after each step from [start] to [end], with steps of at most [longest]. */
    private fun times(stops: Stops, longest: Double, start: Double = 0.0, end: Double = stops.end): List<Double> =
        generateSequence(start) { stops.timeAfter(it, stops.duration(it, longest)) }
            .drop(1).take(1_000_000).takeWhile { it <= end }.toList()

    @Test
    fun `multiples are counted from time 0, and one that is missed by round-off is one`() {
        val tenth = Interval(0.1)
        assertEquals(0.1 * 3, tenth.next(0.2))
        assertEquals(0.4, tenth.next(0.3)) { "0.3 is below 3 × 0.1, and is it" }
        assertTrue(tenth.isPassed(0.25, 0.3))
        assertFalse(tenth.isPassed(0.3, 0.1 * 3))
        assertEquals(-0.2, tenth.next(-0.3), 1e-15)
        for (k in 1..100_000) assertEquals((k + 1) * 0.1, tenth.next(k * 0.1))
        for (length in listOf(0.0, -1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { Interval(length) }
        }
    }

    @Test
    fun `an end is set between steps, also one that is behind`() {
        val stops = stops(end = 1.0)
        assertEquals(listOf(0.5, 1.0), times(stops, 0.6))
        stops.end = 2.25
        assertEquals(listOf(1.5, 2.0, 2.25), times(stops, 0.6, start = 1.0))
        stops.end = 2.0
        assertEquals(Double.POSITIVE_INFINITY, stops.next(2.25))
        assertThrows(IllegalArgumentException::class.java) { stops.end = Double.NaN }
        assertEquals(2.0, stops.end)
    }

    @Test
    fun `steps are an interval halved, all equal to the bit, and end at its multiples to the bit`() {
        val stops = stops(0.1, end = 100.0)
        val times = times(stops, 0.06)
        assertEquals(2000, times.size)
        for (k in 1..1000) assertEquals(if (k == 1000) 100.0 else k * 0.1, times[2 * k - 1])
        assertEquals(setOf(0.05), (listOf(0.0) + times.dropLast(1)).map { stops.duration(it, 0.06) }.toSet())
        assertEquals(listOf(0.1, 0.2), times(stops, 7.0).take(2)) { "no longer than an interval" }
    }

    @Test
    fun `steps from before time 0 end at 0 to the bit, without a step of round-off beside it`() {
        // 0.1 · 3 = 0.30000000000000004: a step of 0.3 would end 6e-17 before 0.
        assertEquals(listOf(0.0, 0.3, 0.6), times(stops(0.3), 0.3, start = -0.1 * 3, end = 0.7))
        val third = 1.0 / 3
        for (n in 1..500) {
            for ((length, longest) in listOf(0.1 to 0.1, 0.3 to 0.2, third to 1.0, 0.7 to 0.13)) {
                val times = times(stops(length), longest, start = -n * 0.1, end = 1.0)
                assertTrue(0.0 in times && (listOf(-n * 0.1) + times).zipWithNext { a, b -> b - a }.all { it > 1e-9 }) {
                    "from ${-n * 0.1} by $length"
                }
            }
        }
    }

    @Test
    fun `a step that ends at 0 but for round-off passes it, once`() {
        val third = Interval(0.3)
        assertTrue(third.isPassed(-0.1 * 3, -5.6e-17))
        assertFalse(third.isPassed(-5.6e-17, 0.25))
        assertTrue(third.isPassed(-0.25, 5.6e-17))
        assertFalse(third.isPassed(-0.2, -0.1))
    }

    @Test
    fun `intervals that do not divide one another, and an end that is no multiple, are all hit`() {
        val times = times(stops(0.3, 0.7, end = 1.65), 0.2)
        for (wanted in listOf(0.3, 0.6, 3 * 0.3, 0.7, 1.4, 1.2, 1.5, 1.65)) assertTrue(wanted in times) { "$wanted" }
        assertEquals(1.65, times.last())
        assertEquals(times.distinct(), times)
        assertTrue((listOf(0.0) + times).zipWithNext { a, b -> b - a }.all { it in 1e-3..0.2 }) { "$times" }
        assertEquals(listOf(0.3), times(stops(0.3, 0.1 * 3, 1.0, end = 0.3), 9.0)) { "one stop, not two" }
    }

    @Test
    fun `without an interval steps are powers of two until the end, whatever the end is`() {
        val far = times(stops(end = 10.0), 0.3)
        val near = times(stops(end = 1.1), 0.3)
        assertEquals(listOf(0.25, 0.5, 0.75, 1.0, 1.1), near)
        assertEquals(near.dropLast(1), far.take(4))
        assertEquals(listOf(0.5, 1.0), times(stops(), 0.9, end = 1.0))
        assertEquals(listOf(5.0), times(stops(8.0, end = 5.0), 9.0)) { "an interval longer than the run" }
    }

    @Test
    fun `a start in the middle goes on as the whole does`() {
        val stops = stops(0.3, 0.7, end = 3.0)
        val all = times(stops, 0.2)
        for (k in all.indices) assertEquals(all.drop(k + 1), times(stops, 0.2, all[k]))
    }

    @Test
    fun `a step that is lost in the rounding of the time is refused`() {
        val e = assertThrows(IllegalStateException::class.java) { stops(1.0).duration(1e6, 1e-12) }
        assertTrue("lost in the rounding" in e.message.orEmpty()) { e.message }
    }

    @Test
    fun `the fastest sphere relative to the flow decides how long a step is`() {
        val flow = LeesEdwards(Box.centred(9.0, 9.0, 9.0), 2.0).meanFlow
        val p = populationOf(Sphere(y = 1.0, vx = 2.5), Sphere(y = -3.0, vx = -6.0, vz = 0.25))
        assertEquals(1.0 / 0.5, FreePathTimeStep(1.0, 9.0, flow, stops()).next(p))
        assertEquals(1.0 / 6.0, FreePathTimeStep(1.0, 9.0, null, stops()).next(p))
        assertEquals(0.5, FreePathTimeStep(1.0, 9.0, flow, stops()).measure(p, InlineLoop))
        assertEquals(9.0, FreePathTimeStep(1.0, 9.0, null, stops()).next(populationOf(Sphere()))) { "at rest" }
        assertThrows(IllegalArgumentException::class.java) { FreePathTimeStep(Double.NaN, 9.0, null, stops()) }
        assertThrows(IllegalArgumentException::class.java) { FreePathTimeStep(1.0, 0.0, null, stops()) }
    }

    @Test
    fun `a simulation ends its steps at the stops, also of a time step of one's own`() {
        class Own(override val stops: Stops) : StoppingTimeStep {
            override fun next(population: daphnis.core.population.Population) = 0.4
        }
        val simulation = Simulation(
            populationOf(Sphere(vx = 1.0)),
            Periodic(Box.centred(9.0, 9.0, 9.0)),
            null,
            Own(stops(0.3, end = 0.7)),
        )
        val times = List(3) { simulation.apply { advance() }.time }
        assertEquals(listOf(0.3, 0.6, 0.7), times)
        assertEquals(0.7, simulation.population.x[0], 1e-15)
    }
}
