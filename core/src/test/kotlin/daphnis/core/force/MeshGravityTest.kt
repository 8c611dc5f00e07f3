package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.permuted
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

class MeshGravityTest {
    private val sheet = HillSheet(Box.centred(50.0, 60.0, 8.0), 1.0)

    private fun patch(count: Int, seed: Long = 3, height: Double = 3.0): Population {
        val random = SeededRandom(seed)
        fun uniform(half: Double) = DoubleArray(count) { random.nextDouble(-half, half) }
        return Population(
            uniform(25.0),
            uniform(30.0),
            uniform(height),
            uniform(1.0),
            uniform(1.0),
            uniform(1.0),
            DoubleArray(count) { 0.1 },
            DoubleArray(count) { 0.5 + random.nextDouble() },
        )
    }

    /** a x y z, Σ a_y Δx of the spheres [of], over all images within so many boxes, faded as a tree's range is. */
    private fun direct(
        p: Population,
        boundary: BoundaryConditions,
        time: Double,
        images: Int,
        of: IntRange,
        softening: Double = 0.0,
    ): Array<DoubleArray> {
        val shifts = Images().also { it.prepare(boundary, time) }
        val range = (images + 0.5) * minOf(boundary.box.length(0), boundary.box.length(1))
        val a = Array(4) { DoubleArray(of.count()) }
        for (ix in -images - 1..images + 1) {
            val middle = -Math.rint(ix * shifts.shearOffset / boundary.box.length(1)).toInt()
            for (iy in middle - images - 1..middle + images + 1) {
                val code = Images.code(ix, iy, 0)
                val sx = shifts.shift(code, 0)
                val sy = shifts.shift(code, 1)
                for (i in of) {
                    for (j in 0 until p.size) {
                        val dx = p.x[j] - p.x[i] + sx
                        val dy = p.y[j] - p.y[i] + sy
                        val dz = p.z[j] - p.z[i]
                        val rho2 = dx * dx + dy * dy
                        if (rho2 >= range * range || i == j && code == 0) continue
                        val t = minOf(1.0, (range * range - rho2) / (0.75 * range * range))
                        val d2 = rho2 + dz * dz + softening * softening
                        val f = p.mass[j] / (d2 * sqrt(d2)) * t * t * (3 - 2 * t)
                        a[0][i - of.first] += f * dx
                        a[1][i - of.first] += f * dy
                        a[2][i - of.first] += f * dz
                        a[3][i - of.first] += f * dy * dx
                    }
                }
            }
        }
        return a
    }

    private fun rmsError(found: Array<DoubleArray>, expected: Array<DoubleArray>, axes: IntRange = 0..2): Double {
        var error = 0.0
        var size = 0.0
        for (axis in axes) {
            for (k in expected[axis].indices) {
                error += (found[axis][k] - expected[axis][k]).let { it * it }
                size += expected[axis][k] * expected[axis][k]
            }
        }
        return sqrt(error / size)
    }

    @Test
    fun `the force is that of all images, at rest and slid, to 4 in a thousand`() {
        for ((count, time) in listOf(60 to 0.0, 60 to 0.31, 400 to 1.234)) {
            val p = patch(count)
            val expected = direct(p, sheet, time, 16, 0 until minOf(count, 60))
            val found = MeshGravity(sheet, 1.0).accelerations(p, time)
            val error = rmsError(found, expected)
            assertTrue(error < 4e-3) { "$count spheres at $time: rms error $error" }
        }
    }

    @Test
    fun `softening, a fine mesh, and a box that does not slide`() {
        val p = patch(60)
        val soft = direct(p, sheet, 0.7, 16, 0 until 60, 0.3)
        val softError = rmsError(MeshGravity(sheet, 1.0, 0.3).accelerations(p, 0.7), soft)
        val fine = rmsError(MeshGravity(sheet, 1.0, 0.3, 1.4).accelerations(p, 0.7), soft)
        val still = Periodic(Box.centred(50.0, 60.0, 8.0), periodicZ = false)
        val rest = rmsError(MeshGravity(still, 1.0).accelerations(p, 0.7), direct(p, still, 0.7, 16, 0 until 60))
        assertTrue(softError < 3e-3) { "$softError" }
        assertTrue(fine < 5e-3) { "$fine" }
        assertTrue(rest < 3e-3) { "$rest" }
    }

