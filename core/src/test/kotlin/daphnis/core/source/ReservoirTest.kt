package daphnis.core.source

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.initial.EqualSizes
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.search.Overlap
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt

/** Reservoirs on spheres that rest, so that nothing but their trials is seen. */
class ReservoirTest {
    private fun supply(radius: Double, mass: Double = 1.0) = Supply(EqualSizes(radius), radius, mass = mass)

    /** The number of spheres after each of [steps] steps. */
    private fun numbers(
        source: Source,
        box: Box,
        steps: Int,
        seed: Long,
        population: Population = empty(),
        see: (Population) -> Unit = {},
    ): IntArray {
        val sources = Sources(listOf(source), seed)
        val boundary = Periodic(box)
        return IntArray(steps) {
            sources.act(population, Partition.Whole, boundary, 0.1 * (it + 1), 0.1, 0.4)
            see(population)
            population.size
        }
    }

    @Test
    fun `points come and go so that their number has the distribution of Poisson`() {
        val box = Box.centred(4.0, 3.0, 2.0)
        val mean = 6.0
        val radius = 1e-5
        val filling = mean / box.volume * 4 / 3 * PI * radius * radius * radius
        val numbers = numbers(Reservoir(box, filling, 1.0, supply(radius), trials = 60), box, 10_000, 1).drop(100)
        var chance = exp(-mean)
        var chi = 0.0
        for (n in 0..14) {
            val expected = numbers.size * chance
            val found = numbers.count { it == n }
            // Sixty trials change nearly all of six points, so the numbers are all but independent.
            chi += (found - expected) * (found - expected) / expected
            chance *= mean / (n + 1)
        }
        assertTrue(chi in 3.0..40.0) { "χ² = $chi of 15 numbers" }
    }

    @Test
    fun `hard spheres have the density and its fluctuations that Carnahan and Starling give`() {
        val box = Box.centred(6.0, 6.0, 6.0)
        for ((filling, seed) in listOf(0.1 to 2L, 0.2 to 3L)) {
            val all = numbers(Reservoir(box, filling, 1.0, supply(0.5), trials = 400), box, 6_000, seed).drop(200)
            val expected = filling * box.volume / (PI / 6)
            val mean = blocks(all.map { it.toDouble() })
            assertTrue(abs(mean.value - expected) < 4 * mean.error) { "$filling: $mean, expected $expected" }
            assertTrue(mean.error < 0.004 * expected) { "$mean" }
            val square = blocks(all.map { (it - mean.value) * (it - mean.value) / mean.value })
            val low = 1 - filling
            val f2 = filling * filling
            val ratio = low * low * low * low / ((1 + 2 * filling) * (1 + 2 * filling) - 4 * f2 * filling + f2 * f2)
            assertTrue(abs(square.value - ratio) < 4 * square.error) { "$filling: $square, expected $ratio" }
            assertTrue(square.error < 0.08 * ratio) { "$square" }
        }
    }

    @Test
    fun `discs have the density of Henderson's fluid`() {
        val box = Box.flat(9.0, 9.0)
        val filling = 0.25
        val all = numbers(Reservoir(box, filling, 1.0, supply(0.5), trials = 200), box, 5_000, 4) { p ->
            assertTrue(p.z.all { it == 0.0 } && p.vz.all { it == 0.0 })
        }.drop(200)
        val mean = blocks(all.map { it.toDouble() })
        val expected = filling * box.volume / (PI / 4)
        assertTrue(abs(mean.value - expected) < 4 * mean.error) { "$mean, expected $expected" }
        assertTrue(mean.error < 0.004 * expected) { "$mean" }
    }

    @Test
    fun `what comes overlaps nothing, has the velocities of the gas and is of the region alone`() {
        val box = Box.centred(6.0, 6.0, 6.0)
        // It ends at a face, beyond which images are.
        val region = Box(1.0, -3.0, -2.0, 3.0, 3.0, 1.0)
        var squares = 0.0
        var count = 0
        val reservoir = Reservoir(region, 0.3, 2.0, supply(0.4, mass = 0.5), trials = 300)
        numbers(reservoir, box, 300, 5) { p ->
            for (k in 0 until p.size) {
                assertTrue(region.contains(p.x[k], p.y[k], p.z[k]))
                assertEquals(0.4, p.radius[k])
                squares += p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k]
                count += 3
            }
            assertEquals(p.size, p.id.distinct().size)
            Overlap.requireNone(p, Periodic(box), 0.0)
        }
        assertTrue(count > 9_000) { "$count" }
        assertEquals(4.0, squares / count, 4 * 4.0 * sqrt(2.0 / 1_500))
    }

    @Test
    fun `spheres of another kind are never taken, and nothing comes where walls are`() {
        val box = Box.centred(6.0, 6.0, 6.0)
        val one = doubleArrayOf(0.0)
        val other = Population(one, one, one.copyOf(), one, one, one, doubleArrayOf(1.5), doubleArrayOf(1.0))
        val sources = Sources(listOf(Reservoir(box, 0.2, 1.0, supply(0.5), trials = 300)), 6)
        val walls = Walls(box)
        repeat(200) { step ->
            sources.act(other, Partition.Whole, walls, 0.1 * step, 0.1, 0.4)
            assertEquals(1.5, other.radius[other.indexOf(0)])
            for (axis in 0..2) {
                for (k in 0 until other.size) {
                    assertTrue(abs(other.position(axis)[k]) <= 3 - other.radius[k])
                }
            }
        }
        assertTrue(other.size > 30) { "${other.size}" }
        Overlap.requireNone(other, walls, 0.0)
    }

    @Test
    fun `spheres that spin come with the spins of the gas, and their energy is counted`() {
        val box = Box.centred(6.0, 6.0, 6.0)
        val none = doubleArrayOf()
        val p = empty().withSpin(none, none, none)
        val sources = Sources(listOf(Reservoir(box, 0.2, 2.0, supply(0.3, mass = 0.5), trials = 4_000)), 7)
        sources.act(p, Partition.Whole, Periodic(box), 0.1, 0.1, 0.4)
        val n = p.size
        assertTrue(n > 200) { "$n" }
        val inertia = 0.4 * 0.5 * 0.3 * 0.3
        val squares = (0 until n).sumOf { p.wx[it] * p.wx[it] + p.wy[it] * p.wy[it] + p.wz[it] * p.wz[it] }
        assertEquals(2.0, inertia * squares / (3 * n), 4 * 2 * sqrt(2.0 / (3 * n)))
        val motion = (0 until n).sumOf { p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it] }
        assertEquals((0.5 * motion + inertia * squares) / 2, sources.sums.energy(0), 1e-9)
    }

    @Test
    fun `what is drawn follows from seed, place in the list and time alone`() {
        val box = Box.centred(6.0, 6.0, 6.0)
        val reservoir = Reservoir(box, 0.1, 1.0, supply(0.5), trials = 50)
        fun first(seed: Long, place: Int, time: Double): Double {
            val p = empty()
            val all = List(place) { Outflow(Box.centred(0.1, 0.1, 0.1)) } + reservoir
            Sources(all, seed).act(p, Partition.Whole, Periodic(box), time, 0.1, 0.4)
            return p.x[p.indexOf(0)]
        }
        assertEquals(first(1, 0, 0.5), first(1, 0, 0.5))
        assertEquals(4, listOf(first(1, 0, 0.5), first(2, 0, 0.5), first(1, 1, 0.5), first(1, 0, 0.6)).distinct().size)
    }
}
