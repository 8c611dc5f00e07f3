package daphnis.core.source

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.initial.EqualSizes
import daphnis.core.initial.PowerLawSizes
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt

/** Streams into a box at rest, in which nothing else happens. */
class InflowTest {
    private val box = Box.centred(6.0, 6.0, 6.0)
    private val point = Supply(EqualSizes(1e-9), 1e-9, mass = 1.0)
    private val rest = listOf(0.0, 0.0, 0.0)

    private fun stream(
        source: Source,
        steps: Int,
        seed: Long,
        boundary: BoundaryConditions = Periodic(box),
        see: (SourceSums) -> Unit = {},
    ): Population {
        val population = empty()
        val sources = Sources(listOf(source), seed)
        repeat(steps) {
            sources.act(population, Partition.Whole, boundary, 0.1 * (it + 1), 0.1, 0.4)
            see(sources.sums)
        }
        return population
    }

    @Test
    fun `as many come as the rate says, within what chance allows, and steps vary as chance does`() {
        val numbers = ArrayList<Double>()
        val all = stream(Inflow(box, 30.0, rest, 0.0, point), 3_000, 1) { numbers += it.came(0).toDouble() }
        assertEquals(9_000.0, all.size.toDouble(), 4 * sqrt(9_000.0))
        val variance = numbers.sumOf { (it - 3) * (it - 3) } / numbers.size
        // Of a variance of Poisson's: λ + 2λ² over the number of steps.
        assertEquals(3.0, variance, 4 * sqrt((3 + 2 * 9.0) / numbers.size))
        assertEquals((0 until all.size).toList(), all.id.toList())
    }

    @Test
    fun `they come anywhere in the region, with the stream and its spread`() {
        val region = Box(-1.0, 0.0, -3.0, 2.0, 1.0, 3.0)
        val p = stream(Inflow(region, 200.0, listOf(1.0, -2.0, 0.5), 0.3, point), 200, 2)
        val n = p.size.toDouble()
        for (axis in 0..2) {
            val v = listOf(1.0, -2.0, 0.5)[axis]
            assertEquals(v, p.velocity(axis).average(), 4 * 0.3 / sqrt(n))
            val spread = sqrt(p.velocity(axis).sumOf { (it - v) * (it - v) } / n)
            assertEquals(0.3, spread, 4 * 0.3 / sqrt(2 * n))
            val length = region.length(axis)
            val middle = region.lower(axis) + length / 2
            assertEquals(middle, p.position(axis).average(), 4 * length / sqrt(12 * n))
            assertTrue(p.position(axis).all { it >= region.lower(axis) && it < region.upper(axis) })
            assertTrue(p.position(axis).max() - p.position(axis).min() > 0.99 * length)
        }
    }

    /** ∫ c^power exp(−(c − u)²/2) dc over c > 0. */
    private fun moment(power: Int, u: Double): Double {
        val h = 1e-3
        return (0 until 20_000).sumOf { k ->
            val c = (k + 0.5) * h
            var term = exp(-(c - u) * (c - u) / 2) * h
            repeat(power) { term *= c }
            term
        }
    }

    @Test
    fun `through a face they come with the flux of a gas that streams, and their mean energy is 2T at rest`() {
        for ((face, u) in listOf(0 to 0.0, 1 to 0.0, 4 to 0.7, 5 to 3.0)) {
            val axis = face / 2
            val inward = if (face % 2 == 0) 1.0 else -1.0
            val velocity = List(3) { if (it == axis) inward * u else 0.0 }
            val p = stream(Inflow(box, 20_000.0, velocity, 1.0, point, face), 10, 3 + face.toLong())
            val n = p.size.toDouble()
            val v = p.velocity(axis).map { inward * it }
            assertTrue(v.all { it > 0 })
            val mean = moment(2, u) / moment(1, u)
            val square = moment(3, u) / moment(1, u)
            val fourth = moment(5, u) / moment(1, u)
            assertEquals(mean, v.average(), 4 * sqrt((square - mean * mean) / n)) { "face $face, u $u" }
            assertEquals(square, v.sumOf { it * it } / n, 4 * sqrt((fourth - square * square) / n))
            if (u > 0) continue
            val energies = (0 until p.size).map {
                (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) / 2
            }
            // 2T with variance 2T².
            assertEquals(2.0, energies.average(), 4 * sqrt(2 / n))
            // Each has flown for a part of the step that is uniform: ⟨v⟩ dt/2.
            val flown = (0 until p.size).map { if (inward > 0) p.x[it] + 3 else 3 - p.x[it] }
            assertEquals(sqrt(PI / 2) * 0.1 / 2, flown.average(), 4 * 0.07 / sqrt(n))
        }
    }

    @Test
    fun `the next come beside those that are there, and what has no place is counted`() {
        val sizes = Supply(PowerLawSizes(0.2, 0.5, 3.0), 0.5, density = 2.0)
        for (boundary in listOf(Periodic(box), Walls(box))) {
            var refused = 0L
            var came = 0L
            val p = stream(Inflow(box, 500.0, rest, 0.0, sizes), 100, 9, boundary) {
                refused += it.refused(0)
                came += it.came(0)
            }
            Overlap.requireNone(p, boundary, 0.0)
            assertEquals(p.size.toLong(), came)
            assertEquals(5_000.0, (came + refused).toDouble(), 4 * sqrt(5_000.0))
            assertTrue(refused > 3_000 && came > 200) { "$came $refused" }
            for (k in 0 until p.size) {
                assertEquals(2 * 4.0 / 3 * PI * p.radius[k] * p.radius[k] * p.radius[k], p.mass[k], 1e-12)
                if (boundary is Walls) assertTrue(abs(p.x[k]) <= 3 - p.radius[k])
            }
            assertTrue(p.radius.distinct().size == p.size)
        }
    }

    @Test
    fun `a stream that cannot get in is refused`() {
        fun fails(rate: Double, velocity: List<Double>, sigma: Double, face: Int) {
            assertThrows(IllegalArgumentException::class.java) { Inflow(box, rate, velocity, sigma, point, face) }
        }
        fails(0.0, rest, 1.0, -1)
        fails(Double.NaN, rest, 1.0, -1)
        fails(1.0, listOf(1.0), 1.0, -1)
        fails(1.0, rest, -1.0, -1)
        fails(1.0, rest, 0.0, 0)
        fails(1.0, listOf(-1.0, 0.0, 0.0), 1.0, 0)
        fails(1.0, listOf(1.0, 0.0, 0.0), 1.0, 1)
        fails(1.0, rest, 1.0, 6)
        assertThrows(IllegalArgumentException::class.java) { stream(Inflow(box, 2e8, rest, 1.0, point), 1, 1) }
    }
}
