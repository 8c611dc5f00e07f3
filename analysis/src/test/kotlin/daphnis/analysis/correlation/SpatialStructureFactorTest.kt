package daphnis.analysis.correlation

import daphnis.analysis.insitu.SizeGroups
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
import kotlin.math.sin
import kotlin.math.sqrt

/** The structure factor of wave vectors in space, its limit at 0, and partial ones. */
class SpatialStructureFactorTest {
    private val box = Box.centred(5.0, 6.0, 7.0)

    /** S by the definition, of all wave vectors that fit, both of k and −k. */
    private fun defined(state: State, largest: Double, bins: Int): DoubleArray {
        val sum = DoubleArray(bins)
        val count = IntArray(bins)
        val shear = state.boundary.shear
        val p = state.population
        for (l in -20..20) {
            for (m in -20..20) {
                for (n in -20..20) {
                    val k = doubleArrayOf(
                        l * 2 * PI / 5,
                        m * 2 * PI / 6,
                        if (state.boundary.hasImages(2)) {
                            n * 2 * PI /
                                7
                        } else {
                            0.0
                        },
                    )
                    if (!state.boundary.hasImages(2) && n != 0) continue
                    if (shear != null) {
                        k[shear.normalAxis] -=
                            k[shear.slideAxis] * shear.offset(state.time) / box.length(shear.normalAxis)
                    }
                    val bin = (sqrt(k.sumOf { it * it }) / largest * bins).toInt()
                    if (l == 0 && m == 0 && n == 0 || bin >= bins) continue
                    fun phase(i: Int) = k[0] * p.x[i] + k[1] * p.y[i] + k[2] * p.z[i]
                    val c = (0 until p.size).sumOf { cos(phase(it)) }
                    val s = (0 until p.size).sumOf { sin(phase(it)) }
                    sum[bin] += (c * c + s * s) / p.size
                    count[bin]++
                }
            }
        }
        return DoubleArray(bins) { if (count[it] == 0) Double.NaN else sum[it] / count[it] }
    }

    @Test
    fun `it is as it is defined, with leaning wave vectors, and in the plane where nothing repeats above`() {
        for (boundary in listOf<BoundaryConditions>(Periodic(box), LeesEdwards(box, 0.9), HillSheet(box, 1.0))) {
            for (time in listOf(0.0, 0.7, 1.1)) {
                val state = State(uniform(37, boundary).population, boundary, time)
                assertArrayEquals(defined(state, 6.0, 9), SpatialStructureFactor(6.0, 9).of(state), 1e-9) {
                    "${boundary.javaClass.simpleName} at $time"
                }
            }
        }
    }

    @Test
    fun `it is the same when some particles are replaced by their images`() {
        for (boundary in listOf<BoundaryConditions>(Periodic(box), LeesEdwards(box, -0.9))) {
            val p = uniform(60, boundary).population
            val images = Images().also { it.prepare(boundary, 0.8) }
            val moved = Population(p.x.copyOf(), p.y.copyOf(), p.z.copyOf(), p.vx, p.vy, p.vz, p.radius, p.mass)
            for (k in 0 until 60 step 3) {
                val code = Images.code(k % 2, 1 - k % 2 - k % 5, k % 3 - 1)
                moved.x[k] += images.shift(code, 0)
                moved.y[k] += images.shift(code, 1)
                moved.z[k] += images.shift(code, 2)
            }
            val factor = SpatialStructureFactor(8.0, 20)
            assertArrayEquals(factor.of(State(p, boundary, 0.8)), factor.of(State(moved, boundary, 0.8)), 1e-9)
        }
    }

