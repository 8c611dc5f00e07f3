package daphnis.core.collision

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.initial.SeededRandom
import daphnis.core.populationOf
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Cases worked out by hand, in pairs: one that hits, one that just misses. */
class ContactTest {
    private val images = Images().apply { prepare(Open, 0.0) }

    private fun rows(vararg s: Sphere) = StepRows().apply { load(populationOf(*s), IntArray(s.size) { it }, 1.0, true) }

    private fun time(a: Sphere, b: Sphere) = contactTime(rows(a, b), 0, 1, 0, images)

    @Test
    fun `head on, surfaces 8 apart at closing speed 20 touch after 0_4`() {
        assertEquals(0.4, time(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, vx = -10.0)), 1e-15)
    }

    @Test
    fun `one that stands is hit by the other`() {
        assertEquals(3.0, time(Sphere(), Sphere(x = 5.0, vx = -1.0)), 1e-15)
    }

    @Test
    fun `receding spheres never touch`() {
        assertEquals(NEVER, time(Sphere(x = -5.0, vx = -10.0), Sphere(x = 5.0, vx = 10.0)))
    }

    @Test
    fun `the same velocity never touches`() {
        assertEquals(NEVER, time(Sphere(x = -5.0, vx = 1.0), Sphere(x = 5.0, vx = 1.0)))
    }

    @Test
    fun `off centre by 1_2 the contact is where Pythagoras puts it`() {
        // Contact when the distance along x is √(2² − 1.2²) = 1.6.
        assertEquals(8.4 / 20, time(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, y = 1.2, vx = -10.0)), 1e-15)
    }

    @Test
    fun `off centre by just under a diameter hits, by just over misses`() {
        assertTrue(time(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, y = 2.0 - 1e-9, vx = -10.0)) < 0.5)
        assertEquals(NEVER, time(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, y = 2.0 + 1e-9, vx = -10.0)))
    }

    @Test
    fun `grazing within round-off gives a time or never, no NaN`() {
        for (impact in listOf(2.0 * (1 - 1e-15), 2.0, 2.0 * (1 + 1e-15), Math.nextDown(2.0), Math.nextUp(2.0))) {
            val t = time(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, y = impact, vx = -10.0))
            assertTrue(t == NEVER || Math.abs(t - 0.5) < 1e-6) { "impact parameter $impact gives $t" }
        }
    }

    @Test
    fun `overlapping and approaching touch at once, overlapping and receding never`() {
        assertEquals(0.0, time(Sphere(vx = 1.0), Sphere(x = 1.5)))
        assertEquals(NEVER, time(Sphere(vx = -1.0), Sphere(x = 1.5)))
    }

    @Test
    fun `a sphere with a later local time is met where it is then`() {
        // The second stands at x = 5 since t = 1; the first started at −5 with speed 2 at t = 0 and reaches 3 at t = 4.
        val rows = rows(Sphere(x = -5.0, vx = 2.0), Sphere(x = 5.0))
        rows.state[StepRows.STRIDE + StepRows.TIME] = 1.0
        assertEquals(4.0, contactTime(rows, 0, 1, 0, images), 1e-15)
    }

    @Test
    fun `through a periodic face the image is met, not the original`() {
        val periodic = Images().apply { prepare(Periodic(Box.centred(12.0, 12.0, 12.0)), 0.0) }
        val rows = rows(Sphere(x = 5.0, vx = 1.0, r = 0.5), Sphere(x = -5.0, r = 0.5))
        assertEquals(1.0, contactTime(rows, 0, 1, Images.code(1, 0, 0), periodic), 1e-15)
        assertEquals(NEVER, contactTime(rows, 0, 1, 0, periodic))
    }

    @Test
    fun `a sliding image is met where it has slid to`() {
        // L_y = 10, shear rate 0.5: the image of the second stands at y = −4 + 10, slides with 5 along x, and has slid
        // by 1 at t = 0.2.
        val box = Box.centred(100.0, 10.0, 10.0)
        val sliding = Images().apply { prepare(LeesEdwards(box, 0.5), 0.2) }
        val rows = rows(Sphere(y = 4.0, r = 0.5), Sphere(x = -5.0, y = -5.5, r = 0.5, vx = 0.0))
        // Image: y = 4.5, x = −5 + 1 + 5 s. Off centre by 0.5, contact at √(1 − 0.25) along x before the centre.
        val s = (4.0 - Math.sqrt(0.75)) / 5
        assertEquals(s, contactTime(rows, 0, 1, Images.code(0, 1, 0), sliding), 1e-14)
    }

    @Test
    fun `the time is the same to the last bit from either side`() {
        val random = SeededRandom(7)
        val sliding = Images().apply { prepare(LeesEdwards(Box.centred(2.7, 2.3, 2.1), 0.37), 12.345) }
        var contacts = 0
        repeat(20_000) {
            fun draw() = Sphere(
                random.nextGaussian(),
                random.nextGaussian(),
                random.nextGaussian(),
                random.nextGaussian(),
                random.nextGaussian(),
                random.nextGaussian(),
                0.1 + random.nextDouble(),
            )
            val rows = rows(draw(), draw())
            rows.state[StepRows.TIME] = random.nextDouble()
            rows.state[StepRows.STRIDE + StepRows.TIME] = random.nextDouble()
            val code = Images.code(random.nextInt(3) - 1, random.nextInt(3) - 1, random.nextInt(3) - 1)
            val there = contactTime(rows, 0, 1, code, sliding)
            val back = contactTime(rows, 1, 0, Images.negated(code), sliding)
            assertEquals(there.toRawBits(), back.toRawBits())
            if (there != NEVER) contacts++
        }
        assertTrue(contacts > 500) { "only $contacts contacts were drawn" }
    }

    @Test
    fun `the soonest contact is the contact, and at once where they overlap, whether they approach or not`() {
        val sliding = Images().apply { prepare(LeesEdwards(Box.centred(8.0, 8.0, 8.0), 0.5), 0.3) }
        val code = Images.code(1, 1, 0)
        fun soonest(a: Sphere, b: Sphere, image: Int = 0, at: Double = 0.0): Pair<Double, Double> {
            val rows = rows(a, b)
            rows.state[StepRows.TIME] = at
            val s = rows.state
            return soonestContact(s, 0, s, StepRows.STRIDE, image, sliding) to contactTime(rows, 0, 1, image, sliding)
        }
        assertEquals(3.0, soonest(Sphere(), Sphere(x = 5.0, vx = -1.0)).first, 1e-15)
        assertEquals(NEVER, soonest(Sphere(), Sphere(x = 5.0, vx = 1.0)).first)
        assertEquals(NEVER to NEVER, soonest(Sphere(x = 0.1, vx = -1.0), Sphere(x = 2.2)))
        assertEquals(0.0 to NEVER, soonest(Sphere(x = 0.2, vx = -1.0), Sphere(x = 2.1)))
        // The second has come nearer until the local time of the first, and its image slides on.
        val displaced = sliding.shift(code, 0) + 0.25 * sliding.slide(code, 0)
        for ((gap, time) in listOf(-1e-9 to 0.25, 1e-9 to NEVER)) {
            val other = Sphere(x = 2.0 + gap - displaced + 0.25, y = -sliding.shift(code, 1), vx = -1.0)
            val own = Sphere(vx = -2.0 + sliding.slide(code, 0))
            assertEquals(time to NEVER, soonest(own, other, code, 0.25)) { "$gap" }
        }
    }
}
