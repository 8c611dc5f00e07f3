package daphnis.analysis.occultation

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.ln
import kotlin.math.pow
import kotlin.math.sqrt

@Tag("jdk-neutral")
class ScanStatisticsTest {
    private fun curves(states: Int, tracks: Int, step: Double = 2.0, track: () -> DoubleArray) =
        List(states) { LightCurve(Array(tracks) { track() }, step, 1) }

    private fun statistics(curves: List<LightCurve>, lags: Int = 20, unocculted: Double? = null) =
        ScanStatistics(lags, unocculted).also { s -> curves.forEach(s::add) }

    /** Gaussian numbers of mean 0.5 and standard deviation 0.02, each [memory] times the one before and noise. */
    private fun remembering(random: SeededRandom, memory: Double, count: Int): DoubleArray {
        var x = random.nextGaussian()
        return DoubleArray(count) {
            (0.5 + 0.02 * x).also { x = memory * x + sqrt(1 - memory * memory) * random.nextGaussian() }
        }
    }

    private fun share(expected: Double, seen: List<BlockAverage>) =
        seen.count { abs(it.mean - expected) <= it.error } / seen.size.toDouble()

    @Test
    fun `moments of exponential light are 1, 2 and 6, each within its error in two of three realisations`() {
        val all = List(REALISATIONS) { seed ->
            val random = SeededRandom(seed + 1L)
            statistics(curves(24, 10) { DoubleArray(60) { -ln(1 - random.nextDouble()) * 0.01 } })
        }
        val shares = listOf(
            share(0.01, all.map { it.mean() }),
            share(1e-4, all.map { it.variance() }),
            share(2.0, all.map { it.skewness() }),
            share(6.0, all.map { it.kurtosis() }),
            share(0.0, all.map { it.autocorrelation(1) }),
        )
        println("exponential light: mean, variance, skewness, kurtosis, correlation: $shares")
        for (s in shares) assertTrue(s in 0.58..0.77) { "$shares" }
    }

    @Test
    fun `light that remembers is correlated to 1 over e over its length`() {
        val memory = 0.8
        // exp(-1) lies between lags 4 and 5, 0.8^4 = 0.4096 and 0.8^5 = 0.3277.
        val expected = 2.0 * (4 + (memory.pow(4) - Math.exp(-1.0)) / (memory.pow(4) - memory.pow(5)))
        val all = List(REALISATIONS) { seed ->
            val random = SeededRandom(seed + 1L)
            statistics(curves(24, 8) { remembering(random, memory, 100) })
        }
        val shares = listOf(
            share(expected, all.map { it.autocorrelationLength() }),
            share(memory * memory, all.map { it.autocorrelation(2) }),
            share(0.0, all.map { it.skewness() }),
            share(0.0, all.map { it.kurtosis() }),
        )
        println("light that remembers: length, correlation, skewness, kurtosis: $shares")
        for (s in shares) assertTrue(s in 0.58..0.77) { "$shares" }
        assertEquals(expected, all.map { it.autocorrelationLength().mean }.average(), 0.02 * expected)
    }

    @Tag("thorough")
    @Test
    fun `noise of photons is taken out of the variance and of the correlation, and not of what is seen`() {
        val all = List(REALISATIONS) { seed ->
            val random = SeededRandom(seed + 1L)
            val photons = PhotonCounts(400.0, seed + 1L)
            statistics(curves(24, 10) { remembering(random, 0.8, 60) }.map { it.counted(photons) }, unocculted = 400.0)
        }
        val noise = 0.5 / 400
        assertEquals(4e-4 + noise, all.map { it.variance().mean }.average(), 0.01 * noise)
        assertEquals(4e-4, all.map { it.excessVariance().mean }.average(), 0.02 * 4e-4)
        val shares = listOf(share(4e-4, all.map { it.excessVariance() }), share(0.8, all.map { it.autocorrelation(1) }))
        println("photons: excess variance, correlation: $shares")
        for (s in shares) assertTrue(s in 0.58..0.77) { "$shares" }
    }

    @Test
    fun `one state has the error of its tracks, and fewer than sixteen tracks have none`() {
        val shares = share(
            4e-4,
            List(REALISATIONS) { seed ->
                val random = SeededRandom(seed + 1L)
                statistics(curves(1, 64) { remembering(random, 0.8, 60) }).variance()
            },
        )
        assertTrue(shares in 0.58..0.77) { "$shares" }
        val random = SeededRandom(1)
        assertTrue(statistics(curves(1, 12) { remembering(random, 0.8, 60) }).variance().error.isNaN())
        // Of a second state like the first the mean counts both, the error only one.
        val two = curves(2, 64) { remembering(random, 0.8, 60) }
        assertEquals(statistics(two.drop(1)).mean().error, statistics(two).mean().error, 1e-6 * 0.02)
        assertEquals(
            two.flatMap {
                it.transmission.flatMap { t -> t.asList() }
            }.average(),
            statistics(two).mean().mean,
            1e-12,
        )
    }

    @Test
    fun `light without variance has neither skewness nor length, and short tracks few lags`() {
        val flat = statistics(curves(20, 3) { DoubleArray(4) { 0.25 } })
        assertEquals(0.25, flat.mean().mean)
        assertEquals(0.0, flat.variance().mean, 1e-18)
        assertTrue(flat.skewness().mean.isNaN() && flat.autocorrelationLength().mean.isNaN())
        assertEquals(3, flat.lagCount)
        assertEquals(0, ScanStatistics().lagCount)
        assertTrue(ScanStatistics().mean().mean.isNaN())
        assertThrows(IllegalArgumentException::class.java) { flat.autocorrelation(3) }
        assertThrows(IllegalArgumentException::class.java) { ScanStatistics(-1) }
    }

    private companion object {
        const val REALISATIONS = 200
    }
}
