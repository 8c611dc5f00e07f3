package daphnis.analysis.correlation

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.engine.CollisionForcing
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

class PairCorrelationTest {
    @Test
    fun `an elastic gas has the contact value of Carnahan and Starling, and no bin spans both sides of contact`() {
        // 1000 spheres of diameter 1 at φ = 0.3, from a lattice.
        val edge = Math.cbrt(1000 * PI / 6 / 0.3)
        val random = SeededRandom(4)
        fun place(k: Int) = -edge / 2 + (k + 0.5) * edge / 10
        val population = Population(
            DoubleArray(1000) { place(it % 10) },
            DoubleArray(1000) { place(it / 10 % 10) },
            DoubleArray(1000) { place(it / 100) },
            DoubleArray(1000) { random.nextGaussian() },
            DoubleArray(1000) { random.nextGaussian() },
            DoubleArray(1000) { random.nextGaussian() },
            DoubleArray(1000) { 0.5 },
            DoubleArray(1000) { 1.0 },
        )
        val pairs = PairCorrelation(2.0, 25, nearest = 1.0)
        val averages = Averages(pairs, from = 2.0, every = 10)
        val box = Periodic(Box.centred(edge, edge, edge))
        val simulation =
            Simulation(
                population,
                box,
                CollisionForcing(ConstantRestitution(1.0)),
                FixedTimeStep(0.02),
                outputs = listOf(averages),
            )
        repeat(600) { simulation.advance() }
        val contact = (1 - 0.15) / (0.7 * 0.7 * 0.7)
        // On to contact from the middles of the first two bins.
        val measured = 1.5 * averages.average(0).mean - 0.5 * averages.average(1).mean
        assertEquals(contact, measured, 0.03 * contact)
        assertEquals(1.02, pairs.centre(0), 1e-12)
    }

    @Test
    fun `few particles have g = 1 on average, in each bin, within its error, in whatever box`() {
        val box = Box.centred(10.0, 12.0, 8.0)
        val boundaries =
            listOf<BoundaryConditions>(
                Periodic(box),
                LeesEdwards(box, 0.5),
                HillSheet(box, 1.0),
                HillSheet(box, 1.0, true),
                Periodic(box, false, true, true),
            )
        for (boundary in boundaries + listOf(Periodic(box, false, false, true), Periodic(box, false, false, false))) {
            val averages = Averages(PairCorrelation(4.0, 4))
            for (seed in 1L..1500L) averages.add(uniform(5, boundary, seed))
            for (bin in 0 until 4) {
                val g = averages.average(bin)
                assertEquals(1.0, g.mean, 4 * g.error) { "${boundary.javaClass.simpleName}, bin $bin" }
                assertTrue(g.error < 0.2)
            }
        }
    }

    @Test
    fun `distances reach half the shortest edge of the axes that are used, and no farther`() {
        val flat = Box.centred(10.0, 12.0, 3.0)
        assertEquals(1.5, PairCorrelation.farthest(Periodic(flat)))
        assertEquals(5.0, PairCorrelation.farthest(HillSheet(flat, 1.0)))
        assertTrue(PairCorrelation.isInPlane(HillSheet(flat, 1.0)))
        assertFalse(PairCorrelation.isInPlane(LeesEdwards(flat, 1.0)))
        val message = assertThrows(IllegalArgumentException::class.java) {
            PairCorrelation(2.0, 3).of(uniform(10, Periodic(flat)))
        }.message!!
        assertTrue("1.5" in message) { message }
        PairCorrelation(5.0, 3).of(uniform(10, HillSheet(flat, 1.0)))
        for (nearest in listOf(-1.0, 2.0, Double.NaN)) {
            assertThrows(IllegalArgumentException::class.java) {
                PairCorrelation(2.0, 3, nearest)
            }
        }
    }

    /** Share of displacements [d] long that stay in the box, over all directions, where it has no images. */
    private fun room(boundary: BoundaryConditions, d: Double): Double {
        val lengths = List(2) { if (boundary.hasImages(it)) Double.POSITIVE_INFINITY else boundary.box.length(it) }
        var sum = 0.0
        var weights = 0.0
        for (k in 0 until DIRECTIONS) {
            for (m in 0 until if (boundary.hasImages(2)) DIRECTIONS else 1) {
                val around = 2 * PI * (k + 0.5) / DIRECTIONS
                val up = if (boundary.hasImages(2)) PI * (m + 0.5) / DIRECTIONS else PI / 2
                val x = abs(d * sin(up) * cos(around))
                val y = abs(d * sin(up) * sin(around))
                sum += sin(up) * (1 - x / lengths[0]) * (1 - y / lengths[1])
                weights += sin(up)
            }
        }
        return sum / weights
    }

