package daphnis.analysis.correlation

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin
import kotlin.math.sqrt

class StructureFactorTest {
    private val box = Box.centred(10.0, 12.0, 3.0)
    private val boundaries =
        listOf<BoundaryConditions>(Periodic(box), HillSheet(box, 1.0), LeesEdwards(box, 0.9), LeesEdwards(box, -0.9))

    @Test
    fun `it is the same when some particles are replaced by their images, along whichever axis these have slid`() {
        for (boundary in boundaries) {
            for (time in listOf(0.0, 0.37, 0.8)) {
                val p = uniform(60, boundary).population
                val images = Images().also { it.prepare(boundary, time) }
                val moved = Population(p.x.copyOf(), p.y.copyOf(), p.z.copyOf(), p.vx, p.vy, p.vz, p.radius, p.mass)
                for (k in 0 until 60 step 3) {
                    val code = Images.code(k % 2, 1 - k % 2 - k % 5, 0)
                    moved.x[k] += images.shift(code, 0)
                    moved.y[k] += images.shift(code, 1)
                }
                val factor = StructureFactor(6.0, 40)
                assertArrayEquals(factor.of(State(p, boundary, time)), factor.of(State(moved, boundary, time)), 1e-9) {
                    "${boundary.javaClass.simpleName} at $time"
                }
            }
        }
    }

    @Test
    fun `a wave across both axes has its peak where it is, leaning with the images`() {
        for (boundary in boundaries) {
            val time = 0.37
            val offset = boundary.shear?.offset(time) ?: 0.0
            var kx = 2 * PI / 10 * 3
            var ky = 2 * PI / 12 * 4
            if (boundary.shear?.normalAxis == 0) kx -= ky * offset / 10
            if (boundary.shear?.normalAxis == 1) ky -= kx * offset / 12
            // Rows of particles on the crests k·r = 2πn.
            val n = 4000
            val base = uniform(n, boundary).population
            val x = DoubleArray(n)
            val y = DoubleArray(n)
            val k2 = kx * kx + ky * ky
            for (i in 0 until n) {
                val phase = kx * base.x[i] + ky * base.y[i]
                val away = (phase - 2 * PI * Math.rint(phase / (2 * PI))) / k2
                x[i] = base.x[i] - away * kx
                y[i] = base.y[i] - away * ky
            }
            val state =
                State(Population(x, y, base.z, base.vx, base.vy, base.vz, base.radius, base.mass), boundary, time)
            val bins = 500
            val s = StructureFactor(4.0, bins).of(state)
            val bin = (sqrt(k2) / 4.0 * bins).toInt()
            // S is N there; where nothing leans the mirrored wave vector is in the same bin and has nothing.
            assertTrue(s[bin] > n / 2.0) { "${boundary.javaClass.simpleName}: ${s[bin]}" }
        }
    }

    @Test
    fun `every wave vector that fits counts once, on both sides, when images have slid far`() {
        for (boundary in boundaries) {
            val time =
                boundary.shear?.let { 0.93 * (if (it.normalAxis == 0) 12.0 else 10.0) / Math.abs(it.velocity) } ?: 0.0
            val state = uniform(40, boundary).let { State(it.population, boundary, time) }
            val offset = boundary.shear?.offset(time) ?: 0.0
            val sum = DoubleArray(8)
            val count = IntArray(8)
            for (l in -60..60) {
                for (m in -60..60) {
                    var kx = l * 2 * PI / 10
                    var ky = m * 2 * PI / 12
                    if (boundary.shear?.normalAxis == 0) kx -= ky * offset / 10
                    if (boundary.shear?.normalAxis == 1) ky -= kx * offset / 12
                    val bin = (sqrt(kx * kx + ky * ky) / 8.0 * 8).toInt()
                    if (l == 0 && m == 0 || bin >= 8) continue
                    val p = state.population
                    val c = (0 until 40).sumOf { cos(kx * p.x[it] + ky * p.y[it]) }
                    val s = (0 until 40).sumOf { sin(kx * p.x[it] + ky * p.y[it]) }
                    sum[bin] += (c * c + s * s) / 40
                    count[bin]++
                }
            }
            val expected = DoubleArray(8) { if (count[it] == 0) Double.NaN else sum[it] / count[it] }
            assertArrayEquals(expected, StructureFactor(8.0, 8).of(state), 1e-9) { boundary.javaClass.simpleName }
        }
    }

    @Test
    fun `a bin stands at the mean of the wave numbers in it, that of one wave at its own`() {
        // 10 wide and 12 long: the longest waves have π/5 and π/6.
        val state = uniform(3, Periodic(box))
        val found = StructureFactor(0.8, 8).waveNumbers(state)
        for ((bin, k) in listOf(0 to 0.05, 4 to 0.45, 5 to PI / 6, 6 to PI / 5, 7 to 0.75)) {
            assertEquals(k, found[bin], 1e-12)
        }
        // Both, with those across.
        val mean = (PI / 6 + PI / 5 + 2 * hypot(PI / 6, PI / 5)) / 4
        assertEquals(mean, StructureFactor(0.82, 1).waveNumbers(state)[0], 1e-12)
    }

    @Test
    fun `one particle has 1 for each wave vector, bodies do not count, and there is a bin and a largest`() {
        val p = uniform(3, Periodic(box)).population
        val factor = StructureFactor(2.0, 4)
        // The longest wave is of 12, so that no wave vector is below π/6; beyond 1.5 there are many.
        for (bodies in 1..3) {
            val s = factor.of(State(p, Periodic(box), 0.0, firstBody = bodies))
            assertTrue(s[0].isNaN())
            if (bodies == 1) for (bin in 1..3) assertTrue(Math.abs(s[bin] - 1) < 1e-12)
        }
        assertTrue(factor.of(State(p, Periodic(box), 0.0, firstBody = 0)).all { it.isNaN() })
        assertEquals(listOf(2.0, 4), listOf(factor.largest, factor.bins))
        assertThrows(IllegalArgumentException::class.java) { StructureFactor(0.0, 4) }
        assertThrows(IllegalArgumentException::class.java) { StructureFactor(2.0, 0) }
        assertEquals(1, StructureFactor(2.0, 1).of(State(p, Periodic(box), 0.0)).size)
    }

    @Test
    fun `it is the sum over particles as it is defined, to twelve digits`() {
        val boundary = Periodic(Box.centred(40.0, 30.0, 3.0))
        val state = uniform(200, boundary)
        val p = state.population
        val largest = 12.0
        val bins = 30
        val sum = DoubleArray(bins)
        val count = IntArray(bins)
        for (m in 0..58) {
            for (l in -77..77) {
                if (m == 0 && l <= 0) continue
                val kx = l * 2 * PI / 40
                val ky = m * 2 * PI / 30
                val bin = (sqrt(kx * kx + ky * ky) / largest * bins).toInt()
                if (bin >= bins) continue
                val c = (0 until 200).sumOf { cos(kx * p.x[it] + ky * p.y[it]) }
                val s = (0 until 200).sumOf { sin(kx * p.x[it] + ky * p.y[it]) }
                sum[bin] += (c * c + s * s) / 200
                count[bin]++
            }
        }
        val found = StructureFactor(largest, bins).of(state)
        for (bin in 0 until bins) assertEquals(sum[bin] / count[bin], found[bin], 1e-12 * found[bin]) { "bin $bin" }
    }
}
