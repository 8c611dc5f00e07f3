package daphnis.core.collision

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.math.BigDecimal

/** The kernel against exact arithmetic: BigDecimal, of the very numbers that it has. */
class ContactKernelTest {
    private class Pair(val d: DoubleArray, val u: DoubleArray, val reach: Double) {
        /** What the kernel finds within the time of [closing]: a, b, c; null when it dismisses the pair. */
        fun quadratic(closing: Double): DoubleArray? {
            ifApproaching(d[0], d[1], d[2], u[0], u[1], u[2], reach, closing) { a, b, c ->
                return doubleArrayOf(a, b, c)
            }
            return null
        }

        fun timeToContact() = timeToContact(d[0], d[1], d[2], u[0], u[1], u[2], reach)
    }

    private fun draw(random: SeededRandom): Pair {
        val d = DoubleArray(3) { random.nextGaussian() * 3 }
        return Pair(d, DoubleArray(3) { random.nextGaussian() * 0.3 - d[it] * 0.6 }, 0.5 + random.nextDouble() * 2)
    }

    /** Whether the smaller root of a t² + 2 b t + c with b < 0 < c is at most [t], exactly. */
    private fun touchesBy(q: DoubleArray, t: Double): Boolean {
        val (a, b, c) = q.map { BigDecimal(it) }
        val time = BigDecimal(t)
        if (b * b < a * c) return false
        val isBelow = a * time * time + BigDecimal(2) * b * time + c <= BigDecimal.ZERO
        return isBelow || a * time >= b.negate()
    }

    @Test
    fun `the time to contact is the smaller root, to a few units of rounding`() {
        val random = SeededRandom(11)
        var contacts = 0
        repeat(20_000) {
            val pair = draw(random)
            val t = pair.timeToContact()
            val q = pair.quadratic(Double.NEGATIVE_INFINITY)
            if (q == null || q[2] <= 0.0) {
                assertEquals(if (q == null) NEVER else 0.0, t)
                return@repeat
            }
            // Where the discriminant cancels, the root is as uncertain as its numbers.
            if (q[1] * q[1] - q[0] * q[2] < 1e-3 * q[1] * q[1]) return@repeat
            contacts++
            assertTrue(touchesBy(q, t * (1 + 1e-12))) { "${q.toList()}: not by $t" }
            assertFalse(touchesBy(q, t * (1 - 1e-12))) { "${q.toList()}: before $t" }
        }
        assertTrue(contacts > 1000) { "only $contacts contacts" }
    }

    @Test
    fun `no pair that touches within the rest of the step is dismissed, and most others are`() {
        val random = SeededRandom(12)
        var kept = 0
        var dismissed = 0
        repeat(20_000) {
            val pair = draw(random)
            val duration = Math.pow(10.0, random.nextDouble(-6.0, 1.0))
            val rest = random.nextDouble() * duration
            val q = pair.quadratic(Double.NEGATIVE_INFINITY) ?: return@repeat
            val isFound = pair.quadratic(closingWithin(rest, duration)) != null
            val touches = q[2] <= 0.0 || touchesBy(q, rest)
            if (touches) kept++
            if (!isFound) dismissed++
            assertTrue(isFound || !touches) { "${q.toList()} within $rest of $duration" }
        }
        assertTrue(kept > 1000 && dismissed > 5000) { "$kept kept, $dismissed dismissed" }
    }

    @Test
    fun `a contact that round-off puts on the end of the step is not dismissed`() {
        val random = SeededRandom(13)
        var atEnd = 0
        repeat(200_000) {
            val duration = Math.pow(10.0, random.nextDouble(-3.0, 3.0))
            val time = duration * (1 - Math.pow(10.0, random.nextDouble(-9.0, -0.3)))
            val rest = duration - time
            // Surfaces so near that the contact comes at c / (−2b), in some units of rounding about the end.
            val distance = 1 + Math.pow(10.0, random.nextDouble(-15.5, -10.0))
            val c = distance * distance - 1
            val speed = c / (2 * distance * rest) * (1 + random.nextDouble(-2.0, 2.0) * Math.ulp(duration) / rest)
            val tuned = Pair(doubleArrayOf(distance, 0.0, 0.0), doubleArrayOf(-speed, 0.0, 0.0), 1.0)
            if (time + tuned.timeToContact() > duration) return@repeat
            atEnd++
            val isFound = tuned.quadratic(closingWithin(rest, duration)) != null
            assertTrue(isFound) { "a contact after ${tuned.timeToContact()} at $time of $duration" }
        }
        assertTrue(atEnd > 50_000) { "only $atEnd at the end" }
    }

    @Test
    fun `what is unknown is never dismissed, and its time is unknown`() {
        for (k in 0..2) {
            val d = doubleArrayOf(4.0, 0.0, 0.0).also { it[k] = Double.NaN }
            val pair = Pair(d, doubleArrayOf(-1.0, 0.0, 0.0), 1.0)
            assertTrue(pair.quadratic(closingWithin(1e-3, 1.0)) != null)
            assertTrue(pair.timeToContact().isNaN())
        }
    }

    @Test
    fun `a pair that grazes to the last bit touches, one that slides along its contact does not`() {
        // b² = 9 = a c: at the end of three units of way they are side by side, 2 apart.
        assertEquals(3.0, timeToContact(3.0, 2.0, 0.0, -1.0, 0.0, 0.0, 2.0))
        for (distance in listOf(2.0, 1.0)) {
            assertEquals(NEVER, timeToContact(distance, 0.0, 0.0, 0.0, 1.0, 0.0, 2.0))
            assertEquals(NEVER, timeToContact(distance, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0))
        }
    }
}
