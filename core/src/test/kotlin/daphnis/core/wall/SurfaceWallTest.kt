package daphnis.core.wall

import daphnis.core.boundary.Box
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.NEVER
import daphnis.core.collision.StepRows
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.abs
import kotlin.math.sqrt

/** First contacts with planes, cylinders and spheres, against paths that are looked at in very many moments. */
class SurfaceWallTest {
    private class Case(seed: Long, falls: Boolean, moves: Boolean = true) {
        val random = SeededRandom(seed)
        val start = random.nextDouble(0.0, 1e3)
        val duration = Math.exp(random.nextDouble(-4.0, 1.5))
        val r = random.nextDouble(0.1, 0.5)
        val g = DoubleArray(3) { if (falls && random.nextInt(3) > 0) random.nextDouble(-2.0, 2.0) else 0.0 }
        private val mayMove = moves
        val surface = drawn()
        val origin = (surface as? PlaneWall)?.origin ?: (surface as RoundWall).origin
        val direction = (surface as? PlaneWall)?.direction ?: (surface as RoundWall).direction
        val x = DoubleArray(3)
        val v = DoubleArray(3) { random.nextGaussian() }

        init {
            // Some touch at once, or nearly.
            do {
                for (k in 0..2) x[k] = random.nextDouble(-3.0, 3.0)
            } while (surface.distance(x[0], x[1], x[2], start) < r)
            if (random.nextInt(3) == 0) touch()
        }

        private fun touch() {
            val to = DoubleArray(3) { random.nextDouble(-4.0, 4.0) }
            if (surface.distance(to[0], to[1], to[2], start) > r) return
            repeat(60) {
                val middle = DoubleArray(3) { (x[it] + to[it]) / 2 }
                val isFree = surface.distance(middle[0], middle[1], middle[2], start) >= r
                middle.copyInto(if (isFree) x else to)
            }
        }

        private fun vector() = List(3) { random.nextGaussian() }

        private fun drawn(): Wall {
            val side = RoomSide.entries[random.nextInt(2)]
            val motion = if (random.nextInt(2) == 0 || !mayMove) {
                null
            } else if (random.nextInt(2) == 0) {
                WallMotion.Steady(random.nextGaussian() / (start + 1))
            } else {
                WallMotion.Sine(random.nextDouble(0.0, 0.5), random.nextDouble(0.1, 3.0), random.nextDouble())
            }
            val c = vector().map { 0.2 * it }
            val axis = if (random.nextInt(2) == 0) vector() else List(3) { if (it == 1) -2.0 else 0.0 }
            return when (random.nextInt(3)) {
                0 -> PlaneWall(c, vector(), WallFace(motion = motion))
                1 -> CylinderWall(c, axis, random.nextDouble(1.0, 3.0), side)
                else -> SphereWall(
                    c,
                    random.nextDouble(1.0, 3.0),
                    side,
                    WallFace(motion = motion.takeIf { side == RoomSide.OUTSIDE }),
                    along = vector(),
                )
            }
        }

        val rows = StepRows().apply {
            fun column(value: Double) = doubleArrayOf(value)
            val one = Population(
                column(x[0]),
                column(x[1]),
                column(x[2]),
                column(v[0]),
                column(v[1]),
                column(v[2]),
                column(r),
                column(1.0),
            )
            load(one, intArrayOf(0), duration, tracksLastCollision = false)
        }
        val wall = WallContact().apply {
            val walls = Walls(Box.centred(99.0, 99.0, 99.0), surfaces = listOf(surface))
            prepare(walls.walls, CollisionLaw(ConstantRestitution(1.0), acceleration = g.toList()), start, duration)
        }

        /** The gap at the time [t] of the step, on the parabola. */
        fun gap(t: Double): Double {
            fun at(k: Int) = x[k] + v[k] * t - g[k] / 2 * t * (duration - t)
            return surface.distance(at(0), at(1), at(2), start + t) - r
        }
    }

