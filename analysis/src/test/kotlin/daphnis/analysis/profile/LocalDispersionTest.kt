package daphnis.analysis.profile

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.statistics.SampleMean
import daphnis.analysis.uniform
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.population.VelocityMoments
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.floor
import kotlin.math.hypot
import kotlin.math.pow
import kotlin.math.sin
import kotlin.math.sqrt

class LocalDispersionTest {
    private val box = Box.centred(100.0, 120.0, 4.0)
    private val c2 = LocalDispersion.COLUMNS.indexOf("c2")

    /**
     * A gas of dispersion σ = 0.5 along each axis that moves with a wave of amplitude [AMPLITUDE] whose crests lean: a
     * mean square of A²/2 along x and A²/8 along y.
     */
    private fun wave(count: Int, boundary: BoundaryConditions, seed: Long, amplitude: Double = AMPLITUDE): State {
        val state = uniform(count, boundary, seed) { 0.5 * it.nextGaussian() }
        val p = state.population
        for (k in 0 until count) {
            val phase = 2 * PI * (2 * p.x[k] / 100 + p.y[k] / 120)
            p.vx[k] += amplitude * cos(phase)
            p.vy[k] += amplitude / 2 * sin(phase)
        }
        return state
    }

    @Test
    fun `thermal and total dispersion of a wave are those it was made with, from 1,000 particles to 100,000`() {
        val sheet = HillSheet(box, 0.7)
        val total = sqrt(0.75 + AMPLITUDE * AMPLITUDE * 5 / 8)
        for (count in listOf(1000, 5000, 20_000, 100_000)) {
            val state = wave(count, sheet, count.toLong())
            val measure = LocalDispersion(LocalDispersion.reach(state))
            // Relative error of a mean square of 3 N numbers, three times as large at the end of a parabola, halved by
            // the root.
            val slack = 4 * 3 * sqrt(2.0 / (3 * count)) / 2
            assertEquals(1.0, sqrt(measure.of(state)[c2] / 0.75), slack) { "thermal, $count" }
            val moments = VelocityMoments.of(state.population, sheet.meanFlow, OrbitalFrequencies(0.7))
            assertEquals(1.0, moments.totalDispersion / total, 5 * 0.7 / sqrt(count.toDouble())) { "total, $count" }
            if (count >= 20_000) assertTrue(moments.dispersion > 2 * sqrt(0.75)) { "slabs see the wave" }
        }
    }

    @Test
    fun `the reach of pairs does not matter where it is short of a third of the wave`() {
        val state = wave(6000, HillSheet(box, 0.7), 3)
        for (reach in listOf(3.0, 6.0, 12.0)) {
            assertEquals(1.0, LocalDispersion(reach).of(state)[c2] / 0.75, 0.06) { "reach $reach" }
        }
    }

    @Test
    fun `in a patch that is thin along the orbit, pairs are near along x`() {
        val thin = HillSheet(Box.centred(100.0, 1.0, 4.0), 0.7)
        val state = uniform(4000, thin, 9) { 0.5 * it.nextGaussian() }
        val p = state.population
        for (k in 0 until p.size) p.vx[k] += AMPLITUDE * cos(4 * PI * p.x[k] / 100)
        val measure = LocalDispersion.fitting(state)!!
        assertTrue(measure.isAlongX)
        assertEquals(1.0, measure.of(state)[c2] / 0.75, 0.06)
        // Through the faces as well: each pair once, and none of a sphere with its own image.
        val two = uniform(2, thin) { 0.0 }
        two.population.x[0] = -49.9
        two.population.x[1] = 49.9
        assertEquals(1.0, LocalDispersion(1.0, isAlongX = true).sums(two)[0])
        assertEquals(0.0, LocalDispersion(0.1, isAlongX = true).sums(two)[0])
        for (wide in listOf(thin(30.0, 20.0), thin(400.0, 100.0))) {
            val found = LocalDispersion.fitting(uniform(4000, wide))!!
            assertTrue(!found.isAlongX && found.reach == LocalDispersion.reach(uniform(4000, wide)))
        }
        assertNull(LocalDispersion.fitting(uniform(1, thin)))
    }

    private fun thin(x: Double, y: Double) = HillSheet(Box.centred(x, y, 4.0), 0.7)

    @Tag("thorough")
    @Test
    fun `errors cover the truth in 60 to 75 percent, with a wave and without`() {
        for (amplitude in listOf(0.0, 1.0)) {
            var covered = 0
            var sum = 0.0
            for (run in 0 until RUNS) {
                val averages = Averages(LocalDispersion(12.0))
                repeat(20) { averages.add(wave(600, HillSheet(box, 0.7), 1000L * run + it + 1, amplitude)) }
                val a = averages.average(c2)
                if (abs(a.mean - 0.75) <= a.error) covered++
                sum += a.mean
            }
            assertTrue(covered in RUNS * 60 / 100..RUNS * 76 / 100) { "amplitude $amplitude: $covered of $RUNS" }
            assertEquals(0.75, sum / RUNS, 0.005)
        }
    }

    @Test
    fun `where space goes on above and below, neighbours are near in space`() {
        val tall = LeesEdwards(Box.centred(12.0, 12.0, 12.0), 0.8)
        val state = uniform(2000, tall, 5) { 0.5 * it.nextGaussian() }
        val few = uniform(20, LeesEdwards(Box.centred(100.0, 100.0, 12.0), 0.8))
        assertEquals(3.0, LocalDispersion.reach(few))
        assertEquals(1.0, LocalDispersion(3.0).of(state)[c2] / 0.75, 0.06)
    }

