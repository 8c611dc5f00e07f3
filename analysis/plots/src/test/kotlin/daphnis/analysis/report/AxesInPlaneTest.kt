package daphnis.analysis.report

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class AxesInPlaneTest {
    private val random = SeededRandom(11)

    /**
     * Of 2000 states of [n] particles, how many have a direction, if their second axis is [ratio] as long as the first.
     * Errors are known from a dozen degrees of freedom.
     */
    private fun seen(n: Int, ratio: Double): Int = (1..2000).count {
        var xx = 0.0
        var yy = 0.0
        var xy = 0.0
        repeat(n) {
            val a = random.nextGaussian()
            val b = ratio * random.nextGaussian()
            // Turned by 30 degrees.
            val x = a * sqrt(0.75) - b * 0.5
            val y = a * 0.5 + b * sqrt(0.75)
            xx += x * x / n
            yy += y * y / n
            xy += x * y / n
        }
        val square = (1..12).sumOf { random.nextGaussian().let { it * it } } / 12
        val error = (xx + yy) / 2 / sqrt(n.toDouble()) * sqrt(square)
        AxesInPlane.isSeen((xx - yy) / 2, error, xy, error)
    }

    @Test
    fun `an isotropic gas has a direction in one of a hundred states, one twice as wide as high in all`() {
        for (n in listOf(30, 300)) {
            val isotropic = seen(n, 1.0)
            assertTrue(isotropic in 3..40) { "$isotropic of 2000 with $n particles" }
        }
        assertTrue(seen(300, 0.5) == 2000)
    }
}