    @Test
    fun `partial ones come to the whole`() {
        val p = uniform(90, Periodic(box)).population
        val radius = DoubleArray(90) { if (it % 3 == 0) 0.2 else 0.1 }
        val state = State(Population(p.x, p.y, p.z, p.vx, p.vy, p.vz, radius, p.mass), Periodic(box), 0.0)
        val factor = SpatialStructureFactor(7.0, 6, SizeGroups.of(state)!!)
        val found = factor.of(state)
        val whole = SpatialStructureFactor(7.0, 6).of(state)
        for (bin in 0 until 6) {
            assertEquals(whole[bin], found[bin], 1e-9)
            fun s(a: Int, b: Int) = found[factor.first(a, b) + bin]
            assertEquals(whole[bin], 2.0 / 3 * s(0, 0) + 1.0 / 3 * s(1, 1) + 2 * sqrt(2.0) / 3 * s(1, 0), 1e-9)
        }
        assertThrows(IllegalArgumentException::class.java) { factor.first(0, 2) }
    }

    @Test
    fun `of more wave vectors than can be summed some of each bin are taken, and the mean is the same`() {
        // 6000 particles by 12 bins: 83 vectors in each, of up to 1400.
        val state = uniform(6000, Periodic(box))
        val found = SpatialStructureFactor(12.0, 12).of(state)
        for (bin in 3 until 12) assertEquals(1.0, found[bin], 5 / sqrt(83.0)) { "bin $bin" }
        assertTrue(found.drop(3).average().let { it in 0.8..1.2 })
        val vectors = WaveVectors(state.boundary, 0.0, 12.0, 12, 83)
        assertEquals(83, vectors.shell.count { it == 11 })
        // Spread over directions: none of the three axes has more than its share.
        for (axis in 0..2) {
            val share = (0 until vectors.size).filter { vectors.shell[it] == 11 }.sumOf {
                val c = vectors.component(axis, it) / vectors.length(it)
                c * c
            } / 83
            assertEquals(1.0 / 3, share, 0.06)
        }
    }

    @Test
    fun `bodies do not count, and there must be a bin and a largest`() {
        val p = uniform(3, Periodic(box)).population
        val factor = SpatialStructureFactor(2.0, 4)
        val one = factor.of(State(p, Periodic(box), 0.0, firstBody = 1))
        assertTrue(one[0].isNaN() && one.drop(1).all { Math.abs(it - 1) < 1e-12 })
        assertTrue(factor.of(State(p, Periodic(box), 0.0, firstBody = 0)).all { it.isNaN() })
        assertTrue(factor.of(State(p, BoundaryConditions.open(), 0.0)).all { it.isNaN() })
        // Waves of π/6 along an axis, along two and along three: half of 6, 12 and 8.
        val cube = State(p, Periodic(Box.centred(12.0, 12.0, 12.0)), 0.0)
        val mean = PI / 6 * (3 + 6 * sqrt(2.0) + 4 * sqrt(3.0)) / 13
        assertArrayEquals(doubleArrayOf(0.25, mean), SpatialStructureFactor(1.0, 2).waveNumbers(cube), 1e-12)
        assertThrows(IllegalArgumentException::class.java) { SpatialStructureFactor(Double.NaN, 4) }
        assertThrows(IllegalArgumentException::class.java) { SpatialStructureFactor(2.0, 0) }
    }

    @Test
    fun `the limit at 0 is 1 of random particles, on average, and NaN of too few waves`() {
        val limit = LongWaveLimit(4.0)
        val all = List(400) { limit.of(uniform(50, Periodic(box), it.toLong() + 1))[0] }
        val error = sqrt(all.sumOf { (it - 1) * (it - 1) }) / all.size
        assertEquals(1.0, all.average(), 4 * error) { "± $error" }
        assertTrue(LongWaveLimit(1.5).of(uniform(50, Periodic(box)))[0].isNaN())
        assertTrue(limit.of(State(uniform(3, Periodic(box)).population, Periodic(box), 0.0, firstBody = 0))[0].isNaN())
        assertThrows(IllegalArgumentException::class.java) { LongWaveLimit(0.0) }
    }
}
