package daphnis.analysis.brightness

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos

@Tag("jdk-neutral")
class AzimuthalAsymmetryTest {
    /** Darkest [before] degrees before the ansae, by [depth] of the mean either way. */
    private fun series(n: Int, states: Int, before: Double, depth: Double, seed: Long, noise: Double = 0.01) =
        SeededRandom(seed).let { random ->
            val common = DoubleArray(states) { 1 + noise * random.nextGaussian() }
            Array(n) { k ->
                val azimuth = 2 * PI * k / n - Math.toRadians(90 + before)
                DoubleArray(states) {
                    0.2 * (common[it] - depth * cos(2 * azimuth) + noise * random.nextGaussian())
                }
            }
        }

    @Test
    fun `amplitude and darkest azimuth are those that were put in, wherever it lies`() {
        for (before in listOf(-89.0, -20.0, 0.0, 23.0, 89.0)) {
            for (n in listOf(6, 8, 24)) {
                val found = AzimuthalAsymmetry.of(series(n, 30, before, 0.1, 4))!!
                assertTrue(found.isSeen)
                assertEquals(0.2, found.amplitude.mean, 5 * found.amplitude.error + 0.02)
                val off = Math.toDegrees(found.minimum.mean) - before
                val nearest = off - 180 * Math.rint(off / 180)
                assertTrue(abs(nearest) < 4 * Math.toDegrees(found.minimum.error)) { "$n, $before: $nearest" }
                assertTrue(Math.toDegrees(found.minimum.error) < 3)
            }
        }
    }

    @Test
    fun `the fourth harmonic sharpens a minimum, and is in the amplitude`() {
        val n = 24
        val sharp = Array(n) { k ->
            val azimuth = 2 * PI * k / n - Math.toRadians(110.0)
            DoubleArray(2) { 1 - 0.1 * cos(2 * azimuth) - 0.05 * cos(4 * azimuth) }
        }
        val found = AzimuthalAsymmetry.of(sharp)!!
        // −0.15 at the minimum; the largest where cos 2A = −0.1/(4 · 0.05) = −0.5: 0.05 + 0.025.
        assertEquals(0.225, found.amplitude.mean, 1e-9)
        assertEquals(20.0, Math.toDegrees(found.minimum.mean), 1e-6)
        assertFalse(found.isSeen)
    }

    @Test
    fun `noise alone is no asymmetry, and errors cover what was put in in two of three`() {
        var seen = 0
        var amplitudes = 0
        var places = 0
        for (seed in 1L..REALISATIONS) {
            if (AzimuthalAsymmetry.of(series(24, 24, 0.0, 0.0, seed))!!.isSeen) seen++
            val found = AzimuthalAsymmetry.of(series(24, 24, 20.0, 0.1, seed))!!
            // The fourth harmonic of noise adds to the largest less the smallest, on average less than its error.
            if (abs(found.amplitude.mean - 0.2) <= found.amplitude.error) amplitudes++
            if (abs(Math.toDegrees(found.minimum.mean) - 20) <= Math.toDegrees(found.minimum.error)) places++
        }
        println("asymmetry of noise seen in $seen; amplitude $amplitudes, place $places of $REALISATIONS covered")
        assertTrue(seen <= REALISATIONS / 20) { "$seen" }
        assertTrue(amplitudes in REALISATIONS * 5 / 10..REALISATIONS * 8 / 10) { "$amplitudes" }
        assertTrue(places in REALISATIONS * 58 / 100..REALISATIONS * 78 / 100) { "$places" }
    }

    @Test
    fun `too few azimuths, no states and no light are no asymmetry, and from straight above none is seen`() {
        assertNull(AzimuthalAsymmetry.of(Array(4) { DoubleArray(20) { 1.0 } }))
        assertNull(AzimuthalAsymmetry.of(Array(7) { DoubleArray(20) { 1.0 } }))
        assertNull(AzimuthalAsymmetry.of(Array(8) { DoubleArray(0) }))
        assertNull(AzimuthalAsymmetry.of(Array(8) { DoubleArray(20) }))
        val random = SeededRandom(1)
        val same = DoubleArray(20) { random.nextDouble(0.1, 0.2) }
        val above = AzimuthalAsymmetry.of(Array(24) { same })
        assertNotNull(above)
        assertFalse(above!!.isSeen)
    }

    private companion object {
        const val REALISATIONS = 200
    }
}
