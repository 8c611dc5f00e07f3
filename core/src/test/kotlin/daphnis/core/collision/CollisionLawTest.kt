package daphnis.core.collision

import daphnis.core.Sphere
import daphnis.core.boundary.Open
import daphnis.core.boundary.prepare
import daphnis.core.populationOf
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class CollisionLawTest {
    private val images = Images().apply { prepare(Open, 0.0) }

    private val outcome = CollisionOutcome()

    private fun rows(vararg s: Sphere) = StepRows().apply { load(populationOf(*s), IntArray(s.size) { it }, 1.0, true) }

    private fun StepRows.vx(slot: Int) = state[slot * StepRows.STRIDE + StepRows.VX]

    private fun StepRows.vy(slot: Int) = state[slot * StepRows.STRIDE + StepRows.VX + 1]

    @Test
    fun `equal spheres exchange velocities in an elastic head-on collision`() {
        val rows = rows(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, vx = -10.0))
        val law = CollisionLaw(ConstantRestitution(1.0))
        assertTrue(law.collide(rows, 0, 1, 0, images, 0.4, outcome))
        assertEquals(-10.0, rows.vx(0), 1e-15)
        assertEquals(10.0, rows.vx(1), 1e-15)
        assertEquals(20.0, outcome.impactSpeed, 1e-15)
        assertEquals(20.0, outcome.impulse, 1e-14)
        assertEquals(0.4, rows.state[StepRows.TIME])
        assertEquals(-1.0, rows.state[0], 1e-15)
    }

    @Test
    fun `with coefficient a half they part at half the speed`() {
        val rows = rows(Sphere(x = -5.0, vx = 10.0), Sphere(x = 5.0, vx = -10.0))
        CollisionLaw(ConstantRestitution(0.5)).collide(rows, 0, 1, 0, images, 0.4, outcome)
        assertEquals(10.0, rows.vx(1) - rows.vx(0), 1e-14)
    }

    @Test
    fun `a heavy sphere hardly notices a light one`() {
        // Mass 3 at speed 4 hits mass 1 at rest: 4·(3 − 1)/4 = 2 and 2·3·4/4 = 6.
        val rows = rows(Sphere(vx = 4.0, m = 3.0), Sphere(x = 2.0))
        CollisionLaw(ConstantRestitution(1.0)).collide(rows, 0, 1, 0, images, 0.0, outcome)
        assertEquals(2.0, rows.vx(0), 1e-15)
        assertEquals(6.0, rows.vx(1), 1e-15)
    }

    @Test
    fun `only the velocity along the line of centres changes`() {
        val rows = rows(Sphere(vx = 1.0, vy = 7.0), Sphere(x = 2.0, vy = -3.0))
        CollisionLaw(ConstantRestitution(0.3)).collide(rows, 0, 1, 0, images, 0.0, outcome)
        assertEquals(7.0, rows.vy(0))
        assertEquals(-3.0, rows.vy(1))
        assertEquals(0.35, rows.vx(0), 1e-15)
        assertEquals(0.65, rows.vx(1), 1e-15)
    }

    @Test
    fun `receding spheres are left alone`() {
        val rows = rows(Sphere(vx = -1.0), Sphere(x = 2.0))
        assertFalse(CollisionLaw(ConstantRestitution(0.3)).collide(rows, 0, 1, 0, images, 0.0, outcome))
        assertEquals(-1.0, rows.vx(0))
    }

    @Test
    fun `the floor speed makes slow collisions elastic, and only slow ones`() {
        for ((speed, guarded) in listOf(0.0099 to true, 0.0101 to false)) {
            val rows = rows(Sphere(vx = speed), Sphere(x = 2.0))
            val law = CollisionLaw(ConstantRestitution(0.5), FloorSpeedGuard(0.01))
            law.collide(rows, 0, 1, 0, images, 0.0, outcome)
            assertEquals(guarded, outcome.guarded)
            assertEquals(if (guarded) 1.0 else 0.5, outcome.coefficient)
        }
    }

    @Test
    fun `the TC rule makes a collision elastic soon after another of either sphere, and not later`() {
        for ((before, guarded) in listOf(-0.09 to true, -0.11 to false, Double.NEGATIVE_INFINITY to false)) {
            val rows = rows(Sphere(vx = 1.0), Sphere(x = 2.0))
            rows.lastCollision[1] = before
            val law = CollisionLaw(ConstantRestitution(0.5), ContactDurationGuard(0.1))
            law.collide(rows, 0, 1, 0, images, 0.0, outcome)
            assertEquals(guarded, outcome.guarded) { "last collision at $before" }
            assertEquals(0.0, rows.lastCollision[0])
        }
    }

    @Test
    fun `a component that no impulse changes has no sign of zero`() {
        for (axis in 0..2) {
            fun along(v: Double) = DoubleArray(3) { if (it == axis) v else -0.0 }
            val x = along(2.0)
            val v = along(1.0)
            val rest = along(0.0)
            val rows = rows(
                Sphere(vx = v[0], vy = v[1], vz = v[2]),
                Sphere(x[0], x[1], x[2], rest[0], rest[1], rest[2]),
            )
            CollisionLaw(ConstantRestitution(1.0)).collide(rows, 0, 1, 0, images, 0.0, outcome)
            for (slot in 0..1) {
                for (k in 0..2) {
                    val expected = if (slot == 1 && k == axis) 1.0 else 0.0
                    val u = rows.state[slot * StepRows.STRIDE + StepRows.VX + k]
                    assertEquals(expected.toRawBits(), u.toRawBits()) { "along $axis, slot $slot, component $k" }
                }
            }
        }
    }
}
