package daphnis.core.force

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillFrame
import daphnis.core.hill.HillSheet
import daphnis.core.hill.Satellite
import daphnis.core.hill.SatelliteSurface
import daphnis.core.initial.SeededRandom
import daphnis.core.input.InputException
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.permuted
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class GravityTest {
    private val sheet = HillSheet(Box.centred(50.0, 60.0, 8.0), 1.0)

    private fun patch(count: Int, seed: Long = 3): Population {
        val random = SeededRandom(seed)
        fun uniform(half: Double) = DoubleArray(count) { random.nextDouble(-half, half) }
        val p = Population(
            uniform(25.0),
            uniform(30.0),
            uniform(3.0),
            uniform(1.0),
            uniform(1.0),
            uniform(1.0),
            DoubleArray(count) { 0.1 },
            DoubleArray(count) {
                0.5 +
                    random.nextDouble()
            },
        )
        return p
    }

    /**
     * Each with each and every image, plainly, faded by the distance in the plane as `docs/physics.md` says; nothing is
     * cut when nothing repeats.
     */
    private fun direct(
        p: Population,
        boundary: BoundaryConditions,
        time: Double,
        images: Int,
        softening: Double,
    ): Array<DoubleArray> {
        val shifts = Images().also { it.prepare(boundary, time) }
        val a = Array(3) { DoubleArray(p.size) }
        val isCut = boundary !== Open
        val range = if (isCut) (images + 0.5) * minOf(boundary.box.length(0), boundary.box.length(1)) else 0.0
        val far = if (isCut) images + 3 else 0
        for (i in 0 until p.size) {
            for (j in 0 until p.size) {
                for (ix in -far..far) {
                    for (iy in -2 * far..2 * far) {
                        val code = Images.code(ix, iy, 0)
                        if (i == j && code == 0) continue
                        val dx = p.x[j] - p.x[i] + shifts.shift(code, 0)
                        val dy = p.y[j] - p.y[i] + shifts.shift(code, 1)
                        val dz = p.z[j] - p.z[i]
                        val d2 = dx * dx + dy * dy + dz * dz + softening * softening
                        val f = p.mass[j] / (d2 * sqrt(d2)) * if (isCut) faded(sqrt(dx * dx + dy * dy), range) else 1.0
                        a[0][i] += f * dx
                        a[1][i] += f * dy
                        a[2][i] += f * dz
                    }
                }
            }
        }
        return a
    }

    private fun faded(distance: Double, range: Double): Double {
        val inner = range / 2
        if (distance <= inner) return 1.0
        if (distance >= range) return 0.0
        val t = (range * range - distance * distance) / (range * range - inner * inner)
        return t * t * (3 - 2 * t)
    }

    private fun rmsError(found: Array<DoubleArray>, expected: Array<DoubleArray>): Double {
        var error = 0.0
        var size = 0.0
        for (axis in 0..2) {
            for (k in expected[axis].indices) {
                error += (found[axis][k] - expected[axis][k]).let { it * it }
                size += expected[axis][k] * expected[axis][k]
            }
        }
        return sqrt(error / size)
    }

    @Test
    fun `the pull on a body does not depend on the order of the arrays`() {
        val box = Periodic(Box.centred(20.0, 20.0, 20.0))
        val p = randomSpheres(500, box, 5, 1.0) { 0.3 }
        val digests = (1L..5L).map { seed ->
            val q = p.permuted(seed)
            BodyGravity(intArrayOf(0, 7), box, 1.0).kick(q, 0.0, 0.1)
            stateDigest(q)
        }
        assertEquals(1, digests.toSet().size)
    }

    @Test
    fun `the tree gives the direct sum over sliding images with all nodes opened, nearly so with an angle`() {
        val p = patch(400)
        val time = 1.234
        for (softening in listOf(0.0, 0.5)) {
            val expected = direct(p, sheet, time, 1, softening)
            assertTrue(rmsError(SelfGravity(sheet, 1.0, 0.0, softening, 1).accelerations(p, time), expected) < 1e-12)
            val half = rmsError(SelfGravity(sheet, 1.0, 0.5, softening, 1).accelerations(p, time), expected)
            val most = rmsError(SelfGravity(sheet, 1.0, 1.0, softening, 1).accelerations(p, time), expected)
            assertTrue(half < 8e-3) { "error at opening angle 0.5: $half" }
            assertTrue(most < 8e-2 && most > half) { "error at opening angle 1: $most" }
        }
        val p2 = patch(50)
        assertTrue(
            rmsError(
                SelfGravity(sheet, 2.0, 0.0, 0.0, 2).accelerations(p2, time),
                direct(p2, sheet, time, 2, 0.0).map { a ->
                    a.map { it * 2 }.toDoubleArray()
                }.toTypedArray(),
            ) <
                1e-12,
        )
    }

    @Test
    fun `the same bits for any order of spheres and number of threads, and when the last force is not kept`() {
        val start = patch(3000)
        fun run(p: Population, threads: Int, keep: Boolean): String {
            FixedPool(threads).use { pool ->
                var gravity = SelfGravity(sheet, 0.01, 0.6)
                val frame = HillFrame(1.0)
                val loop = ParallelLoop(pool, LoopStrategy.DYNAMIC)
                repeat(5) { step ->
                    if (!keep) gravity = SelfGravity(sheet, 0.01, 0.6)
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
            }
            return stateDigest(p)
        }
        val expected = run(start.copy(), 1, true)
        assertEquals(expected, run(start.permuted(9), 1, true))
        assertEquals(expected, run(start.copy(), 3, true))
        assertEquals(expected, run(start.copy(), 2, false))
    }

    @Test
    fun `the stress of gravity is the sum over pairs`() {
        val p = patch(40)
        val gravity = SelfGravity(Open, 3.0, 0.0)
        gravity.accelerations(p, 0.0)
        var expected = 0.0
        for (i in 0 until p.size) {
            for (j in i + 1 until p.size) {
                val dx = p.x[j] - p.x[i]
                val dy = p.y[j] - p.y[i]
                val dz = p.z[j] - p.z[i]
                val d = sqrt(dx * dx + dy * dy + dz * dz)
                expected -= 3.0 * p.mass[i] * p.mass[j] * dy * dx / (d * d * d)
            }
        }
        assertEquals(expected, gravity.stressXY(p, 0.0), 1e-10 * Math.abs(expected))
    }

    @Test
    fun `a sphere alone in its leaf does not pull itself, wherever roundings put the centre of its mass`() {
        // Far apart, in pairs of one and a crowd, so that many leaves hold a single sphere; masses whose product and
        // quotient round.
        val random = SeededRandom(12)
        val n = 600
        fun place() = DoubleArray(n) {
            if (it % 2 == 0) {
                random.nextDouble(-400.0, 400.0)
            } else {
                390 + random.nextDouble()
            }
        }
        val p =
            Population(
                place(),
                place(),
                place(),
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n),
                DoubleArray(n) {
                    0.1
                },
                DoubleArray(n) {
                    0.1 +
                        random.nextDouble()
                },
            )
        val expected = direct(p, Open, 0.0, 0, 0.0)
        assertTrue(rmsError(SelfGravity(Open, 1.0, 0.7).accelerations(p, 0.0), expected) < 2e-2)
    }

    /** 40 x 48 points of mass 1 that fill the sheet evenly, 1.25 apart. */
    private fun uniformSheet(): Population {
        val n = 40 * 48
        return Population(
            DoubleArray(n) { 1.25 * (it / 48 + 0.5) - 25 },
            DoubleArray(n) { 1.25 * (it % 48 + 0.5) - 30 },
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n),
            DoubleArray(n) { 0.1 },
            DoubleArray(n) { 1.0 },
        )
    }

    @Tag("thorough")
    @Test
    fun `a uniform sheet pulls no particle along itself, anywhere in the patch, however its images have slid`() {
        val lattice = uniformSheet()
        // Smeared over twice their distance, points stand for a sheet: a lattice broken by the slide pulls with some
        // 1e-5 of G times the density.
        val softening = 2.5
        val surfaceDensity = 1 / (1.25 * 1.25)
        for ((images, theta, bound) in listOf(
            Triple(1, 0.0, 1e-4),
            Triple(0, 0.5, 0.1),
            Triple(1, 0.5, 0.07),
            Triple(2, 0.5, 0.07),
        )) {
            for (time in if (theta == 0.0) listOf(0.123) else listOf(0.0, 0.123, 0.4, 0.6)) {
                val a = SelfGravity(sheet, 1.0, theta, softening, images).accelerations(lattice, time)
                val most =
                    (0 until lattice.size).maxOf { sqrt(a[0][it] * a[0][it] + a[1][it] * a[1][it]) } / surfaceDensity
                assertTrue(most < bound) {
                    "opening angle $theta, $images images, time $time: $most G times the surface density"
                }
                assertTrue(inwardAtEdges(lattice, a[0]) < bound / 2 * surfaceDensity) {
                    "opening angle $theta, $images images, time $time"
                }
            }
        }
    }

    /** Mean pull towards the centre on the outermost columns. */
    private fun inwardAtEdges(p: Population, ax: DoubleArray): Double {
        val edge = (0 until p.size).filter { Math.abs(p.x[it]) > 24 }
        return Math.abs(edge.sumOf { -Math.signum(p.x[it]) * ax[it] }) / edge.size
    }

    @Test
    fun `with everything opened momentum stands to round-off, pairs across the cut and sliding images included`() {
        val p = patch(300)
        for (images in 0..2) {
            val a = SelfGravity(sheet, 1.0, 0.0, 0.0, images).accelerations(p, 1.234)
            for (axis in 0..2) {
                val size = (0 until p.size).sumOf { p.mass[it] * Math.abs(a[axis][it]) }
                assertEquals(0.0, momentum(p, a[axis]), 1e-13 * size) { "axis $axis, $images images" }
            }
        }
    }

    @Test
    fun `along an axis that does not repeat nothing is cut`() {
        // A ringlet: periodic along the orbit alone, far wider than the cut is long.
        val ringlet = HillSheet(Box.centred(400.0, 10.0, 8.0), 1.0, radiallyOpen = true)
        val p = populationOf(Sphere(x = -150.0), Sphere(x = 150.0))
        val gravity = SelfGravity(ringlet, 1.0, 0.0, 0.0, 1)
        assertEquals(15.0, gravity.range)
        // The pair itself and its two nearest images, which are 10 away along the orbit and weighed by that alone.
        val next = sqrt(300.0 * 300.0 + 100.0)
        assertEquals(
            1 / 9e4 + 2 * faded(10.0, 15.0) * 300 / (next * next * next),
            gravity.accelerations(p, 0.0)[0][0],
            1e-16,
        )
        assertEquals(Double.POSITIVE_INFINITY, SelfGravity(Open, 1.0).range)
    }

    @Test
    fun `as many images as the force can have a scenario can have, and no more`() {
        val most = SelfGravity.MOST_IMAGES
        val pair = populationOf(Sphere(x = 24.0, y = -29.0), Sphere(x = -20.0, y = 29.0, m = 2.0))
        val expected = direct(pair, sheet, 0.79, most, 0.0)
        assertTrue(rmsError(SelfGravity(sheet, 1.0, 0.0, 0.0, most).accelerations(pair, 0.79), expected) < 1e-9)
        assertThrows(IllegalArgumentException::class.java) { SelfGravity(sheet, 1.0, images = most + 1) }
        fun scenario(images: Int) = BuiltIn.scenario(
            "self-gravity-wakes",
            listOf("box.lengths=[20,20,16]", "forces=[{\"type\":\"self-gravity\",\"images\":$images}]"),
        )
        ScenarioSetup.of(scenario(most), "wakes")
        val refused = assertThrows(InputException::class.java) { ScenarioSetup.of(scenario(most + 1), "wakes") }
        assertTrue("forces[0].images" in refused.message.orEmpty() && "0..$most" in refused.message.orEmpty()) {
            refused.message
        }
    }

    @Test
    fun `a uniform sheet carries no stress, however its images have slid`() {
        val lattice = uniformSheet()
        val n = lattice.size
        for (time in listOf(0.0, 0.2, 0.4, 0.6)) {
            val gravity = SelfGravity(sheet, 1.0, 0.3, 0.0, 2)
            val a = gravity.accelerations(lattice, time)
            // Of the order of what a pair of neighbours carries, by mass and distance.
            val scale = n / 1.25
            assertTrue(Math.abs(gravity.stressXY(lattice, time)) < 0.2 * scale) {
                "time $time: ${gravity.stressXY(lattice, time)}"
            }
            assertTrue(a[2].all { it == 0.0 })
        }
    }

    @Test
    fun `nobody, one, and all in one place`() {
        SelfGravity(sheet, 1.0).kick(populationOf(), 0.0, 1.0)
        val one = populationOf(Sphere(vx = 1.0))
        SelfGravity(Open, 1.0).kick(one, 0.0, 1.0)
        assertEquals(1.0, one.vx[0])
        val heap =
            Population(
                DoubleArray(40),
                DoubleArray(40),
                DoubleArray(40),
                DoubleArray(40),
                DoubleArray(40),
                DoubleArray(40),
                DoubleArray(40) {
                    1.0
                },
                DoubleArray(40) { 1.0 },
            )
        SelfGravity(Open, 1.0).kick(heap, 0.0, 1.0)
        assertTrue(heap.vx.all { it == 0.0 })
    }

    @Test
    fun `a body and the others pull one another alike, through faces too, and two bodies as well`() {
        val p = patch(200)
        val before = doubleArrayOf(momentum(p, p.vx), momentum(p, p.vy), momentum(p, p.vz))
        val x = p.vx.copyOf()
        BodyGravity(intArrayOf(7, 9), sheet, 5.0).kick(p, 0.4, 0.5)
        assertEquals(before[0], momentum(p, p.vx), 1e-11)
        assertEquals(before[1], momentum(p, p.vy), 1e-11)
        assertEquals(before[2], momentum(p, p.vz), 1e-11)
        assertTrue((0 until 200).all { p.vx[it] != x[it] })
        val pair = populationOf(Sphere(x = -24.0, m = 2.0), Sphere(x = 24.0, y = 1.0, m = 3.0))
        BodyGravity(intArrayOf(0, 1), sheet, 1.0).kick(pair, 0.0, 1.0)
        // The image of the second is 2 further in, at x = −26.
        val d = sqrt(5.0)
        assertEquals(-3.0 * 2.0 / (d * d * d), pair.vx[0], 1e-14)
        assertEquals(2.0 * 2.0 / (d * d * d), pair.vx[1], 1e-14)
    }

    private fun momentum(p: Population, v: DoubleArray): Double = (0 until p.size).sumOf { p.mass[it] * v[it] }

    @Test
    fun `who falls onto the moon is removed, who passes beside it is not`() {
        val moon = Satellite(1e-3, Epicycle(0.0, 0.0, 0.0, 0.0), 1.0)
        val boundary = SatelliteSurface(Open, moon, 2.0)
        val p = populationOf(Sphere(x = 1.0, y = 8.0, vy = -1.5, r = 0.1), Sphere(x = 4.0, y = 8.0, vy = -6.0, r = 0.1))
        val simulation = Simulation(p, boundary, null, FixedTimeStep(0.05), listOf(HillFrame(1.0), moon))
        repeat(200) { simulation.advance() }
        assertEquals(listOf(1), p.id.toList())
        assertEquals(1L, boundary.removed)
    }
}