    /**
     * A flat layer of spheres of the [radii] that do not overlap, small ones hotter: σ = 0.5/r along each axis, mass r³,
     * as high as their motion takes them; with a wave of this [amplitude].
     */
    private fun flat(count: Int, radii: List<Double>, seed: Long, amplitude: Double): State {
        val sheet = HillSheet(box, 0.7)
        val random = SeededRandom(seed)
        val placed = ArrayList<DoubleArray>()
        val cells = HashMap<Pair<Int, Int>, ArrayList<DoubleArray>>()
        val largest = radii.max()
        fun cell(s: DoubleArray, dx: Int = 0, dy: Int = 0) =
            floor(s[0] / (2 * largest)).toInt() + dx to floor(s[1] / (2 * largest)).toInt() + dy
        var tries = 0
        while (placed.size < count && tries++ < 100 * count) {
            val r = radii[placed.size % radii.size]
            val s = doubleArrayOf(
                random.nextDouble(box.lowerX, box.upperX),
                random.nextDouble(box.lowerY, box.upperY),
                0.5 / r * random.nextGaussian(),
                r,
            )
            val near = (-1..1).flatMap { dx -> (-1..1).flatMap { dy -> cells[cell(s, dx, dy)].orEmpty() } }
            if (near.any { o -> (0..2).sumOf { (o[it] - s[it]) * (o[it] - s[it]) } < (r + o[3]) * (r + o[3]) }) continue
            placed += s
            cells.getOrPut(cell(s)) { ArrayList() } += s
        }
        val n = placed.size
        fun of(axis: Int) = DoubleArray(n) { placed[it][axis] }
        fun noise() = DoubleArray(n) { 0.5 / placed[it][3] * random.nextGaussian() }
        val (x, y) = of(0) to of(1)
        val wave = DoubleArray(n) { amplitude * cos(2 * PI * (2 * x[it] / 100 + y[it] / 120)) }
        val vx = noise().also { for (k in it.indices) it[k] += wave[k] }
        val vy = noise().also { for (k in it.indices) it[k] -= 1.5 * 0.7 * x[k] }
        val p = Population(x, y, of(2), vx, vy, noise(), of(3), DoubleArray(n) { placed[it][3].pow(3) })
        return State(p, sheet, 0.0, 0.7)
    }

    private fun thermal(state: State) = state.population.run {
        (0 until size).sumOf { mass[it] * 0.75 / (radius[it] * radius[it]) } / mass.sum()
    }

    @Tag("thorough")
    @Test
    fun `in flat layers of several sizes each sphere counts by its mass, whatever lies over it`() {
        val random = SeededRandom(8)
        repeat(6) { draw ->
            val radii = List(2 + draw % 4) { random.nextDouble(0.7, 2.8) }
            val amplitude = if (draw % 2 == 0) 0.0 else AMPLITUDE
            val measure = LocalDispersion(LocalDispersion.reach(flat(1200, radii, 1, 0.0)))
            val averages = Averages(measure)
            val totals = ArrayList<Double>()
            var truth = 0.0
            for (seed in 1L..20) {
                val state = flat(1200, radii, 100 * seed + draw, amplitude)
                averages.add(state)
                truth += thermal(state) / 20
                totals += VelocityMoments.of(state.population, state.boundary.meanFlow, state.frequencies!!)
                    .totalDispersion
            }
            val found = averages.average(c2)
            val total = SampleMean.of(totals.toDoubleArray())
            val what = "radii $radii, amplitude $amplitude: $found for $truth, total $total"
            // The wave is a quarter longer than four reaches; a thousandth of its square is left, at a hundred times c².
            assertEquals(truth, found.mean, 4 * found.error + amplitude * amplitude / 1000) { what }
            assertTrue(found.error < 0.03 * truth) { what }
            // It is a part of the total.
            assertTrue(sqrt(found.mean) <= total.mean + 3 * hypot(total.error, found.root().error)) { what }
        }
    }

    @Test
    fun `pairs are weighted by mass, bodies are no particles, and few pairs say nothing`() {
        // A tenth of the particles is ten times as heavy and at rest: ⟨c²⟩ by mass is that of the light ones, times a
        // share of 9/19.
        val state = uniform(4000, HillSheet(box, 0.7)) { 0.5 * it.nextGaussian() }
        val p = state.population
        for (k in 0 until p.size step 10) {
            p.mass[k] = 10.0
            p.vx[k] = 0.0
            p.vy[k] = -1.5 * 0.7 * p.x[k]
            p.vz[k] = 0.0
        }
        assertEquals(0.75 * 9 / 19, LocalDispersion(6.0).of(state)[c2], 0.03)
        val bodies = State(p, state.boundary, 0.0, 0.7, firstBody = 40)
        assertTrue(LocalDispersion(1.0).of(bodies).drop(1).all { it.isNaN() })
        assertTrue(LocalDispersion(1.0).of(uniform(0, state.boundary)).drop(1).all { it.isNaN() })
        assertTrue(LocalDispersion.reach(uniform(1, state.boundary)).isNaN())
        assertThrows(IllegalArgumentException::class.java) { LocalDispersion(Double.NaN) }
    }

    private companion object {
        const val AMPLITUDE = 3.0
        const val RUNS = 100
    }
}
