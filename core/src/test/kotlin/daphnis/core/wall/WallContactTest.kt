package daphnis.core.wall

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Open
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.KnownCollisionsTest
import daphnis.core.collision.NEVER
import daphnis.core.collision.StepRows
import daphnis.core.populationOf
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Times of contact with walls, asked directly; whole steps are in [KnownCollisionsTest]. */
class WallContactTest {
    private val box = Box(0.0, 1.0, 0.0, 10.0, 8.0, 6.0)

    private val law = CollisionLaw(ConstantRestitution(1.0))

    private fun walls(e: Double, vararg walled: Boolean) = WallContact().apply {
        prepare(Walls(box, e, walled).walls, law)
    }

    /** In slot 1, behind one that is elsewhere. */
    private fun rows(s: Sphere) = StepRows().apply {
        val other = Sphere(x = 5.0, y = 5.0, z = 5.0, vx = 9.0, vy = 9.0, vz = 9.0)
        load(populationOf(other, s), intArrayOf(0, 1), 1.0, false)
    }

    @Test
    fun `partners are numbered downward from -1, and lead back to their faces`() {
        val partners = (0 until WallContact.FACES).map { WallContact.partner(it) }
        assertEquals(listOf(-1, -2, -3, -4, -5, -6), partners)
        assertEquals(listOf(0, 1, 2, 3, 4, 5), partners.map { WallContact.number(it) })
    }

    @Test
    fun `there are walls while the boundary of the step has any`() {
        val contact = WallContact()
        val rows = rows(Sphere(x = 4.0, y = 4.0, z = 2.0, vx = 2.0, vy = 2.0, vz = 2.0))

        fun reached() = (0 until WallContact.FACES).filter { contact.time(rows, 1, it) < NEVER }
        assertEquals(emptyList<Int>(), reached())
        for (axis in 0..2) {
            contact.prepare(Walls(box, walled = BooleanArray(3) { it == axis }).walls, law)
            assertEquals(listOf(2 * axis + 1), reached())
            contact.prepare(Open.walls, law)
            assertEquals(emptyList<Int>(), reached())
        }
    }

    @Test
    fun `the time counts from the local time of the sphere, to the face it moves to`() {
        val rows = rows(Sphere(x = 4.0, y = 4.0, z = 2.0, vx = 2.0, vy = -0.5, vz = 0.25, r = 0.5))
        rows.state[StepRows.STRIDE + StepRows.TIME] = 0.25
        val all = walls(1.0, true, true, true)
        val expected = listOf(NEVER, 0.25 + 2.75, 0.25 + 5.0, NEVER, NEVER, 0.25 + 14.0)
        assertEquals(expected, (0..5).map { all.time(rows, 1, it) })
        val floor = walls(1.0, false, true, false)
        assertEquals(listOf(NEVER, NEVER, 5.25, NEVER, NEVER, NEVER), (0..5).map { floor.time(rows, 1, it) })
    }

    @Test
    fun `what touches a wall meets it at once if it moves outward, and never if it stands`() {
        for ((v, expected) in listOf(-1.0 to 0.0, 0.0 to NEVER, 1.0 to NEVER)) {
            for (x in listOf(0.5, 0.25)) {
                val rows = rows(Sphere(x = x, vx = v, r = 0.5))
                assertEquals(expected, walls(1.0, true, true, true).time(rows, 1, 0)) { "at $x with $v" }
            }
        }
    }

    @Test
    fun `a wall that takes all leaves no sign`() {
        for (v in listOf(-1.0, 1.0)) {
            val rows = rows(Sphere(vy = v))
            walls(0.0, true, true, true).reflect(rows, 1, if (v < 0) 2 else 3, 0.5, CollisionOutcome())
            val p = StepRows.STRIDE
            assertEquals(0.0.toRawBits(), rows.state[p + StepRows.VX + 1].toRawBits()) { "$v" }
            assertEquals(listOf(0.5 * v, 0.5), listOf(rows.state[p + 1], rows.state[p + StepRows.TIME]))
        }
    }
}
