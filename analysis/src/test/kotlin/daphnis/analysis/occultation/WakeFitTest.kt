package daphnis.analysis.occultation

import daphnis.analysis.insitu.Averages
import daphnis.analysis.statistics.BlockAverage
import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.sin
import kotlin.math.tan

@Tag("jdk-neutral")
class WakeFitTest {
    private val lines = LineOfSight.grid(doubleArrayOf(12.0, 20.0, 35.0, 60.0, 90.0), DoubleArray(12) { 15.0 * it })

    /** Bars of width 1 and of a height, one every [apart], at the pitch angle [pitch], with a haze of [depth]. */
    private class Bars(
        private val height: Double,
        private val apart: Double,
        private val pitch: Double,
        private val depth: Double,
        private val section: WakeSection,
    ) {
        /** Share of [count] random rays along [line] that meet neither a bar nor the haze. */
        fun light(line: LineOfSight, count: Int, random: SeededRandom): Double {
            val slope = cos(line.azimuth - pitch) / tan(line.elevation)
            val clear = exp(-depth / sin(line.elevation))
            var free = 0
            repeat(count) {
                val n = random.nextDouble(0.0, apart)
                var isFree = random.nextDouble() < clear
                var bar = -4
                while (isFree && bar <= 5) isFree = !meets(n - bar++ * apart, slope)
                if (isFree) free++
            }
            return free / count.toDouble()
        }

        /** Whether the ray at n + z slope, at the height z, meets the bar around n = 0. */
        private fun meets(n: Double, slope: Double): Boolean {
            if (section == WakeSection.RECTANGLE) {
                val (below, above) = n - slope * height / 2 to n + slope * height / 2
                return minOf(below, above) <= 0.5 && maxOf(below, above) >= -0.5
            }
            // 4 (n + z s)² + (2z/H)² = 1 has a solution z.
            val a = 4 * slope * slope + 4 / (height * height)
            return 64 * n * n * slope * slope - 4 * a * (4 * n * n - 1) >= 0
        }
    }

    private fun share(truth: Double, seen: List<BlockAverage>) =
        seen.count { abs(it.mean - truth) <= it.error } / seen.size.toDouble()

    @Tag("thorough")
    @Test
    fun `the parameters of slabs of bars are found, each within its error in two of three realisations`() {
        for (section in WakeSection.entries) {
            val bars = Bars(0.35, 2.6, Math.toRadians(24.0), 0.12, section)
            val fits = List(REALISATIONS) { seed ->
                val random = SeededRandom(seed + 1L)
                val states = List(STATES) { DoubleArray(lines.size) { bars.light(lines[it], RAYS, random) } }
                WakeFit.of(lines, Array(lines.size) { k -> DoubleArray(STATES) { states[it][k] } }, section)!!
            }
            val shares = listOf(
                share(0.12, fits.map { it.gapDepth }),
                share(1.6, fits.map { it.gapOverWidth }),
                share(0.35, fits.map { it.heightOverWidth }),
                share(Math.toRadians(24.0), fits.map { it.pitch }),
            )
            println("$section bars, τ_G, S/W, H/W, pitch: $shares of $REALISATIONS covered; first ${fits[0].pitch}")
            for (s in shares) assertTrue(s in 0.5..0.86) { "$section $shares" }
            // Where few states are worth still fewer, nothing is seen.
            assertTrue(fits.count { it.isSeen } >= 0.8 * REALISATIONS) { "${fits.count { it.isSeen }} seen" }
            assertEquals(0.35, fits.map { it.heightOverWidth.mean }.average(), 0.01)
        }
    }

    @Test
    fun `what the model itself lets through gives its parameters back, at every pitch angle`() {
        for (section in WakeSection.entries) {
            for (pitch in listOf(-80.0, -20.0, 0.0, 24.0, 70.0)) {
                val model = WakeModel(0.2, 0.4, 0.25, Math.toRadians(pitch), section)
                val found = WakeFit.fitted(lines, DoubleArray(lines.size) { model.transmission(lines[it]) }, section)
                assertEquals(0.2, found.gapDepth, 1e-4) { "$section $pitch" }
                assertEquals(1.5, found.gapOverWidth, 1e-3) { "$section $pitch" }
                assertEquals(0.25, found.heightOverWidth, 1e-3) { "$section $pitch" }
                assertEquals(Math.toRadians(pitch), found.pitch, 1e-4) { "$section $pitch" }
            }
        }
        // From above a bar covers its width; low along the bars too, and low across them all.
        val model = WakeModel(0.0, 0.4, 0.5, 0.3)
        assertEquals(0.6, model.transmission(LineOfSight(PI / 2, 1.0)), 1e-12)
        assertEquals(0.6, model.transmission(LineOfSight(0.1, 0.3 + PI / 2)), 1e-12)
        assertEquals(0.0, model.transmission(LineOfSight(0.1, 0.3)))
    }

