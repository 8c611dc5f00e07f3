package daphnis.analysis.streamline

import daphnis.analysis.insitu.State
import daphnis.analysis.onEpicycles
import daphnis.analysis.order.RadialKey
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.atan2
import kotlin.math.hypot
import kotlin.math.sqrt

class StreamlinesTest {
    private val omega = 0.7
    private val sheet = HillSheet(Box.centred(20.0, 400.0, 2.0), omega, radiallyOpen = true)

    /**
     * Guiding centres on a lattice, all in one wave of wavelength 200 along the orbit whose crests lean by [lean]
     * radians a length of X.
     */
    private fun wave(e: Double, lean: Double): State = onEpicycles(
        List(100 * 400) {
            val gx = (it / 400 + 0.5) / 100 * 10 - 5
            val y = (it % 400 + 0.5) - 200
            Epicycle(gx, y, e, 2 * PI * y / 200 + lean * gx, 0.3, it * 0.1)
        },
        sheet,
        omega,
    )

    @Test
    fun `a drawn sine streamline comes back with its amplitude, wavelength, phases and q`() {
        val lines = Streamlines.of(wave(0.5, 0.4), slabs = 100, groups = 20, RadialKey.GUIDING_CENTRE)
        for (group in 2..17) {
            for (slab in 2..97) {
                val k = lines.at(slab, group)
                assertEquals(0.5, lines.meanE[k], 1e-12)
                assertEquals(0.3, lines.meanI[k], 1e-12)
                assertEquals(0.5, lines.forcedE[k], 0.005)
                val phase = 2 * PI * lines.meanY[k] / 200 + 0.4 * lines.guidingX[k]
                assertEquals(lines.guidingX[k] - 0.5 * Math.cos(phase), lines.meanX[k], 0.03)
                // |d(e exp(iφ))/dX| = e · dφ/dX.
                assertEquals(0.5 * 0.4, lines.q[k], 0.025)
                // dx/dX = 1 + e (dφ/dX) sin φ.
                assertEquals(0.5 * (1 + 0.2 * Math.sin(phase)), lines.spacing[k], 0.2)
                if (slab > 2) {
                    assertEquals(2 * PI * 4 / 200, lines.phase[k] - lines.phase[lines.at(slab - 1, group)], 0.04)
                }
            }
        }
    }

    @Test
    fun `groups are of equal count and those of a plain sort`() {
        val state = uniform(3000, sheet, omega = omega) { 0.1 * it.nextGaussian() }
        val p = state.population
        val lines = Streamlines.of(state, slabs = 10, groups = 7, RadialKey.X)
        assertEquals(3000, lines.count.sum())
        for (slab in 0 until 10) {
            val members = (0 until p.size).filter { ((p.y[it] + 200) / 40).toInt() == slab }.sortedBy { p.x[it] }
            for (group in 0 until 7) {
                val mine = members.subList(members.size * group / 7, members.size * (group + 1) / 7)
                val k = lines.at(slab, group)
                assertEquals(mine.size, lines.count[k])
                assertEquals(mine.map { p.x[it] }.average(), lines.meanX[k], 1e-12)
                assertEquals(mine.map { p.y[it] }.average(), lines.meanY[k], 1e-11)
                assertEquals(p.x[mine.first()], lines.minX[k])
                assertEquals(p.x[mine.last()], lines.maxX[k])
                val inner = lines.meanX[lines.at(slab, maxOf(group - 1, 0))]
                val outer = lines.meanX[lines.at(slab, minOf(group + 1, 6))]
                val width = if (group == 0 || group == 6) outer - inner else (outer - inner) / 2
                val excess = (if (group == 0 || group == 6) 2.0 / 3 else 5.0 / 12) - 1.0 / 7
                assertEquals(
                    mine.size * PI * 0.01 / (width * 40) * (1 - excess / mine.size),
                    lines.opticalDepth[k],
                    1e-12,
                )
                assertEquals(mine.map { 4 * p.x[it] + 2 * p.vy[it] / omega }.average(), lines.guidingX[k], 1e-11)
            }
        }
    }

    @Test
    fun `an empty slab, one particle, particles in one place and no frame are no trouble`() {
        val one = Streamlines.of(onEpicycles(listOf(Epicycle(1.0, 150.0, 0.0, 0.0)), sheet, omega), 4, 3)
        assertEquals(1, one.count.sum())
        assertTrue(one.meanX[one.at(0, 0)].isNaN())
        assertTrue(one.q.all { it.isNaN() })
        val heap =
            Population(
                DoubleArray(9) {
                    1.0
                },
                DoubleArray(9),
                DoubleArray(9),
                DoubleArray(9),
                DoubleArray(9),
                DoubleArray(9),
                DoubleArray(9) { 0.1 },
                DoubleArray(9) { 1.0 },
            )
        val same = Streamlines.of(State(heap, Open, 0.0), 2, 3)
        assertEquals(9, same.count.sum())
        assertTrue(same.opticalDepth.all { it.isNaN() } && same.forcedE.all { it.isNaN() })
        assertEquals(0, Streamlines.of(uniform(0, sheet), 2, 2).count.sum())
    }

