package daphnis.core.wall

import daphnis.core.collision.NEVER
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs

/** First contacts with walls that move, against paths that are looked at in very many moments. */
class MovingFaceTest {
    private class Case(seed: Long) {
        private val random = SeededRandom(seed)
        val isLower = random.nextInt(2) == 0
        val motion = drawn()
        val gravity = if (random.nextInt(2) == 0) 0.0 else random.nextDouble(-3.0, 3.0)
        val start = random.nextDouble(0.0, 1e4)
        val duration = Math.exp(random.nextDouble(-4.0, 2.0))
        val from = duration * if (random.nextInt(2) == 0) 0.0 else random.nextDouble()
        val r = random.nextDouble(0.1, 1.0)
        val place = random.nextDouble(-3.0, 3.0)
        val inward = if (isLower) 1.0 else -1.0
        val face = MovingFace(isLower, motion, gravity).apply { begin(place, start, duration) }
        val v = 2 * random.nextGaussian()

        /** Some touch at once, or nearly. */
        val x = wall(from) + inward * (r + listOf(0.0, 1e-9, 0.1, 1.0)[random.nextInt(4)] * random.nextDouble())

        private fun drawn(): WallMotion? {
            val amplitude = Math.exp(random.nextDouble(-5.0, 1.0))
            val frequency = Math.exp(random.nextDouble(-3.0, 2.0))
            val phase = random.nextDouble(-1.0, 1.0)
            return when (random.nextInt(6)) {
                0 -> null
                1 -> WallMotion.Steady(random.nextDouble(-2.0, 2.0))
                2 -> WallMotion.Sawtooth(amplitude, frequency, phase, random.nextDouble(0.1, 0.9))
                3 -> WallMotion.BiParabolic(amplitude, frequency, phase)
                else -> WallMotion.Sine(amplitude, frequency, phase)
            }
        }

        /** Written down anew, from the motion as users see it. */
        fun wall(t: Double) = place + (motion?.displacement(start + t) ?: 0.0) + gravity / 2 * t * (duration - t)

        fun gap(t: Double) = inward * (x + v * (t - from) - wall(t)) - r
    }

    @Test
    fun `no contact is passed over, and at each the sphere touches the wall and comes nearer`() {
        var contacts = 0
        for (seed in 0L until 6_000) {
            val c = Case(seed)
            val t = c.face.contact(c.x, c.v, c.r, c.from)
            assertTrue(t >= c.from && (t == NEVER || t <= c.duration * (1 + 1e-12) || c.motion == null)) {
                "seed $seed"
            }
            val end = minOf(t, c.duration)
            for (k in 1 until MOMENTS) {
                val gap = c.gap(c.from + (end - c.from) * k / MOMENTS)
                assertTrue(gap > -ROUNDING) { "seed $seed: gap $gap before the contact at $t" }
            }
            if (t > c.duration) continue
            contacts++
            assertTrue(abs(c.gap(t)) < ROUNDING) { "seed $seed: gap ${c.gap(t)} at contact" }
            assertTrue(c.face.approach(c.v, t) > -1e-6) { "seed $seed: leaves with ${-c.face.approach(c.v, t)}" }
        }
        assertTrue(contacts in 2_000..4_000) { "$contacts contacts" }
    }

    @Test
    fun `velocities are the rates of displacements`() {
        val motions = listOf(
            WallMotion.Steady(-0.3),
            WallMotion.Sine(0.5, 0.7, 0.1),
            WallMotion.Sawtooth(0.5, 0.7, 0.1, 0.8),
            WallMotion.BiParabolic(0.5, 0.7, -0.4),
        )
        val random = SeededRandom(3)
        for (motion in motions) {
            repeat(200) {
                val t = random.nextDouble(0.0, 20.0)
                val h = 1e-6
                val rate = (motion.displacement(t + h) - motion.displacement(t - h)) / (2 * h)
                // A corner of the sawtooth may lie between.
                val corners = listOf(motion.velocity(t - h), motion.velocity(t + h))
                val slack = 1e-5
                assertTrue(rate > corners.min() - slack && rate < corners.max() + slack) { "$motion at $t: $rate" }
                assertTrue(abs(motion.displacement(t)) <= motion.amplitude * (1 + 1e-12))
            }
        }
        assertEquals(listOf(0.0, 0.5, -0.5), listOf(0.0, 0.25, 0.75).map { WallMotion.Sine(0.5, 1.0).displacement(it) })
        val parabolas = WallMotion.BiParabolic(0.5, 1.0)
        assertEquals(listOf(0.0, 0.5, 0.0, -0.5), listOf(0.0, 0.25, 0.5, 0.75).map { parabolas.displacement(it) })
        val teeth = WallMotion.Sawtooth(0.5, 1.0, rise = 0.75)
        assertEquals(listOf(-0.5, 0.0, 0.5), listOf(0.0, 0.375, 0.75).map { teeth.displacement(it) })
    }

    @Test
    fun `a wall that only just reaches a sphere touches it, and one that does not, does not`() {
        for (gap in listOf(0.5 - 1e-9, 0.5 + 1e-9)) {
            val face = MovingFace(true, WallMotion.Sine(0.5, 1.0), 0.0).apply { begin(0.0, 0.0, 10.0) }
            val t = face.contact(1.0 + gap, 0.0, 1.0, 0.0)
            if (gap < 0.5) assertEquals(0.25, t, 1e-4) else assertEquals(NEVER, t)
        }
    }

    @Test
    fun `a sphere in contact with a rising wall is hit again only after the wall has come back`() {
        val face = MovingFace(true, WallMotion.Sine(0.5, 1.0), 0.0).apply { begin(0.0, 0.0, 5.0) }
        val leaving = face.leaving(1e-3, 0.1)
        val at = 0.5 * StrictMath.sin(0.2 * Math.PI) + 1.0
        assertEquals(NEVER, face.contact(at, leaving, 1.0, 0.1))
        assertEquals(0.1, face.contact(at, leaving - 2e-3, 1.0, 0.1))
        // As fast as the wall, and the wall slows down: no contact before it has turned, moves up again and overtakes.
        assertTrue(face.contact(at, 0.0, 1.0, 0.4) > 1.0)
    }

    private companion object {
        const val MOMENTS = 300
        const val ROUNDING = 1e-9
    }
}