    @Test
    fun `walls of spheres have the pitch angle and the share that they were built with`() {
        // Crests that lean by 25 degrees from the orbit, 20 apart along x, of random places in bars 6 wide and 3 high.
        val pitch = Math.toRadians(25.0)
        val ly = 60 / tan(pitch)
        val random = SeededRandom(7)
        val sheet = HillSheet(Box.centred(60.0, ly, 10.0), 1.0)
        val lines = LineOfSight.grid(doubleArrayOf(20.0, 35.0, 60.0), DoubleArray(6) { 30.0 * it })
        val averages = Averages(Transmissions(lines, rays = 96))
        repeat(16) {
            val count = 6000
            val x = DoubleArray(count)
            val y = DoubleArray(count)
            val z = DoubleArray(count)
            for (k in 0 until count) {
                y[k] = random.nextDouble(-ly / 2, ly / 2)
                val across = random.nextDouble(-3.0, 3.0) / cos(pitch)
                val at = 20 * random.nextInt(3) - y[k] * tan(pitch) + across + 3 * it
                x[k] = at - 60 * Math.floor(at / 60 + 0.5)
                z[k] = random.nextDouble(-1.5, 1.5)
            }
            averages.add(spheres(x, y, z, DoubleArray(count) { 0.8 }, sheet))
        }
        val fit = WakeFit.of(lines, Array(lines.size) { averages.series(it) }, WakeSection.RECTANGLE)!!
        assertTrue(fit.isSeen)
        assertEquals(25.0, Math.toDegrees(fit.pitch.mean), 1.0)
        // With the spheres that stick out bars are 7.6 wide and 4.6 high, but their edges let light through.
        assertTrue(fit.gapOverWidth.mean in 20 * cos(pitch) / 7.6 - 1..20 * cos(pitch) / 5.5 - 1) {
            "${fit.gapOverWidth}"
        }
        assertEquals(4.6 / 7.6, fit.heightOverWidth.mean, 0.2)
        assertEquals(0.0, fit.gapDepth.mean, 0.05)
        assertTrue(fit.misfit < 0.05) { "${fit.misfit}" }
    }

    @Test
    fun `bars that cover next to nothing are negligible, however well they are seen`() {
        for ((share, isNegligible) in listOf(0.01 to true, 0.025 to true, 0.035 to false, 0.07 to false)) {
            val model = WakeModel(0.5, share, 2.0, -0.6)
            val random = SeededRandom(3)
            val series = Array(lines.size) { k ->
                DoubleArray(20) { model.transmission(lines[k]) + 1e-4 * random.nextGaussian() }
            }
            val fit = WakeFit.of(lines, series)!!
            assertTrue(fit.isSeen) { "$share" }
            assertEquals(isNegligible, fit.isNegligible) { "$share ${fit.gapOverWidth}" }
        }
    }

    @Tag("thorough")
    @Test
    fun `without bars none are seen, and lines that cannot tell give no fit`() {
        val random = SeededRandom(2)
        var seen = 0
        repeat(50) {
            val series = Array(lines.size) { k ->
                DoubleArray(20) { exp(-0.3 / sin(lines[k].elevation)) + 0.01 * random.nextGaussian() }
            }
            if (WakeFit.of(lines, series)!!.isSeen) seen++
        }
        assertTrue(seen <= 2) { "$seen of 50" }
        // Azimuths that are not evenly spread make no harmonic of their own.
        val uneven = LineOfSight.grid(doubleArrayOf(20.0, 60.0), doubleArrayOf(0.0, 10.0, 20.0))
        val series = Array(6) { k ->
            DoubleArray(20) {
                exp(-0.3 / sin(uneven[k].elevation)) +
                    0.01 * random.nextGaussian()
            }
        }
        assertFalse(WakeFit.of(uneven, series)!!.isSeen)
        fun of(lines: List<LineOfSight>) = WakeFit.of(lines, Array(lines.size) { DoubleArray(20) { 0.5 } })
        assertNull(of(LineOfSight.grid(doubleArrayOf(20.0), doubleArrayOf(0.0, 30.0, 60.0))))
        // Half a turn on is the same line.
        assertNull(of(LineOfSight.grid(doubleArrayOf(20.0, 40.0), doubleArrayOf(0.0, 30.0, 180.0))))
        assertNull(WakeFit.of(uneven, Array(6) { DoubleArray(0) }))
    }

    private companion object {
        val REALISATIONS = if (System.getProperty("daphnis.physics") == "full") 400 else 50
        const val STATES = 20
        const val RAYS = 150
    }
}
