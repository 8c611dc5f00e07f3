package daphnis.analysis.occultation

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.exp
import kotlin.math.ln
import kotlin.math.sqrt

@Tag("jdk-neutral")
class PhotonCountsTest {
    @Test
    fun `numbers of photons are Poisson's, few and many`() {
        for (mean in listOf(0.3, 4.0, 9.9, 10.0, 37.0, 2500.0)) {
            val photons = PhotonCounts(mean, seed = 11)
            val all = DoubleArray(DRAWS) { photons.draw(mean) }
            val average = all.average()
            val variance = all.sumOf { (it - average) * (it - average) } / DRAWS
            assertEquals(mean, average, 4 * sqrt(mean / DRAWS))
            assertEquals(mean, variance, 4 * mean * sqrt((2 + 1 / mean) / DRAWS))
            // Each number that is expected a hundred times or more, as often as Poisson has it.
            var square = 0.0
            var classes = 0
            var log = -mean
            for (k in 0..(mean + 8 * sqrt(mean) + 10).toInt()) {
                if (k > 0) log += ln(mean / k)
                val expected = exp(log) * DRAWS
                if (expected < 100) continue
                val seen = all.count { it == k.toDouble() }
                square += (seen - expected) * (seen - expected) / expected
                classes++
            }
            assertTrue(square < classes + 4 * sqrt(2.0 * classes)) { "mean $mean: $square of $classes classes" }
        }
    }

    @Test
    fun `the same seed counts the same photons, none come through what is opaque, and no light is refused`() {
        val light = doubleArrayOf(0.0, 0.5, 1.0, 0.1)
        val first = PhotonCounts(40.0, 3).of(light)
        assertEquals(first.toList(), PhotonCounts(40.0, 3).of(light).toList())
        assertTrue(first.toList() != PhotonCounts(40.0, 4).of(light).toList())
        assertEquals(0.0, first[0])
        assertEquals(0.0, first[1] * 40 % 1.0, 1e-9)
        for (mean in listOf(0.0, -1.0, Double.NaN, 1e13)) {
            assertThrows(IllegalArgumentException::class.java) { PhotonCounts(mean) }
        }
    }

    private companion object {
        const val DRAWS = 40_000
    }
}
