package daphnis.analysis.moonlet

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.util.Random
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt

class RandomWalkTest {
    /** A walk of known D and v, whose pushes are forgotten after a time of [memory] rows; rows are 0.5 apart. */
    private fun walk(random: Random, rows: Int, d: Double, v: Double, memory: Double): Pair<DoubleArray, DoubleArray> {
        val keep = if (memory > 0) exp(-1 / memory) else 0.0
        // The sum of a series with this memory walks by (1 + keep)/(1 − keep) of its variance per row.
        val size = sqrt(2 * d * 0.5 * (1 - keep) / (1 + keep))
        var push = random.nextGaussian()
        var x = 3.0
        val time = DoubleArray(rows) { 7 + 0.5 * it }
        val places = DoubleArray(rows) {
            if (it > 0) {
                push = keep * push + sqrt(1 - keep * keep) * random.nextGaussian()
                x += size * push + v * 0.5
            }
            x
        }
        return time to places
    }

    /** In how many of 400 walks the errors cover the truth, for [walkers] that walk together. */
    private fun coverage(walkers: Int, rows: Int, memory: Double): Pair<Double, Double> {
        val random = Random(11)
        var drift = 0
        var diffusion = 0
        repeat(400) {
            val all = List(walkers) { walk(random, rows, 0.3, 0.02, memory) }
            val found = RandomWalk.settled(all.map { it.first }, all.map { it.second }, 5.0)
            if (abs(found.drift - 0.02) < found.driftError) drift++
            if (abs(found.diffusion - 0.3) < found.diffusionError) diffusion++
        }
        return drift / 400.0 to diffusion / 400.0
    }

    @Test
    fun `errors cover a known drift and diffusion in 60 to 75 of 100 walks`() {
        for ((walkers, rows, memory) in listOf(Triple(1, 401, 0.0), Triple(1, 401, 0.5), Triple(4, 101, 0.5))) {
            val (drift, diffusion) = coverage(walkers, rows, memory)
            assertTrue(drift in 0.6..0.75) { "drift $drift of $walkers with memory $memory" }
            assertTrue(diffusion in 0.6..0.75) { "diffusion $diffusion of $walkers with memory $memory" }
        }
    }

    @Test
    fun `where a push is taken back in part, times are doubled until changes are independent`() {
        val random = Random(5)
        val short = ArrayList<Double>()
        val long = ArrayList<Double>()
        repeat(200) {
            // A walk of D = 0.3, and on top of it a swing of 2.5 that forgets itself after 1.5.
            val (time, x) = walk(random, 1601, 0.3, 0.0, 0.0)
            var swing = 0.0
            val keep = exp(-0.5 / 1.5)
            for (k in x.indices) {
                swing = keep * swing + sqrt(1 - keep * keep) * 2.5 * random.nextGaussian()
                x[k] += swing
            }
            val first = RandomWalk.of(listOf(time), listOf(x), 5.0)
            assertTrue(!first.isSettled && first.correlation < 0) { "${first.correlation}" }
            short += first.diffusion
            val found = RandomWalk.settled(listOf(time), listOf(x), 5.0)
            assertTrue(found.length >= 10 && found.diffusionError.isNaN() != found.isSettled)
            long += found.diffusion
        }
        // What a swing adds is its variance over the time: 1.25 at 5, 0.16 at 40.
        assertEquals(1.5, short.average(), 0.1)
        assertTrue(long.average() < 0.6) { "${long.average()}" }
    }

    @Test
    fun `a way without a walk is all drift`() {
        val time = DoubleArray(41) { it * 0.25 }
        val found = RandomWalk.of(listOf(time), listOf(DoubleArray(41) { 2 - 0.5 * time[it] }), 1.0)
        assertEquals(-0.5, found.drift, 1e-14)
        assertEquals(0.0, found.diffusion, 1e-28)
        assertEquals(10, found.times)
        // A zigzag by 1 that each time takes back: D by hand, 10 changes of ±1 with the mean 0 in a time of 10.
        val zigzag = RandomWalk.of(listOf(time), listOf(DoubleArray(41) { ((it / 4) % 2).toDouble() }), 1.0)
        assertEquals(10.0 / (2 * 10) * 10 / 9, zigzag.diffusion, 1e-12)
        assertEquals(sqrt(2 * zigzag.diffusion * 8), zigzag.amplitude(8.0), 1e-12)
        assertEquals(zigzag.amplitude(8.0) / sqrt(18.0), zigzag.amplitudeError(8.0), 1e-12)
    }

    @Test
    fun `too short a walk has no errors, and one of a single time is refused`() {
        val time = DoubleArray(14) { it * 0.5 }
        val short = RandomWalk.of(listOf(time), listOf(DoubleArray(14) { it % 3.0 }), 1.0)
        assertTrue(short.driftError.isNaN() && short.diffusionError.isNaN() && short.diffusion > 0)
        assertThrows(IllegalArgumentException::class.java) { RandomWalk.of(listOf(time), listOf(time), 4.0) }
        assertThrows(IllegalArgumentException::class.java) { RandomWalk.of(listOf(time), listOf(time), 0.0) }
        assertThrows(IllegalArgumentException::class.java) {
            RandomWalk.of(listOf(DoubleArray(0)), listOf(DoubleArray(0)), 1.0)
        }
    }
}