    @Test
    fun `it is the number of pairs of all images, over that of particles spread evenly`() {
        val box = Box.centred(10.0, 12.0, 9.0)
        val boundaries = listOf<BoundaryConditions>(
            Periodic(box),
            LeesEdwards(box, 0.5),
            HillSheet(box, 1.0),
            HillSheet(box, 1.0, true),
            Periodic(box, false, true, true),
            Periodic(box, false, false, true),
            Periodic(box, false, false, false),
        )
        for (boundary in boundaries) {
            val uniform = uniform(60, boundary, seed = 9)
            // The last four are bodies, which do not count.
            val p = uniform.population
            val state = State(p, boundary, 0.37, firstBody = 56)
            val images = Images().also { it.prepare(boundary, 0.37) }
            val inPlane = !boundary.hasImages(2)
            val range = List(3) { if (boundary.hasImages(it)) -2..2 else 0..0 }
            val distances = ArrayList<Double>()
            for (i in 0 until 56) {
                for (j in i + 1 until 56) {
                    for (a in range[0]) {
                        for (b in range[1]) {
                            for (c in range[2]) {
                                val code = Images.code(a, b, c)
                                val x = p.x[j] - p.x[i] + images.shift(code, 0)
                                val y = p.y[j] - p.y[i] + images.shift(code, 1)
                                val z = if (inPlane) 0.0 else p.z[j] - p.z[i] + images.shift(code, 2)
                                distances += sqrt(x * x + y * y + z * z)
                            }
                        }
                    }
                }
            }
            val pairs = PairCorrelation(4.0, 7, nearest = 0.5)
            val g = pairs.of(state)
            for (bin in 0 until 7) {
                val a = 0.5 + bin * 0.5
                val b = a + 0.5
                val shell = if (inPlane) PI * (b * b - a * a) else 4.0 / 3 * PI * (b * b * b - a * a * a)
                val space = if (inPlane) 120.0 else 1080.0
                val even = 56 * 55 / 2 * shell / space * room(boundary, (a + b) / 2)
                assertEquals(distances.count { it >= a && it < b } / even, g[bin], 1e-4 * g[bin]) {
                    "${boundary.javaClass.simpleName}, bin $bin"
                }
            }
        }
    }

    @Test
    fun `a pair at the nearest distance counts, one at the farthest does not, and one particle has no pairs`() {
        val box = Periodic(Box.centred(10.0, 12.0, 8.0))
        val two = State(populationOf(Sphere(x = 0.0), Sphere(x = 1.0)), box, 0.0)
        assertEquals(960.0 / (4.0 / 3 * PI * (3.375 - 1)), PairCorrelation(2.0, 2, nearest = 1.0).of(two)[0], 1e-9)
        assertEquals(listOf(0.0, 0.0), PairCorrelation(1.0, 2).of(two).toList())
        val one = State(two.population, box, 0.0, firstBody = 1)
        for (state in listOf(one, uniform(0, box), uniform(0, Periodic(box.box, true, true, false)))) {
            assertTrue(PairCorrelation(2.0, 2).of(state).all { it.isNaN() })
        }
        val pairs = PairCorrelation(5.0, 4, nearest = 1.0)
        assertEquals(listOf(1.5, 2.5, 3.5, 4.5), List(4) { pairs.centre(it) })
        assertEquals(listOf(5.0, 4, 1.0), listOf(pairs.farthest, pairs.bins, pairs.nearest))
        PairCorrelation(4.0 * (1 + 1e-10), 1).of(two)
        assertThrows(IllegalArgumentException::class.java) { PairCorrelation(4.0 * (1 + 1e-8), 1).of(two) }
        assertThrows(IllegalArgumentException::class.java) { PairCorrelation(2.0, 0) }
        assertThrows(IllegalArgumentException::class.java) { PairCorrelation(Double.POSITIVE_INFINITY, 1) }
    }

    private companion object {
        const val DIRECTIONS = 400
    }

    @Test
    fun `in the plane every pair is counted whatever its heights, and none twice`() {
        val box = Box.centred(30.0, 40.0, 200.0)
        val random = SeededRandom(11)
        fun places(length: Double) = DoubleArray(300) { (random.nextDouble() - 0.5) * length }
        val z = places(150.0)
        val radius = DoubleArray(300) { if (it == 299) 4.0 else 0.2 + 0.8 * random.nextDouble() }
        val p = Population(places(30.0), places(40.0), z, z, z, z, radius, DoubleArray(300) { 1.0 })
        for (time in listOf(0.0, 0.3)) {
            val boundary = HillSheet(box, 1.0)
            val state = State(p, boundary, time, firstBody = 299)
            val images = Images().also { it.prepare(boundary, time) }
            val pairs = PairCorrelation(12.0, 24, 0.7)
            val counts = DoubleArray(24)
            for (i in 0 until 299) {
                for (j in 0 until i) {
                    for (ix in -1..1) {
                        for (iy in -2..2) {
                            val code = Images.code(ix, iy, 0)
                            val dx = p.x[j] - p.x[i] + images.shift(code, 0)
                            val dy = p.y[j] - p.y[i] + images.shift(code, 1)
                            val bin = Math.floor((sqrt(dx * dx + dy * dy) - 0.7) / (11.3 / 24)).toInt()
                            if (bin in 0 until 24) counts[bin]++
                        }
                    }
                }
            }
            val found = pairs.of(state)
            for (bin in 0 until 24) {
                val a = 0.7 + bin * 11.3 / 24
                val b = a + 11.3 / 24
                val expected = counts[bin] * 2 / (299 * 298.0 / state.area * PI * (b * b - a * a))
                assertEquals(expected, found[bin], 1e-9 * expected) { "bin $bin at $time" }
            }
        }
    }
}
