package daphnis.core.random

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

class CounterRandomTest {
    private fun CounterRandom.hex() = (0..3).joinToString(" ") { "%08x".format(word(it)) }

    /** Salmon et al. 2011: the answers that come with their Random123. */
    @Test
    fun `the generator gives its published answers`() {
        CounterRandom(0).let {
            it.draw(0, 0, 0, 0)
            assertEquals("6627e8d5 e169c58d bc57ac4c 9b00dbd8", it.hex())
        }
        CounterRandom(-1).let {
            it.draw(-1, -1, -1, -1)
            assertEquals("408f276d 41c83b0e a20bc7c6 6d5451fd", it.hex())
        }
        CounterRandom(0x299f31d0L shl 32 or 0xa4093822L).let {
            it.draw(0x243f6a88, 0x85a308d3.toInt(), 0x13198a2e, 0x03707344)
            assertEquals("d16cfe09 94fdcceb 5001e420 24126ea1", it.hex())
        }
    }

    /** Another program's quantiles, to 16 digits. */
    @Test
    fun `normal quantiles are exact, in the middle and in the tails`() {
        val known = mapOf(
            1.0 / (1L shl 33) to -6.337957754553789,
            1e-6 to -4.753424308822899,
            0.01 to -2.3263478740408408,
            0.0749 to -1.4402382675279632,
            0.0751 to -1.4388253927525398,
            0.3 to -0.5244005127080407,
            0.5 to 0.0,
            0.7 to 0.5244005127080407,
            0.99 to 2.3263478740408408,
            1 - 1.0 / (1L shl 33) to 6.337957754553789,
        )
        for ((p, x) in known) assertEquals(x, CounterRandom.quantile(p), 4e-15, "$p")
    }

    @Test
    fun `moments are those of normal numbers, and neither spheres, times, streams nor seeds share numbers`() {
        val random = CounterRandom(5)
        val n = 200_000
        val m = DoubleArray(5)
        for (id in 0 until n) {
            random.draw(id, 0.25, 1)
            for (k in 0..2) {
                var power = 1.0
                for (e in 1..4) {
                    power *= random.gaussian(k)
                    m[e] += power / (3.0 * n)
                }
            }
        }
        val bound = 4 / sqrt(3.0 * n)
        assertTrue(abs(m[1]) < bound && abs(m[2] - 1) < bound * sqrt(2.0), "${m.toList()}")
        assertTrue(abs(m[3]) < bound * sqrt(15.0) && abs(m[4] - 3) < bound * sqrt(96.0), "${m.toList()}")
        val seen = HashSet<String>()
        for (id in listOf(0, 1, -1)) {
            for (time in listOf(0.0, 0.1, 0.1 + 1e-17, 0.1.nextUp(), 1e300)) {
                for (stream in 0..1) {
                    for (seed in listOf(0L, 1L, 1L shl 32)) {
                        seen += CounterRandom(seed).apply { draw(id, time, stream) }.hex()
                    }
                }
            }
        }
        // 0.1 + 1e-17 is 0.1.
        assertEquals(3 * 4 * 2 * 3, seen.size)
    }

    private fun Double.nextUp() = Math.nextUp(this)
}