    @Test
    fun `the same bits for any order of spheres and number of threads, and when the last force is not kept`() {
        val start = patch(3000)
        fun run(p: Population, threads: Int, keep: Boolean): String {
            FixedPool(threads).use { pool ->
                var gravity = MeshGravity(sheet, 0.01)
                val frame = HillFrame(1.0)
                val loop = ParallelLoop(pool, LoopStrategy.DYNAMIC)
                repeat(5) { step ->
                    if (!keep) gravity = MeshGravity(sheet, 0.01)
                    gravity.useLoop(loop)
                    gravity.beforeDrift(p, step * 0.1, 0.1)
                    frame.beforeDrift(p, step * 0.1, 0.1)
                    for (k in 0 until p.size) {
                        p.x[k] += p.vx[k] * 0.1
                        p.y[k] += p.vy[k] * 0.1
                        p.z[k] += p.vz[k] * 0.1
                    }
                    sheet.endStep(p, (step + 1) * 0.1)
                    frame.afterDrift(p, (step + 1) * 0.1, 0.1)
                    gravity.afterDrift(p, (step + 1) * 0.1, 0.1)
                }
                assertTrue(gravity.stressXY(p, 0.5).isFinite())
            }
            return stateDigest(p)
        }
        val expected = run(start.copy(), 1, true)
        assertEquals(expected, run(start.permuted(9), 1, true))
        assertEquals(expected, run(start.copy(), 3, true))
        assertEquals(expected, run(start.copy(), 2, false))
    }

    @Test
    fun `the stress is the sum over pairs, images included`() {
        val p = patch(150)
        for (time in listOf(0.0, 0.31)) {
            val a = direct(p, sheet, time, 12, 0 until p.size)
            val expected = (0 until p.size).sumOf { -0.5 * 2.0 * p.mass[it] * a[3][it] }
            val scale = (0 until p.size).sumOf { abs(p.mass[it] * a[3][it]) }
            val found = MeshGravity(sheet, 2.0).stressXY(p, time)
            assertEquals(expected, found, 5e-3 * scale)
        }
    }

    @Test
    fun `the slope of the energy is the force`() {
        val p = patch(80)
        val gravity = MeshGravity(sheet, 0.7)
        val h = 1e-4
        for (axis in 0..2) {
            for (k in listOf(3, 17, 40)) {
                val force = p.mass[k] * gravity.accelerations(p, 0.31)[axis][k]
                fun energy(by: Double): Double {
                    val q = p.copy()
                    arrayOf(q.x, q.y, q.z)[axis][k] += by
                    return gravity.potentialEnergy(q, sheet, 0.31)
                }
                val slope = (energy(h) - energy(-h)) / (2 * h)
            }
        }
    }

    @Test
    fun `a uniform sheet pulls nothing along itself, and towards its middle plane`() {
        // 40 x 48 points fill the sheet 1.25 apart, at a height of 2 and at −2.
        val n = 40 * 48
        val p = Population(
            DoubleArray(n) { 1.25 * (it / 48 + 0.5) - 25 },
            DoubleArray(n) { 1.25 * (it % 48 + 0.5) - 30 },
            DoubleArray(n) { if ((it + it / 48) % 2 == 0) 2.0 else -2.0 },
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n) { 0.1 },
            DoubleArray(n) { 1.0 },
        )
        val surfaceDensity = 1 / (1.25 * 1.25)
        for (time in listOf(0.0, 0.123, 0.6)) {
            val a = MeshGravity(sheet, 1.0, 0.0, 3.0).accelerations(p, time)
            val down = (0 until n).sumOf { -a[2][it] * p.z[it] / 2.0 } / n / (PI * surfaceDensity)
            // The other half of the mass is on the other side: 2πG Σ/2.
            assertEquals(1.0, down, 6e-3)
            // A lattice that has slid is none where its images meet.
            if (time > 0) continue
            val most = (0 until n).maxOf { maxOf(abs(a[0][it]), abs(a[1][it])) } / surfaceDensity
            assertTrue(most < 1e-3) { "$most G times the surface density" }
        }
    }

    @Test
    fun `nobody, one, all in one place, and few in a box of few points`() {
        fun heap(n: Int) = Population(
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n) { 1.0 },
            DoubleArray(n) { 1.0 },
        )
        MeshGravity(sheet, 1.0).kick(heap(0), 0.0, 1.0)
        for (n in listOf(1, 40)) {
            val p = heap(n)
            MeshGravity(sheet, 1.0).kick(p, 0.0, 1.0)
            // A lattice of images has no pull on its points.
            assertTrue(p.vx.all { abs(it) < 1e-4 * n } && p.vz.all { abs(it) < 1e-4 * n }) { "${p.vx[0]} ${p.vz[0]}" }
        }
    }

    @Test
    fun `a mesh over a box which it does not fit is refused`() {
        val box = Box.centred(20.0, 20.0, 20.0)
        for (boundary in listOf(Open, Periodic(box), LeesEdwards(box, 1.0), HillSheet(box, 1.0, radiallyOpen = true))) {
            assertThrows(IllegalArgumentException::class.java) { MeshGravity(boundary, 1.0) }
        }
        for (bad in listOf(-1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { MeshGravity(sheet, bad) }
            assertThrows(IllegalArgumentException::class.java) { MeshGravity(sheet, 1.0, bad) }
            assertThrows(IllegalArgumentException::class.java) { MeshGravity(sheet, 1.0, 0.0, bad) }
        }
    }
}
