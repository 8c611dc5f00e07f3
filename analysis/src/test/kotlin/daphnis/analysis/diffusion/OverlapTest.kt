package daphnis.analysis.diffusion

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt

class OverlapTest {
    private val isFull = System.getProperty("daphnis.physics") == "full"

    /** The probability that three Gaussians of deviation 1 are within [x] of 0, by Simpson's rule. */
    private fun within(x: Double): Double {
        val n = 200
        fun f(r: Double) = sqrt(2 / Math.PI) * r * r * exp(-r * r / 2)
        return (0..n).sumOf {
            f(x * it / n) * (
                if (it == 0 || it == n) {
                    1
                } else if (it % 2 == 1) {
                    4
                } else {
                    2
                }
                )
        } * x / n / 3
    }

    @Test
    fun `walkers have their overlap and no susceptibility but their own, and errors cover both in 60 to 75 percent`() {
        val random = SeededRandom(5)
        val realisations = if (isFull) 400 else 80
        var (overlaps, susceptibilities) = listOf(0, 0)
        var (overlap, susceptibility) = listOf(0.0, 0.0)
        val count = 60
        // Relative to the centre of mass, at the lag 4.
        val q = within(1.2 / (0.3 * 2 * sqrt(59.0 / 60)))
        repeat(realisations) {
            val found = Overlap(Walkers.trajectories(count, 200, random, 0.3), 1.2)
            val l = found.lag.indexOfFirst { abs(it - 4) < 1e-9 }
            overlap += found.overlap[l] / realisations
            susceptibility += found.susceptibility[l] / realisations
            if (abs(found.overlap[l] - q) < found.overlapError[l]) overlaps++
            if (abs(found.susceptibility[l] - q * (1 - q)) < found.susceptibilityError[l]) susceptibilities++
            assertTrue(found.susceptibility.last().isNaN() && found.overlapError.last().isNaN())
        }
        if (isFull) println("Q $overlap, known $q, covered $overlaps; χ₄ $susceptibility, covered $susceptibilities")
        assertEquals(q, overlap, 0.003)
        assertEquals(q * (1 - q), susceptibility, if (isFull) 0.008 else 0.016)
        val between = realisations * 55 / 100..realisations * 80 / 100
        assertTrue(overlaps in between) { "Q $overlaps of $realisations" }
        assertTrue(susceptibilities in between) { "χ₄ $susceptibilities of $realisations" }
    }

    @Test
    fun `walkers that go in groups of three fluctuate three times as much`() {
        val random = SeededRandom(11)
        fun mean(group: Int): Double = (1..12).map {
            val found = Overlap(Walkers.trajectories(300, 160, random, 0.3, group), 1.2)
            found.susceptibility[found.lag.indexOfFirst { l -> abs(l - 4) < 1e-9 }]
        }.average()
        assertEquals(3.0, mean(3) / mean(1), 0.4)
    }

    @Test
    fun `what does not move overlaps wholly without any fluctuation, and what is nonsense is refused`() {
        val still = Walkers.trajectories(10, 40, SeededRandom(1), 0.0)
        val found = Overlap(still, 0.1)
        assertTrue(found.overlap.all { it == 1.0 } && found.susceptibility[0] == 0.0)
        assertThrows(IllegalArgumentException::class.java) { Overlap(still, 0.0) }
        assertThrows(IllegalArgumentException::class.java) {
            Overlap(Walkers.trajectories(10, 15, SeededRandom(1), 0.1), 0.1)
        }
        assertThrows(IllegalArgumentException::class.java) {
            Overlap(Walkers.trajectories(1, 20, SeededRandom(1), 0.1), 0.1)
        }
    }
}