    private fun passesOverNothing(count: Int, falls: Boolean): Int {
        var contacts = 0
        for (seed in 0L until count) {
            val c = Case(seed, falls)
            val t = c.wall.time(c.rows, 0, WallContact.FACES)
            assertTrue(t >= 0) { "seed $seed: $t" }
            val end = minOf(t, c.duration)
            for (k in 1 until MOMENTS) {
                val gap = c.gap(end * k / MOMENTS)
                assertTrue(gap > -ROUNDING) { "seed $seed: gap $gap before the contact at $t, ${c.surface}" }
            }
            if (t > c.duration) continue
            contacts++
            assertTrue(abs(c.gap(t)) < ROUNDING) { "seed $seed: gap ${c.gap(t)} at contact, ${c.surface}" }
            c.wall.reflect(c.rows, 0, WallContact.FACES, t, outcome)
            assertTrue(outcome.impactSpeed >= 0)
            val next = c.wall.time(c.rows, 0, WallContact.FACES)
            assertTrue(next > t) { "seed $seed: again at once, ${c.surface}" }
        }
        return contacts
    }

    private val outcome = CollisionOutcome()

    @Test
    fun `no contact is passed over, and at each the sphere touches the surface, and then leaves it`() {
        val straight = passesOverNothing(3_000, falls = false)
        val falling = passesOverNothing(3_000, falls = true)
        assertTrue(straight in 600..1_500) { "$straight contacts" }
        assertTrue(falling in 600..1_500) { "$falling contacts" }
    }

    @Test
    fun `times on straight paths are those of exact arithmetic`() {
        var contacts = 0
        for (seed in 0L until 1_000) {
            val c = Case(seed, falls = false, moves = false)
            val t = c.wall.time(c.rows, 0, WallContact.FACES)
            if (t > c.duration) continue
            contacts++
            val gap = exactGap(c, BigDecimal(t))
            val rate = (exactGap(c, BigDecimal(t + 1e-9)) - gap).toDouble() / 1e-9
            // The error of the time, from that of the gap; a grazing contact has a worse one.
            val scale = 4.0 + abs(t) * 3
            assertTrue(abs(gap.toDouble()) < 1e-14 * scale * scale) { "seed $seed: $gap, ${c.surface}" }
            assertTrue(rate < 1e-6) { "seed $seed: it leaves" }
        }
        assertTrue(contacts > 200) { "$contacts contacts" }
    }

    /** Distance at contact squared less that now, or distance of the plane; in either case 0 at contact. */
    private fun exactGap(c: Case, t: BigDecimal): BigDecimal {
        val digits = MathContext(60)
        fun big(x: Double) = BigDecimal(x)
        val q = List(3) { big(c.x[it]) + big(c.v[it]) * t - big(c.origin[it]) }
        val d = c.direction.map { big(it) }
        val along = q.indices.fold(BigDecimal.ZERO) { s, k -> s + q[k] * d[k] }
        if (c.surface is PlaneWall) return along - big(c.r)
        val p = List(3) { q[it] - along * d[it] }
        val square = p.fold(BigDecimal.ZERO) { s, it -> s + it * it }
        val isInside = (c.surface as RoundWall).side == RoomSide.INSIDE
        val reach = if (isInside) big(c.surface.radius) - big(c.r) else big(c.surface.radius) + big(c.r)
        return (if (isInside) reach * reach - square else square - reach * reach).round(digits)
    }

    @Test
    fun `a sphere that just hits a body, and one that just misses it`() {
        for ((aside, hits) in listOf(1.5 - 1e-9 to true, 1.5 + 1e-9 to false)) {
            val t = time(SphereWall(listOf(0.0, 0.0, 0.0), 1.0, RoomSide.OUTSIDE), -4.0, aside)
            if (hits) assertEquals(4.0, t, 1e-3) else assertEquals(NEVER, t)
            val around = CylinderWall(listOf(0.0, 0.0, 7.0), listOf(0.0, 0.0, 3.0), 1.0, RoomSide.OUTSIDE)
            val again = time(around, -4.0, aside)
            if (hits) assertEquals(4.0, again, 1e-3) else assertEquals(NEVER, again)
        }
        // Through the middle of a vessel, and along the axis of one.
        assertEquals(4.5, time(SphereWall(listOf(0.0, 0.0, 0.0), 3.0), -2.0, 0.0))
        val along = CylinderWall(listOf(0.0, 0.0, 0.0), listOf(1.0, 0.0, 0.0), 3.0)
        assertEquals(NEVER, time(along, -4.0, 0.3))
    }

