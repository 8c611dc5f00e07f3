package daphnis.core.search

import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.Pieces
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.Double.Companion.NEGATIVE_INFINITY
import kotlin.Double.Companion.POSITIVE_INFINITY

class StepBoundsTest {
    private val a = Sphere(1.0, -2.0, 3.0, vx = -4.0, vy = 1.0, vz = 0.5, r = 0.3)
    private val b = Sphere(-1.5, 2.5, 0.5, vx = 2.0, vy = -3.0, vz = 0.25, r = 0.2)
    private val thin = Periodic(Box.centred(10.0, 10.0, 10.0), true, false, true)

    private fun bounds(p: Population, boundary: BoundaryConditions, everywhere: Boolean) =
        StepBounds().apply { measure(p, boundary, everywhere, InlineLoop) }

    @Test
    fun `in pieces the same is found, and nothing is left of another measurement`() {
        val random = SeededRandom(3)
        val many = populationOf(
            *Array(9) {
                fun any() = random.nextDouble(-3.0, 3.0)
                Sphere(any(), any(), any(), any(), any(), any(), r = random.nextDouble(0.1, 0.3))
            },
        )
        val found = StepBounds().apply { measure(populationOf(a, b), thin, true, Pieces) }
        for (everywhere in listOf(true, false)) {
            found.measure(many, thin, everywhere, Pieces)
            assertEquals(bounds(many, thin, everywhere).numbers().toList(), found.numbers().toList())
        }
    }

    @Test
    fun `what is done along with it is done once with each sphere, in pieces that fit the cache`() {
        val many = populationOf(*Array(5000) { Sphere(it.toDouble()) })
        val pieces = ArrayList<IntRange>()
        val found = StepBounds()
        found.measure(many, thin, true, InlineLoop) { worker, from, to ->
            assertEquals(0, worker)
            pieces += from until to
            true
        }
        assertEquals(listOf(0..2047, 2048..4095, 4096..4999), pieces)
        assertEquals(4999.0, found.highest[0])
    }

    @Test
    fun `what looks along is believed where it says that all is finite, piece by piece`() {
        val many = populationOf(*Array(5000) { Sphere() })
        val found = StepBounds()
        for (spoilt in listOf(0, 2047, 2048, 4999)) {
            many.vz[spoilt] = Double.NaN
            for (believed in listOf(0, 2048, 4096)) {
                found.measure(many, Open, false, InlineLoop) { _, from, _ -> from == believed }
                assertEquals(spoilt in believed until believed + 2048, found.areFinite)
            }
            many.vz[spoilt] = 0.0
        }
    }

    @Test
    fun `what is done along with it is told which worker does it`() {
        val threeWorkers = object : RangeLoop {
            override val workers = 3

            override fun run(size: Int, grain: Int, body: RangeBody) {
                for (k in 0 until size) body.run(k % workers, k, k + 1)
            }
        }
        val told = HashMap<Int, Int>()
        StepBounds().measure(populationOf(*Array(7) { Sphere() }), thin, true, threeWorkers) { worker, from, _ ->
            told[from] = worker
            true
        }
        assertEquals((0 until 7).associateWith { it % 3 }, told)
    }

    @Test
    fun `a number that is not finite is noticed wherever it is, and forgotten`() {
        val found = StepBounds()
        for (k in listOf(0, 2047, 2048, 4999)) {
            val many = populationOf(*Array(5000) { Sphere() })
            for (column in listOf(many.x, many.y, many.z, many.vx, many.vy, many.vz, many.radius, many.mass)) {
                val old = column[k]
                for (bad in listOf(Double.NaN, POSITIVE_INFINITY, NEGATIVE_INFINITY)) {
                    column[k] = bad
                    found.measure(many, Open, false, InlineLoop)
                    assertFalse(found.areFinite)
                }
                column[k] = old
            }
            found.measure(many, Open, false, InlineLoop)
            assertTrue(found.areFinite)
        }
    }

    @Test
    fun `speeds, places and radii of two spheres, along open axes only if asked for`() {
        for (everywhere in listOf(true, false)) {
            val found = bounds(populationOf(a, b), thin, everywhere)
            assertEquals(listOf(4.0, 3.0, 0.5), found.fastest.toList())
            val (low, high) = if (everywhere) -2.0 to 2.5 else POSITIVE_INFINITY to NEGATIVE_INFINITY
            assertEquals(listOf(-1.5, low, 0.5), found.lowest.toList())
            assertEquals(listOf(1.0, high, 3.0), found.highest.toList())
            assertEquals(listOf(0.2, 0.3), listOf(found.leastRadius, found.largestRadius))
            assertFalse(found.isEmpty)
        }
        val none = bounds(populationOf(), Open, true)
        assertTrue(none.isEmpty)
        assertEquals(0.0, none.largestRadius)
    }

    @Test
    fun `the greatest of the numbers of parts are those of the whole, an empty part among them`() {
        val parts = listOf(populationOf(a), populationOf(), populationOf(b)).mapIndexed { k, p ->
            bounds(p, thin, true).apply { headroom = 0.125 * k }.numbers()
        }
        val taken = StepBounds().apply { take(DoubleArray(parts[0].size) { k -> parts.maxOf { it[k] } }) }
        val whole = bounds(populationOf(a, b), thin, true).apply { headroom = 0.25 }
        assertEquals(whole.numbers().toList(), taken.numbers().toList())
        assertEquals(listOf(0.2, 0.3, 0.25), listOf(taken.leastRadius, taken.largestRadius, taken.headroom))
        assertEquals(listOf(-1.5, -2.0, 0.5), taken.lowest.toList())
        assertEquals(listOf(1.0, 2.5, 3.0), taken.highest.toList())
        assertEquals(listOf(4.0, 3.0, 0.5), taken.fastest.toList())
    }
}
