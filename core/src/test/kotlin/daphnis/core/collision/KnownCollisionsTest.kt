package daphnis.core.collision

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Collisions worked out by hand in three dimensions, through whole steps: what comes out, not how it is reached. */
class KnownCollisionsTest {
    private fun step(p: Population, boundary: BoundaryConditions, dt: Double, e: Double): CollisionForcing {
        val forcing = CollisionForcing(ConstantRestitution(e), recordCollisions = true)
        Simulation(p, boundary, forcing, FixedTimeStep(dt)).advance()
        return forcing
    }

    private fun Population.placeOf(id: Int) = indexOf(id).let { doubleArrayOf(x[it], y[it], z[it]) }

    private fun Population.velocityOf(id: Int) = indexOf(id).let { doubleArrayOf(vx[it], vy[it], vz[it]) }

    private fun assertNear(expected: DoubleArray, actual: DoubleArray, story: String) {
        for (axis in 0..2) assertEquals(expected[axis], actual[axis], 1e-13) { "$story, ${"xyz"[axis]}" }
    }

    /** [v] with x, y, z moved on by [turn] axes. */
    private fun turned(turn: Int, vararg v: Double) = DoubleArray(3) { v[(it + 3 - turn) % 3] }

    private fun sphere(x: DoubleArray, v: DoubleArray, r: Double, m: Double) =
        Sphere(x[0], x[1], x[2], v[0], v[1], v[2], r, m)

    /*
     * The first stands in the origin, the second comes from (0, 5, 4) with (1, −3, −2). After 1 it is at (1, 2, 2), 3
     * away, the sum of the radii. The normal is (1, 2, 2)/3, the impact speed 9/3 = 3, the reduced mass 2/3, and with
     * ε = 1/2 the impulse 1.5 · 3 · 2/3 = 3: −3 n for the first, of mass 1, and 1.5 n for the second, of mass 2.
     */
    private val after1 = doubleArrayOf(-1.0, -2.0, -2.0)
    private val after2 = doubleArrayOf(1.5, -2.0, -1.0)

    @Test
    fun `an oblique collision of unequal spheres, along every axis, in a box and through its faces`() {
        for (turn in 0..2) {
            oblique(turn, Open, DoubleArray(3))
            for (across in 0..2) {
                // Near a face, so that the second is on its other side, or the first is.
                for (at in listOf(-14.9, 14.9)) oblique(turn, cube, DoubleArray(3) { if (it == across) at else 0.0 })
            }
        }
    }

    /** The collision with the first at [origin], all axes moved on by [turn]. */
    private fun oblique(turn: Int, boundary: BoundaryConditions, origin: DoubleArray) {
        val story = "turn $turn, from ${origin.asList()}"
        val second = turned(turn, 0.0, 5.0, 4.0).also { for (axis in 0..2) it[axis] += origin[axis] }
        val velocity = turned(turn, 1.0, -3.0, -2.0)
        val p = populationOf(sphere(origin, DoubleArray(3), 2.0, 1.0), sphere(second, velocity, 1.0, 2.0))
        boundary.endStep(p, 0.0)
        val record = step(p, boundary, 2.0, 0.5).record!!
        assertNear(turned(turn, after1[0], after1[1], after1[2]), p.velocityOf(0), story)
        assertNear(turned(turn, after2[0], after2[1], after2[2]), p.velocityOf(1), story)
        val apart = DoubleArray(3) { p.placeOf(1)[it] - p.placeOf(0)[it] }
        if (boundary === cube) for (axis in 0..2) apart[axis] -= 30 * Math.rint(apart[axis] / 30)
        assertNear(turned(turn, 3.5, 2.0, 3.0), apart, story)
        assertEquals(listOf(1.0, 3.0), listOf(record.time[0], record.impulse(0)).map { Math.rint(it * 1e12) / 1e12 })
        assertEquals(1, record.size) { story }
        assertNear(turned(turn, 1.0, 2.0, 2.0), DoubleArray(3) { record.separation(0, it) }, story)
    }

    private val cube = Periodic(Box.centred(30.0, 30.0, 30.0))

    @Test
    fun `through a sliding face the other's velocity is that of its image`() {
        // The image above y slides by 0.2 · 30 = 6 per unit of time, and has slid by 6 when they meet at t = 1.
        val boundary = LeesEdwards(Box.centred(30.0, 30.0, 30.0), 0.2)
        val p = populationOf(
            Sphere(y = 14.0, r = 2.0),
            Sphere(x = 0.0, y = 14.0 + 5 - 30, z = 4.0, vx = 1.0 - 6, vy = -3.0, vz = -2.0, m = 2.0),
        )
        step(p, boundary, 1.5, 0.5)
        assertNear(after1, p.velocityOf(0), "first")
        assertNear(doubleArrayOf(after2[0] - 6, after2[1], after2[2]), p.velocityOf(1), "second")
    }

    @Test
    fun `a wall is reached by the surface, on each of its six sides, and takes its part of the speed`() {
        val box = Box(0.0, 0.0, 0.0, 10.0, 8.0, 6.0)
        for (axis in 0..2) {
            for (sign in listOf(-1.0, 1.0)) {
                val v = DoubleArray(3) { if (it == axis) 2 * sign else 0.125 }
                val start = doubleArrayOf(4.0, 3.0, 2.0)
                val p = populationOf(sphere(start, v, 0.5, 1.0))
                val forcing = step(p, Walls(box, 0.5), 4.0, 1.0)
                val gap = if (sign > 0) box.upper(axis) - start[axis] - 0.5 else start[axis] - 0.5
                val wall = if (sign > 0) box.upper(axis) - 0.5 else 0.5
                val expected = DoubleArray(3) {
                    if (it == axis) wall - sign * (4.0 - gap / 2) else start[it] + 4 * 0.125
                }
                assertNear(expected, p.placeOf(0), "axis $axis, $sign")
                assertEquals(-sign, p.velocityOf(0)[axis])
                assertEquals(1L, forcing.counters.wallCollisions)
            }
        }
    }

    @Test
    fun `what stands in a wall turns back at once if it moves outward, and is left alone if it does not`() {
        val box = Box(0.0, 0.0, 0.0, 10.0, 8.0, 6.0)
        for ((speed, expected) in listOf(-1.0 to 1.0, 1.0 to 1.0, 0.0 to 0.0)) {
            val p = populationOf(Sphere(x = 0.25, y = 4.0, z = 3.0, vx = speed, r = 0.5))
            step(p, Walls(box), 1.0, 1.0)
            assertEquals(0.25 + expected, p.x[0], 1e-15) { "speed $speed" }
            assertEquals(expected, p.vx[0]) { "speed $speed" }
        }
    }

    @Test
    fun `guards look at less than their limit, of either sphere`() {
        val floor = FloorSpeedGuard(0.5)
        assertEquals(listOf(true, false), listOf(0.49, 0.5).map { floor.makesElastic(it, 0.0, 0.0) })
        val duration = ContactDurationGuard(0.5)
        assertEquals(listOf(true, false), listOf(0.49, 0.5).map { duration.makesElastic(9.0, it, 1.0) })
        assertEquals(listOf(true, false), listOf(0.49, 0.5).map { duration.makesElastic(9.0, 1.0, it) })
        assertFalse(NoGuard.makesElastic(0.0, 0.0, 0.0) || NoGuard.needsLastCollision || floor.needsLastCollision)
        assertTrue(duration.needsLastCollision)
    }
}