    /** When a sphere of radius ½ at ([x], [y], 0) that moves along x with the speed 1 touches [surface]. */
    private fun time(surface: Wall, x: Double, y: Double): Double {
        val rows = StepRows()
        fun column(value: Double) = doubleArrayOf(value)
        val one = Population(
            column(x),
            column(y),
            column(0.0),
            column(1.0),
            column(0.0),
            column(0.0),
            column(0.5),
            column(1.0),
        )
        rows.load(one, intArrayOf(0), 100.0, tracksLastCollision = false)
        val wall = WallContact()
        val walls = Walls(Box.centred(99.0, 99.0, 99.0), surfaces = listOf(surface))
        wall.prepare(walls.walls, CollisionLaw(ConstantRestitution(1.0)), 0.0, 100.0)
        return wall.time(rows, 0, WallContact.FACES)
    }

    @Test
    fun `what a line of an epoch is told is never later than the contact`() {
        var compared = 0
        for (seed in 0L until 2_000) {
            val c = Case(seed, falls = true)
            val t = c.wall.time(c.rows, 0, WallContact.FACES)
            val wall = c.wall.within(c.duration).last()
            val soonest = wall.soonest(c.x[0], c.x[1], c.x[2], c.v[0], c.v[1], c.v[2], c.r + 1e-9)
            if (t <= c.duration) {
                compared++
                assertTrue(soonest <= t) { "seed $seed: $soonest, and the contact is at $t, ${c.surface}" }
            }
        }
        assertTrue(compared > 500)
    }

    @Test
    fun `elastic impacts keep energy, and at a cylinder and a sphere angular momentum`() {
        val contacts = IntArray(3)
        for (seed in 0L until 1_000) {
            val c = Case(seed, falls = false, moves = false)
            val t = c.wall.time(c.rows, 0, WallContact.FACES)
            if (t > c.duration) continue
            c.wall.reflect(c.rows, 0, WallContact.FACES, t, outcome)
            val s = c.rows.state
            val v = DoubleArray(3) { s[3 + it] }
            val before = c.v.sumOf { it * it }
            assertEquals(1.0, v.sumOf { it * it } / before, 1e-14)
            contacts[
                if (c.surface is PlaneWall) {
                    0
                } else if (c.direction.all { it == 0.0 }) {
                    1
                } else {
                    2
                },
            ]++
            if (c.surface is PlaneWall) continue
            val q = DoubleArray(3) { s[it] - c.origin[it] }
            val d = c.direction

            // L of the sphere, and its part along the axis of a cylinder.
            fun spin(u: DoubleArray) = doubleArrayOf(
                q[1] * u[2] - q[2] * u[1],
                q[2] * u[0] - q[0] * u[2],
                q[0] * u[1] - q[1] * u[0],
            )
            val then = spin(c.v)
            val now = spin(v)
            val isSphere = d.all { it == 0.0 }
            if (isSphere) {
                for (k in 0..2) assertEquals(then[k], now[k], 1e-13)
            } else {
                assertEquals((0..2).sumOf { then[it] * d[it] }, (0..2).sumOf { now[it] * d[it] }, 1e-13)
            }
            val speed = sqrt(before)
            assertTrue(outcome.impactSpeed <= speed * (1 + 1e-15))
        }
        assertTrue(contacts.all { it > 20 }) { "contacts with planes, spheres and cylinders: ${contacts.toList()}" }
    }

    private companion object {
        const val MOMENTS = 300
        const val ROUNDING = 1e-9
    }
}