    /** Numbers of a few particles, from the definitions. */
    private inner class Few(val state: State, val members: List<Int>) {
        private val p = state.population
        private val n = members.size

        fun mean(value: (Int) -> Double) = members.sumOf(value) / n

        fun variance(value: (Int) -> Double) = mean(value).let { m ->
            members.sumOf { (value(it) - m) * (value(it) - m) } / (n - 1)
        }

        fun error(value: (Int) -> Double) = sqrt(variance(value) / n)

        val x = { k: Int -> p.x[k] }
        val cosine = { k: Int -> ((4 - 0.81) * p.x[k] + 2 * p.vy[k] / omega) / 0.81 }
        val sine = { k: Int -> p.vx[k] / (0.9 * omega) }
        val guiding = { k: Int -> (4 * p.x[k] + 2 * p.vy[k] / omega) / 0.81 }
        val e = { k: Int -> hypot(cosine(k), sine(k)) }
        val i = { k: Int -> hypot(p.z[k], p.vz[k] / (omega * 2.5)) }
        val area = { k: Int -> PI * p.radius[k] * p.radius[k] }
        val forced = hypot(mean(cosine), mean(sine))
        val noise = (variance(cosine) + variance(sine)) / n
        val along = { k: Int -> (cosine(k) * mean(cosine) + sine(k) * mean(sine)) / forced }
        val across = { k: Int -> (sine(k) * mean(cosine) - cosine(k) * mean(sine)) / forced }
        private val flow = listOf<(Int) -> Double>({ p.vx[it] }, { p.vy[it] + 1.5 * omega * p.x[it] }, { p.vz[it] })
        private val root = sqrt(flow.sumOf { variance(it) })
        private val fourth = flow.sumOf { variance(it) * variance(it) } / (n + 1)
        val dispersion = root * (1 + 0.25 * fourth / (Math.pow(root, 4.0) - 2 * fourth))
        val dispersionError = flow.map { mean(it) }.let { m ->
            error { k -> (0..2).sumOf { (flow[it](k) - m[it]) * (flow[it](k) - m[it]) } }
        } * Math.pow(n / (n - 1.0), 1.5) / (2 * root)

        fun depth(width: Double, scatter: Double, groups: Int) =
            members.sumOf(area) / (width * 60) * (1 - maxOf(0.0, scatter - 1.0 / groups) / n)

        fun depthError(depth: Double, scatter: Double) =
            depth * sqrt(scatter / n + n * variance(area) / (members.sumOf(area) * members.sumOf(area)))
    }

    /** Particles of several sizes and all velocities in a sheet with strong vertical forces. */
    private fun few(count: Int, isOpen: Boolean): State {
        val random = SeededRandom(count.toLong())
        fun column(half: Double) = DoubleArray(count) { random.nextDouble(-half, half) }
        val x = column(10.0)
        val vy = DoubleArray(count) { random.nextDouble(-0.6, 0.9) - 1.5 * omega * x[it] }
        val vx = DoubleArray(count) { random.nextDouble(-0.3, 0.7) }
        val radius = DoubleArray(count) { random.nextDouble(0.1, 0.5) }
        val p = Population(x, column(30.0), column(1.0), vx, vy, column(0.8), radius, DoubleArray(count) { 1.0 })
        val boundary = HillSheet(Box.centred(20.0, 60.0, 2.0), omega, radiallyOpen = isOpen)
        return State(p, boundary, 0.0, OrbitalFrequencies(omega, 0.9, 2.5))
    }

