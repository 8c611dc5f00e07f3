package daphnis.analysis.streamline

import daphnis.analysis.insitu.State
import daphnis.analysis.onEpicycles
import daphnis.analysis.order.RadialKey
import daphnis.analysis.uniform
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/** Whether streamline columns are right, and their errors honest, for few particles in a group. */
@Tag("jdk-neutral")
class StreamlineErrorTest {
    private val omega = 0.7
    private val box = Box.centred(20.0, 60.0, 2.0)

    /**
     * [count] particles of Rayleigh distributed e and i of scale [E], phases at random, a common [forced] e along x.
     * Guiding centres fill the box or a ring in it; the forced part grows with them by [gradient].
     */
    private fun ring(
        boundary: BoundaryConditions,
        count: Int,
        forced: Double,
        seed: Long,
        half: Double = 10.0,
        gradient: Double = 0.0,
    ): State {
        val random = SeededRandom(seed)
        val epicycles = List(count) {
            val free = E * random.nextGaussian()
            val s = E * random.nextGaussian()
            val h = E * random.nextGaussian()
            val w = E * random.nextGaussian()
            val x = random.nextDouble(-half, half)
            val c = free + forced + gradient * x
            Epicycle(
                x,
                random.nextDouble(-30.0, 30.0),
                Math.hypot(c, s),
                Math.atan2(s, c),
                Math.hypot(h, w),
                Math.atan2(w, h),
            )
        }
        val state = onEpicycles(epicycles, boundary, omega)
        boundary.endStep(state.population, 0.0)
        return state
    }

    @Tag("thorough")
    @Test
    fun `a uniform ring has its optical depth in both orders, at 4 to 100 particles a group`() {
        for (boundary in listOf(HillSheet(box, omega), HillSheet(box, omega, radiallyOpen = true))) {
            for (key in listOf(RadialKey.X, RadialKey.GUIDING_CENTRE)) {
                for (perGroup in listOf(4, 12, 100)) {
                    val groups = if (perGroup == 100) 6 else 12
                    val count = perGroup * 5 * groups
                    val truth = count * PI * 0.01 / (20 * 60)
                    var sum = 0.0
                    var measured = 0
                    repeat(if (perGroup == 100) 40 else 120) { seed ->
                        val lines = Streamlines.of(ring(boundary, count, 0.0, seed + 1L), 5, groups, key)
                        // The edge of a ringlet is smeared by the epicycles.
                        val inner = if (boundary.radiallyOpen) 2 else 0
                        for (slab in 0 until 5) {
                            for (group in inner until groups - inner) {
                                sum += lines.opticalDepth[lines.at(slab, group)]
                                measured++
                            }
                        }
                    }
                    assertEquals(
                        1.0,
                        sum / measured / truth,
                        if (perGroup == 4) {
                            0.04
                        } else {
                            0.015
                        },
                    ) { "$key, $perGroup a group, open ${boundary.radiallyOpen}" }
                }
            }
        }
    }

    @Test
    fun `columns of a group tell the truth within one error in 60 to 75 percent, at 10 to 30 particles a group`() {
        for (perGroup in listOf(Streamlines.FEWEST_FOR_ERROR, 12, 30)) cover(perGroup)
    }

    private fun cover(perGroup: Int) {
        val forced = 0.3
        val count = 24 * perGroup
        val truth = mapOf(
            "optical_depth" to count * PI * 0.01 / 1200,
            "mean_i" to E * sqrt(PI / 2),
            "forced_e" to forced,
            "phase" to 0.0,
            // v_x = Ω e sin φ, v_y + 3/2 Ω x = ½ Ω e cos φ, v_z = Ω i sin.
            "dispersion" to omega * E * sqrt(1 + 0.25 + 1),
            "displacement" to -forced,
            "mean_e" to meanE(forced),
        )
        val covered = HashMap<String, Int>()
        var all = 0
        var sum = 0.0
        for (seed in 1L..200L) {
            val lines = Streamlines.of(ring(HillSheet(box, omega), count, forced, seed), 4, 6, RadialKey.GUIDING_CENTRE)
            for (slab in 0 until 4) {
                for (group in 1 until 5) {
                    val k = lines.at(slab, group)
                    if (lines.count[k] < Streamlines.FEWEST_FOR_ERROR) continue
                    all++
                    fun hold(name: String, value: Double, error: Double) {
                        if (abs(value - truth.getValue(name)) <= error) covered.merge(name, 1, Int::plus)
                    }
                    hold("optical_depth", lines.opticalDepth[k], lines.opticalDepthError[k])
                    hold("mean_i", lines.meanI[k], lines.meanIError[k])
                    hold("forced_e", lines.forcedEUnbiased[k], lines.forcedEError[k])
                    hold("phase", lines.phase[k] - 2 * PI * Math.rint(lines.phase[k] / (2 * PI)), lines.phaseError[k])
                    hold("dispersion", lines.dispersion[k], lines.dispersionError[k])
                    hold("displacement", lines.meanX[k] - lines.guidingX[k], lines.meanXError[k])
                    hold("mean_e", lines.meanE[k], lines.meanEError[k])
                    sum += lines.dispersion[k]
                }
            }
        }
        for (name in truth.keys) {
            val share = covered.getValue(name) / all.toDouble()
            assertTrue(share in 0.60..0.75) { "$perGroup a group, $name: $share" }
        }
        assertEquals(truth.getValue("dispersion"), sum / all, 0.01 * truth.getValue("dispersion"))
    }

