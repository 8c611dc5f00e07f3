package daphnis.core.hill

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.at
import daphnis.core.boundary.isChanging
import daphnis.core.boundary.prepare
import daphnis.core.engine.BruteForceEngine
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.SerialEngine
import daphnis.core.format.Snapshot
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.population.PopulationSums
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.run.StepSums
import daphnis.core.search.Overlap
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs

class PerturbedSheetTest {
    private val omega = 1.3
    private val orbit = 2 * PI / omega
    private val length = 10.0
    private val width = 20.0
    private val box = Box.centred(length, width, 4.0)

    private fun state(p: Population, k: Int) = doubleArrayOf(p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k])

    /** One sphere as it is in the sheet, and its free path in open space, for [orbits] orbits of [steps] steps. */
    private fun follow(q: Double, frequencies: OrbitalFrequencies, steps: Int, orbits: Int, start: Epicycle): Double {
        val s = start.state(frequencies)
        val p = populationOf(Sphere(s[0], s[1], s[2], s[3], s[4], s[5]))
        val sheet = HillSheet(box, frequencies, perturbation = q)
        val dt = orbit / steps
        val simulation = Simulation(p, sheet, null, FixedTimeStep(dt), listOf(HillFrame(frequencies)))
        val path = ImagePath(length, frequencies, q)
        var worst = 0.0
        repeat(steps * orbits) {
            simulation.advance()
            val t = simulation.time
            val free = start.after(t, frequencies).state(frequencies)
            // The image of the free one that is in the box.
            val m = p.boxesCrossed(0, 0)
            val expected = doubleArrayOf(
                free[0] - m * length * path.widening(t),
                free[1] - m * path.y(t),
                free[2],
                free[3] - m * path.velocityX(t, 0.0),
                free[4] - m * path.velocityY(t, 0.0),
                free[5],
            )
            val found = state(p, 0)
            val turns = Math.rint((found[1] - expected[1]) / width)
            expected[1] += turns * width
            val scale = maxOf(1.0, abs(free[1]))
            for (k in 0..5) worst = maxOf(worst, abs(found[k] - expected[k]) / scale)
            val file = Snapshot.of(p, sheet, 1, t)
            val edges = file.edges()
            for (axis in 0..1) {
                val whole = file.position[axis][0] + (0..1).sumOf { file.image!![it][0] * edges[it][axis] }
                assertEquals(free[axis], whole, 1e-11 * scale * orbits)
            }
            val now = sheet.at(t).box
            assertTrue(p.x[0] >= now.lowerX && p.x[0] < now.upperX && p.y[0] >= -width / 2 && p.y[0] < width / 2)
        }
        assertTrue(p.boxesCrossed(0, 1) != 0) { "has not crossed a face" }
        return worst / orbits
    }

    @Test
    fun `a free sphere and its images stay images to 1e-12 an orbit, at any q, with any three frequencies`() {
        for (frequencies in listOf(OrbitalFrequencies(omega), OrbitalFrequencies(omega, 0.9, 1.7))) {
            for (q in listOf(0.0, 0.1, 0.5, 0.866, 0.99)) {
                for (steps in listOf(8, 50, 400)) {
                    val start = Epicycle(4.0, -0.5, 5.3, 0.3, 0.4, 2.0)
                    val worst = follow(q, frequencies, steps, 10, start)
                    assertTrue(worst < 1e-12) { "q = $q, $steps steps: $worst an orbit" }
                }
            }
        }
    }

    @Test
    fun `the image one period away moves as the issue says, around a point mass`() {
        val q = 0.6
        val sheet = HillSheet(box, omega, perturbation = q)
        val images = Images()
        for (k in 0..20) {
            val t = 0.37 * k
            images.prepare(sheet.at(t), t)
            val code = Images.code(1, 0, 0)
            assertEquals(length * (1 - q * Math.cos(omega * t)), images.shift(code, 0), 1e-13)
            val y = -1.5 * omega * length * t + 2 * q * length * Math.sin(omega * t)
            val turns = (images.shift(code, 1) - y) / width
            assertEquals(Math.rint(turns), turns, 1e-12)
            assertEquals(q * length * omega * Math.sin(omega * t), images.slide(code, 0), 1e-13)
            val vy = -1.5 * omega * length + 2 * omega * q * length * Math.cos(omega * t)
            assertEquals(vy, images.slide(code, 1), 1e-12)
            assertEquals(0.0, images.slide(code, 2))
            assertEquals(width, images.shift(Images.code(0, 1, 0), 1))
        }
    }

    @Test
    fun `within a step images go along the chords of their paths, and are at its end where they should be`() {
        val sheet = HillSheet(box, OrbitalFrequencies(omega, 0.8), perturbation = 0.7)
        val images = Images()
        val code = Images.code(-2, 1, 0)
        for (k in 0..20) {
            val t = 0.31 * k
            val h = 0.2
            images.prepare(sheet.during(t, h)!!, t)
            val x = images.shift(code, 0) + h * images.slide(code, 0)
            val y = images.shift(code, 1) + h * images.slide(code, 1)
            images.prepare(sheet.at(t + h), t + h)
            assertEquals(images.shift(code, 0), x, 1e-13)
            val turns = (images.shift(code, 1) - y) / width
            assertEquals(Math.rint(turns), turns, 1e-12)
        }
    }

    /** Spheres of a small ring, of which many meet images. */
    private fun ring(sheet: HillSheet, seed: Long): Population {
        val random = SeededRandom(seed)
        val now = sheet.at(0.0)
        val flow = now.meanFlow!!
        val places = ArrayList<DoubleArray>()
        while (places.size < 30) {
            val at = DoubleArray(3) { random.nextDouble(now.box.lower(it), now.box.upper(it)) }
            val isFree = places.all { other ->
                val d = DoubleArray(3) { at[it] - other[it] }
                Images().also { it.prepare(now, 0.0) }.toNearest(d)
                d.sumOf { it * it } > 1.0
            }
            if (isFree) places += at
        }
        return populationOf(
            *places.map {
                Sphere(
                    it[0],
                    it[1],
                    it[2],
                    random.nextGaussian() + flow.spread * it[0],
                    random.nextGaussian() + flow.rate * it[0],
                    random.nextGaussian(),
                    r = 0.45,
                )
            }.toTypedArray(),
        )
    }

    @Test
    fun `the grid finds every collision that asking all pairs and images finds, all through an orbit`() {
        var collisions = 0L
        for (seed in 1L..6L) {
            val sheet = HillSheet(Box.centred(8.0, 9.0, 4.0), omega, perturbation = 0.12 * seed)
            fun simulation(engine: CollisionEngine) = Simulation(
                ring(sheet, seed),
                sheet,
                CollisionForcing(ConstantRestitution(0.7), engine = engine),
                FixedTimeStep(orbit / 40),
                listOf(HillFrame(omega)),
            )
            val serial = simulation(SerialEngine())
            val all = simulation(BruteForceEngine())
            repeat(50) {
                serial.advance()
                all.advance()
                assertEquals(stateDigest(all.population), stateDigest(serial.population)) { "seed $seed, step $it" }
            }
            collisions += serial.collisions!!.counters.collisions
        }
        assertTrue(collisions > 400) { "$collisions collisions" }
    }

    @Test
    fun `spheres that rest are met by images that come nearer, and those that overlap through a face are seen`() {
        var collisions = 0L
        for (seed in 1L..30L) {
            val sheet = HillSheet(Box.centred(30.0, 6.0, 6.0), 0.1, perturbation = 0.8)
            val start = ring(HillSheet(Box.centred(30.0, 6.0, 6.0), 0.1), seed)
            for (axis in 0..2) start.velocity(axis).fill(0.0)
            // From three quarters of a period on the box narrows, by more than a diameter in a step.
            val from = 4.2 / 0.1
            val by = sheet.at(from).box.length(0) / 30.0
            for (k in 0 until start.size) start.x[k] *= by
            fun simulation(engine: CollisionEngine) = Simulation(
                start.copy(),
                sheet,
                CollisionForcing(ConstantRestitution(0.7), engine = engine),
                FixedTimeStep(1.0),
                startTime = from,
                startStep = 1,
            )
            val serial = simulation(SerialEngine())
            val all = simulation(BruteForceEngine())
            repeat(2) {
                serial.advance()
                all.advance()
                assertEquals(stateDigest(all.population), stateDigest(serial.population)) { "seed $seed, step $it" }
            }
            collisions += serial.collisions!!.counters.collisions
        }
        assertTrue(collisions > 20) { "$collisions collisions" }
        val pair = populationOf(Sphere(x = -2.4, r = 0.5), Sphere(x = 2.4, r = 0.5))
        val narrow = HillSheet(box, omega, perturbation = 0.5)
        assertEquals(0.8, Overlap.deepest(pair, narrow, 0.0).depth, 1e-12)
        assertEquals(0.0, Overlap.deepest(pair, narrow, orbit / 2).depth)
    }

    @Test
    fun `sums over velocities are against the flow of the time`() {
        val sheet = HillSheet(box, omega, perturbation = 0.5)
        val p = ring(sheet, 5)
        val sums = StepSums(PopulationSums(sheet.meanFlow))
        Simulation(p, sheet, null, FixedTimeStep(orbit / 37), listOf(HillFrame(omega))).use { simulation ->
            repeat(9) {
                simulation.advance()
                val flow = sheet.at(simulation.time).meanFlow!!
                val expected = PopulationSums(flow).apply { take(p) }
                assertEquals(expected.kinetic.toList(), sums.of(simulation).kinetic.toList())
                assertEquals(expected.mean.toList(), sums.of(simulation).mean.toList())
                val w = DoubleArray(p.size) { p.vx[it] - flow.spread * p.x[it] }
                assertEquals(w.sumOf { (it - w.average()) * (it - w.average()) } / p.size, expected.kinetic[0], 1e-12)
            }
        }
    }

    @Test
    fun `without a perturbation it is the sheet, and never changes`() {
        val plain = HillSheet(box, omega)
        val zero = HillSheet(box, omega, perturbation = 0.0)
        assertFalse(zero.isChanging)
        assertTrue(zero.at(1.0) === zero)
        assertTrue(HillSheet(box, omega, perturbation = 0.1).isChanging)
        fun digest(sheet: HillSheet): String {
            val p = ring(plain, 3)
            val forcing = CollisionForcing(ConstantRestitution(0.7))
            Simulation(p, sheet, forcing, FixedTimeStep(0.05), listOf(HillFrame(omega))).use { s ->
                repeat(40) { s.advance() }
            }
            return stateDigest(p)
        }
        assertEquals(digest(plain), digest(zero))
    }

    @Test
    fun `whatever is put back is in the box of the time, as its image, in any order and any parts`() {
        val sheet = HillSheet(box, OrbitalFrequencies(omega, 0.9), perturbation = 0.8)
        val random = SeededRandom(8)
        val n = 300
        fun far(edge: Double) = DoubleArray(n) { random.nextDouble(-9 * edge, 9 * edge) }
        val start = Population(
            far(length),
            far(width),
            far(1.0),
            far(1.0),
            far(1.0),
            far(1.0),
            DoubleArray(n) { 0.1 },
            DoubleArray(n) { 1.0 },
        )
        for (t in listOf(0.0, 1.3, 7.7)) {
            val step = sheet.during(t - 0.1, 0.1)!!
            val whole = start.copy().also { step.endStep(it, t) }
            val parts = start.copy()
            for ((from, to) in listOf(200 to n, 0 to 1, 1 to 200)) step.endStep(parts, t, from, to)
            assertEquals(stateDigest(whole), stateDigest(parts))
            val images = Images().also { it.prepare(sheet.at(t), t) }
            val chords = Images().also { it.prepare(step, t - 0.1) }
            val now = sheet.at(t)
            for (k in 0 until n) {
                val m = -whole.boxesCrossed(k, 0)
                val along = -whole.boxesCrossed(k, 1) + (m * now.shear!!.turns(t)).toInt()
                val code = Images.code(m, along, 0)
                for (axis in 0..1) {
                    val x = whole.position(axis)[k]
                    assertTrue(x >= now.box.lower(axis) && x < now.box.upper(axis)) { "$k at $x along $axis" }
                    assertEquals(start.position(axis)[k] + images.shift(code, axis), x, 1e-11)
                    assertEquals(start.velocity(axis)[k] + chords.slide(code, axis), whole.velocity(axis)[k], 1e-11)
                }
            }
        }
    }

    @Test
    fun `what is no perturbation is refused`() {
        for (q in listOf(-0.1, 1.0, 1.5, Double.NaN)) {
            assertThrows(IllegalArgumentException::class.java) { HillSheet(box, omega, perturbation = q) }
        }
        assertThrows(IllegalArgumentException::class.java) {
            HillSheet(box, OrbitalFrequencies(omega), radiallyOpen = true, perturbation = 0.1)
        }
    }
}