    @Test
    fun `all columns of a few particles are those of their definitions`() {
        // In groups of eleven or twelve, and of two, which have no errors.
        for ((count, isOpen) in listOf(45 to false, 45 to true, 8 to false, 8 to true)) {
            val state = few(count, isOpen)
            val lines = Streamlines.of(state, 1, 4, RadialKey.GUIDING_CENTRE)
            assertEquals(listOf(1, 4, 60.0), listOf(lines.slabs, lines.groups, lines.slabWidth))
            val sorted = (0 until count).sortedBy { Few(state, listOf(it)).guiding(it) }
            val groups = List(4) { Few(state, sorted.subList(count * it / 4, count * (it + 1) / 4)) }
            val middles = groups.map { it.mean(it.guiding) }
            for ((g, few) in groups.withIndex()) {
                fun hold(name: String, wanted: Double, found: DoubleArray) =
                    assertEquals(wanted, found[g], 1e-9 * abs(wanted)) { "$name of group $g of $count, open: $isOpen" }
                fun holdError(name: String, wanted: Double, found: DoubleArray) =
                    if (count > 8) hold(name, wanted, found) else assertTrue(found[g].isNaN()) { name }
                hold("x", few.mean(few.x), lines.meanX)
                hold("guiding centre", middles[g], lines.guidingX)
                holdError("error of x", few.error(few.cosine), lines.meanXError)
                hold("e", few.mean(few.e), lines.meanE)
                holdError("error of e", few.error(few.e), lines.meanEError)
                hold("i", few.mean(few.i), lines.meanI)
                holdError("error of i", few.error(few.i), lines.meanIError)
                hold("forced e", few.forced, lines.forcedE)
                holdError("error of forced e", few.error(few.along), lines.forcedEError)
                val free = few.forced * few.forced - few.noise
                hold("forced e without noise", sqrt(maxOf(0.0, free)), lines.forcedEUnbiased)
                hold("phase", atan2(few.mean(few.sine), few.mean(few.cosine)), lines.phase)
                holdError("error of phase", few.error(few.across) / few.forced, lines.phaseError)
                hold("dispersion", few.dispersion, lines.dispersion)
                holdError("error of dispersion", few.dispersionError, lines.dispersionError)
                val isEnd = isOpen && (g == 0 || g == 3)
                val inner = if (g > 0) middles[g - 1] else middles[3] - 20
                val outer = if (g < 3) middles[g + 1] else middles[0] + 20
                val scatter = if (isEnd) 2.0 / 3 else 5.0 / 12
                val width = if (!isEnd) {
                    (outer - inner) / 2
                } else if (g == 0) {
                    outer - middles[0]
                } else {
                    middles[3] - inner
                }
                hold("optical depth", few.depth(width, scatter, 4), lines.opticalDepth)
                holdError("error of it", few.depthError(few.depth(width, scatter, 4), scatter), lines.opticalDepthError)
                val a = groups[maxOf(0, g - 1)]
                val b = groups[minOf(3, g + 1)]
                val distance = b.mean(b.guiding) - a.mean(a.guiding)
                val change = hypot(b.mean(b.cosine) - a.mean(a.cosine), b.mean(b.sine) - a.mean(a.sine))
                hold("q", change / distance, lines.q)
                holdError("error of q", sqrt((a.noise + b.noise) / 2) / distance, lines.qError)
            }
        }
    }

    @Test
    fun `one group without an image reaches half a gap beyond its outermost particles`() {
        val state = few(10, isOpen = true)
        val x = state.population.x
        val all = Few(state, x.indices.toList())
        val lines = Streamlines.of(state, 1, 1)
        val depth = all.depth((x.max() - x.min()) * 11 / 9, 2.0 / 3, 1)
        assertEquals(depth, lines.opticalDepth[0], 1e-12 * depth)
        assertEquals(all.depthError(depth, 2.0 / 3), lines.opticalDepthError[0], 1e-9 * depth)
        assertThrows(IllegalArgumentException::class.java) { Streamlines.of(state, 0, 1) }
        assertThrows(IllegalArgumentException::class.java) { Streamlines.of(state, 1, 0) }
    }

    @Test
    fun `slabs span the particles where the box has no end, and phases of particles without a common e are NaN`() {
        val p = few(40, isOpen = false).population
        val open = Streamlines.of(State(p, Open, 0.0), 4, 1)
        assertEquals((p.y.max() - p.y.min()) / 4, open.slabWidth, 1e-12)
        for (slab in 0 until 4) {
            val low = p.y.min() + slab * open.slabWidth
            val members = p.y.filter { it >= low && (it < low + open.slabWidth || slab == 3) }
            assertEquals(members.size, open.count[slab])
            assertEquals(members.average(), open.meanY[slab], 1e-12)
        }
        val one = State(p.copy().apply { y.fill(3.0) }, Open, 0.0)
        assertEquals(listOf(40, 0), Streamlines.of(one, 2, 1).count.toList())
        assertEquals(0.5, Streamlines.of(one, 2, 1).slabWidth)
        val circles = Streamlines.of(onEpicycles(List(4) { Epicycle(0.0, it * 1.0, 0.0, 0.0) }, sheet, omega), 1, 1)
        assertTrue(circles.forcedE[0] == 0.0 && circles.forcedEError[0].isNaN() && circles.phaseError[0].isNaN())
    }
}