    @Test
    fun `a group of nine has no error in any column, one of ten has`() {
        for (perGroup in 9..10) {
            val lines = Streamlines.of(
                ring(HillSheet(box, omega), 6 * perGroup, 0.3, 3),
                1,
                6,
                RadialKey.GUIDING_CENTRE,
            )
            val errors = listOf(
                lines.opticalDepthError,
                lines.meanIError,
                lines.forcedEError,
                lines.phaseError,
                lines.dispersionError,
                lines.meanXError,
                lines.meanEError,
                lines.qError,
            )
            for (error in errors) assertTrue(error.all { it.isNaN() == (perGroup == 9) }) { "$perGroup a group" }
            assertTrue(lines.dispersion.none { it.isNaN() } && lines.opticalDepth.none { it.isNaN() })
        }
    }

    @Test
    fun `how near streamlines are to crossing is known within one error in 60 to 75 percent`() {
        val gradient = 0.05
        var covered = 0
        var all = 0
        for (seed in 1L..200L) {
            val patch = ring(HillSheet(box, omega), 720, 0.3, seed, gradient = gradient)
            val lines = Streamlines.of(patch, 4, 6, RadialKey.GUIDING_CENTRE)
            for (slab in 0 until 4) {
                for (group in 1 until 5) {
                    val k = lines.at(slab, group)
                    all++
                    if (abs(lines.q[k] - gradient) <= lines.qError[k]) covered++
                }
            }
        }
        assertTrue(covered.toDouble() / all in 0.60..0.75) { "$covered of $all" }
    }

    @Test
    fun `dispersion is that of the gas on average from two particles a group on, and forced e is not made of noise`() {
        for (perGroup in listOf(2, 3, 5, 20)) {
            var dispersion = 0.0
            var raw = 0.0
            var unbiased = 0.0
            var all = 0
            for (seed in 1L..100L) {
                val lines = Streamlines.of(
                    ring(HillSheet(box, omega), perGroup * 24, 0.0, seed),
                    1,
                    24,
                    RadialKey.GUIDING_CENTRE,
                )
                for (k in 0 until 24) {
                    dispersion += lines.dispersion[k]
                    raw += lines.forcedE[k]
                    unbiased += lines.forcedEUnbiased[k]
                    all++
                }
            }
            assertEquals(1.0, dispersion / all / (omega * E * 1.5), 0.012) { "$perGroup a group" }
            assertTrue(unbiased < 0.6 * raw) { "$perGroup a group: ${unbiased / raw}" }
        }
    }

    @Test
    fun `a sheared box of Lees and Edwards has the dispersion of its gas`() {
        val lines = Streamlines.of(uniform(4000, LeesEdwards(box, 3.0)) { 0.5 * it.nextGaussian() }, 4, 10)
        var square = 0.0
        for (k in 0 until 40) {
            square += lines.dispersion[k] * lines.dispersion[k] / 40
            assertEquals(0.5 * sqrt(3.0), lines.dispersion[k], 4.5 * lines.dispersionError[k])
            assertEquals(4000 * PI * 0.01 / 1200, lines.opticalDepth[k], 4.5 * lines.opticalDepthError[k])
            assertTrue(lines.meanEError[k].isNaN() && lines.meanXError[k].isNaN())
        }
        assertEquals(0.75, square, 0.02)
    }

    @Test
    fun `one particle, or one group, or two, have what they can tell`() {
        val one = Streamlines.of(ring(HillSheet(box, omega), 1, 0.0, 1), 1, 1)
        assertTrue(
            one.dispersion[0].isNaN() &&
                one.dispersionError[0].isNaN() &&
                one.meanEError[0].isNaN() &&
                one.forcedEUnbiased[0].isNaN(),
        )
        assertEquals(PI * 0.01 / 1200, one.opticalDepth[0], 1e-12)
        assertTrue(Streamlines.of(ring(HillSheet(box, omega, true), 1, 0.0, 1), 1, 1).opticalDepth[0].isNaN())
        for (groups in 1..2) {
            val lines = Streamlines.of(ring(HillSheet(box, omega), 200, 0.0, 1), 1, groups)
            for (g in 0 until groups) assertEquals(200 * PI * 0.01 / 1200, lines.opticalDepth[g], 1e-12)
            assertTrue(lines.meanXError.all { it.isNaN() }) { "places of groups by x are set by the sort" }
        }
        val ringlet = Streamlines.of(ring(HillSheet(box, omega, true), 4000, 0.0, 1), 1, 1)
        assertEquals(4000 * PI * 0.01 / 1200, ringlet.opticalDepth[0], 0.08)
    }

    /**
     * Mean of |e| for a common part [forced] and Gaussian parts of deviation [E] along both directions, by quadrature.
     */
    private fun meanE(forced: Double): Double {
        var sum = 0.0
        var weight = 0.0
        for (a in -60..60) {
            for (b in -60..60) {
                val w = Math.exp(-(a * a + b * b) / 200.0)
                sum += w * Math.hypot(forced + E * a / 10, E * b / 10)
                weight += w
            }
        }
        return sum / weight
    }

    private companion object {
        const val E = 0.2
    }
}
