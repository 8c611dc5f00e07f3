package daphnis.analysis.occultation

import daphnis.analysis.statistics.SampleMean
import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sin

@Tag("jdk-neutral")
class RandomDiscsTest {
    private val above = LineOfSight(PI / 2)

    @Test
    fun `two discs have in common what a lens has, and a footprint with itself its area`() {
        assertEquals(PI, Footprint.ofDiscs(1.0, 0.0), 1e-12)
        assertEquals(2 * PI / 3 - Math.sqrt(3.0) / 2, Footprint.ofDiscs(1.0, 1.0), 1e-12)
        assertEquals(0.0, Footprint.ofDiscs(1.0, 2.0))
        assertEquals(6.0, Footprint.rectangle(2.0, 3.0).overlap(0.0, 0.0))
        assertEquals(0.5 * 1.0, Footprint.rectangle(2.0, 3.0).overlap(-1.5, 2.0))
        assertEquals(Footprint.ofDiscs(1.0, 1.0), Footprint.disc(2.0).overlap(0.6, 0.8), 1e-12)
    }

    @Test
    fun `a point is free or not, so a footprint without size has the variance T(1 - T)`() {
        val discs = RandomDiscs(DoubleArray(500) { 1.0 }, 4000.0, LineOfSight(0.5, 0.3))
        val t = discs.transmission
        assertEquals(exp(-500 * PI / 4000 / sin(0.5)), t, 2e-3 * t)
        assertEquals(t * (1 - t), discs.variance(Footprint.disc(1e-3), 0.0), 2e-3 * t * (1 - t))
    }

    @Test
    fun `of a dilute slab and a large footprint it is the excess variance of Showalter and Nicholson`() {
        val (count, area) = 1_000_000 to 1e9
        val depth = count * PI / area
        for (elevation in listOf(PI / 2, 0.4)) {
            val slant = depth / sin(elevation)
            val discs = RandomDiscs(DoubleArray(count) { 1.0 }, area, LineOfSight(elevation))
            val footprint = Footprint.rectangle(400.0, 600.0)
            val expected = exp(-2 * slant) * slant * PI / sin(elevation) / footprint.area
            assertEquals(expected, discs.variance(footprint, 0.0), 0.012 * expected)
        }
    }

    @Test
    fun `many sizes are those of groups, and what covers half the patch has no number`() {
        val radii = DoubleArray(1000) { 0.5 + it / 1000.0 }
        val line = LineOfSight(1.0)
        val all = RandomDiscs(radii, 20000.0, line)
        val mean = radii.sumOf { it * it } * PI / sin(1.0) / 20000
        assertEquals(exp(-mean), all.transmission, 1e-3)
        val footprint = Footprint.rectangle(5.0, 2.0)
        val halves = listOf(radii.copyOf(500), radii.copyOfRange(500, 1000)).map { RandomDiscs(it, 20000.0, line) }
        // Variances of factors of T, nearly: each half multiplies what the other lets through.
        val product = halves[0].variance(footprint, 0.0) + halves[1].variance(footprint, 0.0)
        assertTrue(all.variance(footprint, 0.0) in 0.6 * product..product) {
            "${all.variance(footprint, 0.0)}, $product"
        }
        assertTrue(RandomDiscs(doubleArrayOf(1.0), 5.0, line).variance(footprint, 0.0).isNaN())
        assertThrows(IllegalArgumentException::class.java) { RandomDiscs(DoubleArray(0), 1.0, line) }
        assertThrows(IllegalArgumentException::class.java) { RandomDiscs(radii, 0.0, line) }
    }

    @Tag("thorough")
    @Test
    fun `scans of random spheres have this variance, within their error in two of three realisations`() {
        val sheet = HillSheet(Box.centred(36.0, 48.0, 4.0), 1.0)
        val cases = listOf(
            Triple(above, Footprint.rectangle(12.0, 12.0), 0.0),
            Triple(LineOfSight(Math.toRadians(35.0), 0.9), Footprint.rectangle(4.0, 2.0), PI / 2),
            Triple(LineOfSight(Math.toRadians(50.0), 2.1), Footprint.disc(6.0), 0.0),
        )
        val covered = IntArray(cases.size)
        val ratios = cases.map { ArrayList<Double>() }
        val count = 160
        for (seed in 1L..REALISATIONS) {
            val random = SeededRandom(seed)
            val statistics = cases.map { ScanStatistics(lags = 0) }
            repeat(20) {
                val state = overlapping(count, sheet, random)
                cases.forEachIndexed { k, (line, footprint, path) ->
                    statistics[k].add(Scan(line, footprint, path).of(state))
                }
            }
            cases.forEachIndexed { k, (line, footprint, path) ->
                val expected = RandomDiscs(DoubleArray(count) { 1.0 }, 36.0 * 48, line).variance(footprint, path)
                val seen = statistics[k].excessVariance()
                if (abs(seen.mean - expected) <= seen.error) covered[k]++
                ratios[k] += seen.mean / expected
            }
        }
        val shares = covered.map { it / REALISATIONS.toDouble() }
        val means = ratios.map { SampleMean.of(it.toDoubleArray()) }
        println("excess variance over that of random discs: $means, covered $shares of $REALISATIONS")
        for (ratio in means) assertEquals(1.0, ratio.mean, 3.5 * ratio.error + 0.003) { "$means" }
        val bounds = if (REALISATIONS == 200) 0.6..0.75 else 0.48..0.86
        for (share in shares) assertTrue(share in bounds) { "$shares" }
    }

    private companion object {
        val REALISATIONS = if (System.getProperty("daphnis.physics") == "full") 200 else 40
    }
}
