package daphnis.analysis.correlation

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.sin

class SurfaceMapTest {
    private val box = Box.centred(60.0, 48.0, 2.0)

    /** Times at which images have slid by a part of a cell and more: 13.37 of 60 along x, or 48 along y. */
    private val sheared = listOf<Pair<BoundaryConditions, Double>>(
        LeesEdwards(box, 0.5) to 13.37 / (0.5 * 48),
        LeesEdwards(box, -0.5) to 13.37 / (0.5 * 48),
        HillSheet(box, 1.0) to 13.37 / (1.5 * 60),
    )

    /** Masses 1 + cos(k·r) on a fine lattice. */
    private fun wave(kx: Double, ky: Double, boundary: BoundaryConditions, time: Double): State {
        // Whole numbers of rows in a cell, wherever it begins.
        val n = 240
        val x = DoubleArray(n * n) { -30 + 60 * (it / n + 0.5) / n }
        val y = DoubleArray(n * n) { -24 + 48 * (it % n + 0.5) / n }
        val zero = DoubleArray(n * n)
        val mass = DoubleArray(n * n) { 1 + 1e-9 + cos(kx * x[it] + ky * y[it]) }
        return State(Population(x, y, zero, zero, zero, zero, DoubleArray(n * n) { 0.1 }, mass), boundary, time)
    }

    @Test
    fun `the autocorrelation of a wave continues through faces that slid by a part of a cell, along either axis`() {
        for ((boundary, time) in sheared) {
            val offset = boundary.shear!!.offset(time)
            // A wave that its images carry on: k·(L across, offset along) is a whole number of waves.
            val kx: Double
            val ky: Double
            if (boundary is HillSheet) {
                ky = 2 * PI / 48 * 2
                kx = (2 * PI * 3 - ky * offset) / 60
            } else {
                kx = 2 * PI / 60 * 2
                ky = (2 * PI * 3 - kx * offset) / 48
            }
            val map = SurfaceMap.of(wave(kx, ky, boundary, time), 2.0)
            val a = map.autocorrelation(14, 11)
            val inCells = sinc(kx) * sinc(kx) * sinc(ky) * sinc(ky)
            for (i in -14..14) {
                for (j in -11..11) {
                    val expected = 0.5 * inCells * cos(kx * i * map.dx + ky * j * map.dy)
                    assertEquals(expected, a[(i + 14) * 23 + j + 11], 0.01) { "${boundary.javaClass.simpleName} $i $j" }
                }
            }
        }
    }

    /** What cells of 2 leave of a wave. */
    private fun sinc(k: Double) = sin(k) / k

    @Test
    fun `the autocorrelation is that of cells filled from all images one by one`() {
        for ((boundary, time) in sheared + listOf<Pair<BoundaryConditions, Double>>(Periodic(box) to 0.4)) {
            val state = uniform(300, boundary).let { State(it.population, boundary, time) }
            val map = SurfaceMap.of(state, 6.0)
            val images = Images().also { it.prepare(boundary, time) }
            val cells = HashMap<Pair<Int, Int>, Double>()
            for (k in 0 until 300) {
                for (ix in -3..3) {
                    for (iy in -3..3) {
                        val code = Images.code(ix, iy, 0)
                        val i = floor((state.population.x[k] + images.shift(code, 0) + 30) / 6).toInt()
                        val j = floor((state.population.y[k] + images.shift(code, 1) + 24) / 6).toInt()
                        cells.merge(i to j, 1.0 / 36) { a, b -> a + b }
                    }
                }
            }
            val mean = 300.0 / (60 * 48)
            // Lags forward across the rows; those backward are their mirror by definition.
            val radial = boundary.shear?.normalAxis != 1
            val expected = DoubleArray(9 * 7)
            for (i in -4..4) {
                for (j in -3..3) {
                    val sign = if ((if (radial) i else j) < 0) -1 else 1
                    var sum = 0.0
                    for (p in 0 until 10) {
                        for (q in 0 until 8) {
                            val partner = cells[p + sign * i to q + sign * j] ?: 0.0
                            sum += ((cells[p to q] ?: 0.0) - mean) * (partner - mean)
                        }
                    }
                    expected[(i + 4) * 7 + j + 3] = sum / 80 / (mean * mean)
                }
            }
            assertArrayEquals(expected, map.autocorrelation(4, 3), 1e-12) { boundary.javaClass.simpleName }
        }
    }

    @Test
    fun `at an open face only cells that have a partner count`() {
        val open = HillSheet(box, 1.0, radiallyOpen = true)
        val kx = 2 * PI / 24
        // Two waves and a half: through the face the crest would meet a trough.
        val map = SurfaceMap.of(wave(kx, 0.0, open, 0.3), 2.0)
        val a = map.autocorrelation(12, 2)
        for (lag in listOf(0, 6, 12)) {
            fun excess(i: Int) = map.density[i * 24] / map.mean - 1
            assertEquals(
                (0 until 30 - lag).map {
                    excess(it) * excess(it + lag)
                }.average(),
                a[(12 + lag) * 5 + 2],
                1e-6,
            )
        }
        assertTrue(a[(12 + 12) * 5 + 2] > 0.3)
    }

    @Test
    fun `lags as long as the patch, and an empty patch`() {
        val map = SurfaceMap.of(uniform(0, Periodic(box)), 6.0)
        assertArrayEquals(DoubleArray(25), map.autocorrelation(2, 2))
        assertThrows(IllegalArgumentException::class.java) { map.autocorrelation(10, 2) }
    }

    @Test
    fun `particles on the lower faces are in the map, those on the upper ones and bodies are not`() {
        val p = populationOf(
            Sphere(x = -30.0, y = -24.0, m = 2.0),
            Sphere(x = 29.999, y = 23.999, m = 3.0),
            Sphere(x = 30.0, y = 0.0),
            Sphere(x = -30.001, y = 0.0),
            Sphere(x = 0.0, y = 24.0),
            Sphere(x = 0.0, y = -24.001),
            Sphere(x = 0.0, y = 0.0),
        )
        val state = State(p, Periodic(box), 0.0, firstBody = 6)
        val map = SurfaceMap.of(state, 6.0)
        assertEquals(listOf(10, 8, 6.0, 6.0), listOf(map.nx, map.ny, map.dx, map.dy))
        val expected = DoubleArray(80)
        expected[0] = 2.0 / 36
        expected[79] = 3.0 / 36
        assertArrayEquals(expected, map.density, 1e-15)
        assertEquals(5.0 / 36 / 80, map.mean, 1e-15)
        for ((lagX, lagY) in listOf(-1 to 2, 10 to 2, 2 to -1, 2 to 8)) {
            assertThrows(IllegalArgumentException::class.java) { map.autocorrelation(lagX, lagY) }
        }
        assertEquals(1, map.autocorrelation(0, 0).size)
        assertEquals(19 * 15, map.autocorrelation(9, 7).size)
        val fine = SurfaceMap.of(state, 0.01)
        assertEquals(listOf(128, 128), listOf(fine.nx, fine.ny))
        val coarse = SurfaceMap.of(state, 1000.0)
        assertEquals(listOf(1, 1), listOf(coarse.nx, coarse.ny))
        for (cell in listOf(0.0, -1.0)) {
            assertThrows(IllegalArgumentException::class.java) {
                SurfaceMap.of(state, cell)
            }
        }
    }
}
