package daphnis.analysis.diffusion

import daphnis.core.format.Snapshot
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.sin

class VelocityAutocorrelationTest {
    private val isFull = System.getProperty("daphnis.physics") == "full"

    /** Two that turn in opposite phase: C = cos(ω t), without any noise. */
    private fun turning(frequency: Double, step: Double, times: Int = 64): Trajectories {
        val p = Walkers.population(2)
        return Trajectories(List(3) { Coordinate.Velocity(it) }, intArrayOf(0, 1)).also { all ->
            for (t in 0 until times) {
                for (k in 0..1) {
                    p.vx[k] = cos(frequency * t * step + k * PI)
                    p.vy[k] = sin(frequency * t * step + k * PI)
                }
                all.add(Snapshot.of(p, Walkers.BOUNDARY, t.toLong(), t * step))
            }
        }
    }

    @Test
    fun `of what turns C is the cosine, and its integral the sine at every lag`() {
        val found = VelocityAutocorrelation(turning(2.0, 0.1))
        val integral = found.integral()
        assertEquals(33, found.lag.size)
        for (l in found.lag.indices) {
            assertEquals(cos(0.2 * l), found.correlation[l], 1e-12) { "$l" }
            assertEquals(sin(0.2 * l) / 2 / 3, integral[l], 2e-5) { "$l" }
        }
        assertTrue(found.isFine)
        assertEquals(7, VelocityAutocorrelation(turning(2.0, 0.1), 0.6).lag.size)
    }

    @Test
    fun `the mean of the integral has the weights of the slope of displacements`() {
        // M(t) = (1 − cos ωt)/ω² · 2/3 has M″ = 2C/3: the slope over 2 of the fit of MeanSquareDisplacement.
        val found = VelocityAutocorrelation(turning(1.0, 0.1))
        val lags = (8..30).map { it * 0.1 }
        val weight = lags.map { 1 / (it * it) }
        val centre = lags.indices.sumOf { weight[it] * lags[it] } / weight.sum()
        val norm = lags.indices.sumOf { weight[it] * (lags[it] - centre) * (lags[it] - centre) }
        val m = lags.map { (1 - cos(it)) * 2 / 3 }
        val slope = lags.indices.sumOf { weight[it] * (lags[it] - centre) * m[it] } / norm
        val d = found.diffusion(0.8, 3.0)!!
        assertEquals(slope / 2, d.value, 3e-4)
        assertEquals(0.8, d.from, 1e-12)
        assertEquals(3.0, d.to, 1e-12)
        assertNull(found.diffusion(0.8, 3.5))
        assertNull(found.diffusion(0.8, 0.9))
    }

    @Test
    fun `what forgets at one rate has its slope and its diffusion, and errors cover them in 60 to 75 percent`() {
        val random = SeededRandom(7)
        val rate = 0.15
        val realisations = if (isFull) 400 else 80
        var (slopes, diffusions, curves) = listOf(0, 0, 0)
        var (slope, diffusion) = listOf(0.0, 0.0)
        val known = (1 - exp(-rate * 20)) / rate
        repeat(realisations) {
            val found = VelocityAutocorrelation(Walkers.forgetting(40, 400, random, rate, 1.0))
            val s = found.slope()!!
            val d = found.diffusion(18.0, 22.0)!!
            slope += s.mean / realisations
            diffusion += d.value / realisations
            if (abs(s.mean + rate) < s.error) slopes++
            // The centre of mass of 40 takes a fortieth.
            if (abs(d.value - known * 39 / 40) < d.error) diffusions++
            if (abs(found.normalised[4] - exp(-4 * rate)) < found.normalisedError()[4]) curves++
        }
        assertEquals(-rate, slope, 0.004)
        assertEquals(known * 39 / 40, diffusion, 0.12)
        val between = realisations * 55 / 100..realisations * 80 / 100
        if (isFull) println("slopes $slopes, D $diffusions, C $curves of $realisations; means $slope, $diffusion")
        assertTrue(slopes in between) { "slopes $slopes of $realisations" }
        assertTrue(diffusions in between) { "D $diffusions of $realisations" }
        assertTrue(curves in between) { "C $curves of $realisations" }
    }

    @Test
    fun `a cusp at 0 is taken as it is, and states too far apart have no slope and no integral`() {
        val random = SeededRandom(3)
        val fine = VelocityAutocorrelation(Walkers.forgetting(400, 400, random, 0.2, 1.0))
        assertNotNull(fine.slope())
        // Three lags: exp(−0.6) is still above a half, exp(−0.75) is not.
        assertNull(VelocityAutocorrelation(Walkers.forgetting(4000, 40, random, 0.25, 1.0)).slope())
        val coarse = VelocityAutocorrelation(Walkers.forgetting(4000, 40, random, 0.7, 1.0))
        assertTrue(!coarse.isFine && coarse.diffusion(2.0, 8.0) == null)
        assertTrue(fine.normalisedError()[0] == 0.0 && fine.normalisedError().last().isNaN())
        assertTrue(fine.integralError()[0] == 0.0 && fine.integralError()[1] > 0 && fine.integralError().last().isNaN())
    }

    @Test
    fun `a common drift is no memory, and no images are needed`() {
        val p = Walkers.population(200)
        val random = SeededRandom(1)
        val drifting = Walkers.velocities(p, 40, 1.0) { v -> for (k in v.indices) v[k] = 3 + random.nextGaussian() }
        assertEquals(0.0, VelocityAutocorrelation(drifting).normalised[3], 0.05)
        assertTrue(Coordinate.Position(0).needsImages && !Coordinate.Velocity(0).needsImages)
    }

    @Test
    fun `few times, one particle and times that are not evenly spread are refused`() {
        val random = SeededRandom(1)
        for (wrong in listOf(
            Walkers.forgetting(10, 15, random, 0.1, 1.0),
            Walkers.forgetting(1, 20, random, 0.1, 1.0),
            Trajectories(List(3) { Coordinate.Velocity(it) }, intArrayOf(0, 1)).also { all ->
                val p = Walkers.population(2)
                for (t in 0 until 20) all.add(Snapshot.of(p, Walkers.BOUNDARY, t.toLong(), t * t * 0.1))
            },
        )) {
            assertThrows(IllegalArgumentException::class.java) { VelocityAutocorrelation(wrong) }
        }
    }
}
