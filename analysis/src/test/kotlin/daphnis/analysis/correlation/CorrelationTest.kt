package daphnis.analysis.correlation

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sqrt

class CorrelationTest {
    private fun at(
        x: List<Double>,
        y: List<Double>,
        z: List<Double>,
        boundary: daphnis.core.boundary.BoundaryConditions,
        time: Double = 0.0,
    ): State {
        val n = x.size
        val p =
            Population(
                x.toDoubleArray(),
                y.toDoubleArray(),
                z.toDoubleArray(),
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n) {
                    0.1
                },
                DoubleArray(n) { 1.0 },
            )
        return State(p, boundary, time)
    }

    private fun cubic(n: Int): State {
        val sites = (0 until n * n * n).map { Triple(it % n - n / 2.0, it / n % n - n / 2.0, it / n / n - n / 2.0) }
        return at(
            sites.map {
                it.first
            },
            sites.map {
                it.second
            },
            sites.map { it.third },
            Periodic(Box.centred(n.toDouble(), n.toDouble(), n.toDouble())),
        )
    }

    @Test
    fun `a cubic lattice has its 6, 12 and 8 neighbours at 1, √2 and √3, through all faces`() {
        val state = cubic(8)
        val n = 512.0
        val pairs = PairCorrelation(1.9, 190)
        val g = pairs.of(state)
        fun neighbours(r: Double): Double {
            val bin = (r / 0.01 + 1e-6).toInt()
            val shell = 4.0 / 3 * PI * (Math.pow((bin + 1) * 0.01, 3.0) - Math.pow(bin * 0.01, 3.0))
            return g[bin] * shell * (n - 1) / n
        }
        assertEquals(6.0, neighbours(1.0), 1e-9)
        assertEquals(12.0, neighbours(sqrt(2.0)), 1e-9)
        assertEquals(8.0, neighbours(sqrt(3.0)), 1e-9)
        assertEquals(0.0, g[50])
    }

    @Test
    fun `particles without correlation have g = 1 and S = 1, in a box and in a sheet whose images have slid`() {
        for (boundary in listOf(Periodic(Box.centred(10.0, 12.0, 8.0)), HillSheet(Box.centred(10.0, 12.0, 3.0), 1.0))) {
            val state = uniform(8000, boundary, radius = 0.01).let { State(it.population, boundary, 0.77) }
            for (g in PairCorrelation(3.0, 6).of(state)) assertEquals(1.0, g, 0.05)
            for (s in StructureFactor(8.0, 3).of(state)) assertEquals(1.0, s, 0.5)
        }
    }

    @Test
    fun `pairs are those of a plain count over all images`() {
        for (boundary in listOf(
            Periodic(Box.centred(10.0, 12.0, 8.0)),
            HillSheet(Box.centred(10.0, 12.0, 3.0), 1.0),
            HillSheet(Box.centred(10.0, 12.0, 3.0), 1.0, true),
            LeesEdwards(Box.centred(10.0, 12.0, 8.0), 0.5),
            LeesEdwards(Box.centred(10.0, 12.0, 8.0), -0.3),
        )) {
            val state = uniform(250, boundary, radius = 0.01).let { State(it.population, boundary, 0.77) }
            // A few sizes: the cells of the search are by size.
            for (k in 0 until 250) state.population.radius[k] = if (k % 50 == 0) 0.9 else 0.01 + 0.001 * (k % 7)
            val inPlane = boundary is HillSheet
            val images = Images().also { it.prepare(boundary, 0.77) }
            val counts = DoubleArray(6)
            val p = state.population
            for (i in 0 until 250) {
                for (j in i + 1 until 250) {
                    for (x in -2..2) {
                        for (y in -2..2) {
                            for (z in -1..1) {
                                if (x != 0 && boundary.contactFaces(0) != ContactFaces.PERIODIC || z != 0 && inPlane) {
                                    continue
                                }
                                val code = Images.code(x, y, z)
                                val dx = p.x[j] - p.x[i] + images.shift(code, 0)
                                val dy = p.y[j] - p.y[i] + images.shift(code, 1)
                                val dz = if (inPlane) 0.0 else p.z[j] - p.z[i] + images.shift(code, 2)
                                val d = sqrt(dx * dx + dy * dy + dz * dz)
                                if (d < 3) counts[(d * 2).toInt()]++
                            }
                        }
                    }
                }
            }
            val g = PairCorrelation(3.0, 6).of(state)
            for (bin in 0 until 6) {
                val a = bin / 2.0
                val b = a + 0.5
                val shell = if (inPlane) PI * (b * b - a * a) / 120 else 4.0 / 3 * PI * (b * b * b - a * a * a) / 960
                val room = if (images.shift(Images.code(1, 0, 0), 0) == 0.0) 1 - 2 / PI * (a + 0.25) / 10 else 1.0
                assertEquals(counts[bin] * 2 / (250 * 249.0 * shell * room), g[bin], 1e-9) {
                    "${boundary.javaClass.simpleName}, bin $bin"
                }
            }
        }
    }

    @Test
    fun `a row of planes has its Bragg peak, and a wave vector that leans with the images keeps it when they slide`() {
        // Planes of constant x, 20 in a box of 20: S is N at k = 2π, 0 below.
        val random = SeededRandom(5)
        val n = 4000
        val sheet = HillSheet(Box.centred(20.0, 30.0, 2.0), 1.0)
        val state =
            at(List(n) { (it % 20) - 9.5 }, List(n) { random.nextDouble(-15.0, 15.0) }, List(n) { 0.0 }, sheet, 0.3)
        val factor = StructureFactor(2 * PI * 1.01, 400)
        val s = factor.of(state)
        assertTrue(s[(2 * PI / (2 * PI * 1.01) * 400).toInt()] > 50)
    }

    @Test
    fun `the autocorrelation of a leaning density wave leans as it does, and goes on through the faces`() {
        val box = Box.centred(60.0, 60.0, 2.0)
        // Trailing crests: outward and backward, 30° from the orbit; density 1 + cos(k (x cos 30° + y sin 30°)),
        // made periodic by whole waves.
        val kx = 2 * PI / 60 * 4
        val ky = 2 * PI / 60 * 2
        val random = SeededRandom(8)
        val x = ArrayList<Double>()
        val y = ArrayList<Double>()
        while (x.size < 40_000) {
            val a = random.nextDouble(-30.0, 30.0)
            val b = random.nextDouble(-30.0, 30.0)
            if (random.nextDouble() * 2 < 1 + Math.cos(kx * a + ky * b)) {
                x += a
                y += b
            }
        }
        val map = SurfaceMap.of(at(x, y, x.map { 0.0 }, HillSheet(box, 1.0)), 1.5)
        val lag = 12
        val a = map.autocorrelation(lag, lag)
        // ⟨cos cos⟩ = ½ cos(k·l).
        for ((i, j) in listOf(0 to 3, 2 to 0, 3 to -6, -4 to 1)) {
            val expected = 0.5 * Math.cos(kx * i * map.dx + ky * j * map.dy)
            assertEquals(expected, a[(i + lag) * (2 * lag + 1) + j + lag], 0.05)
        }
    }

    @Test
    fun `nobody, one, and all in one place`() {
        val box = Periodic(Box.centred(10.0, 10.0, 10.0))
        assertTrue(PairCorrelation(2.0, 3).of(uniform(1, box)).all { it.isNaN() })
        assertTrue(StructureFactor(2.0, 3).of(uniform(0, box)).all { it.isNaN() })
        assertTrue(SurfaceMap.of(uniform(0, box), 1.0).autocorrelation(2, 2).all { it == 0.0 })
        val heap = at(List(5) { 0.0 }, List(5) { 0.0 }, List(5) { 0.0 }, box)
        assertTrue(PairCorrelation(2.0, 4).of(heap)[0] > 1)
    }
}
