package daphnis.core.collision

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ImageShear
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.PerSphereBoundary
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.initial.SeededRandom
import daphnis.core.population.MeanFlow
import daphnis.core.populationOf
import daphnis.core.space.Images
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Contacts and collisions are the same when the axes change places: images may slide along y across x as well. */
class AxesAlikeTest {
    private val lengths = doubleArrayOf(2.7, 2.3, 2.1)

    private fun box(order: IntArray) = Box.centred(lengths[order[0]], lengths[order[1]], lengths[order[2]])

    private class AlongY(override val box: Box) : PerSphereBoundary {
        override val shear = ImageShear(box, MeanFlow(normalAxis = 0, flowAxis = 1, rate = RATE))

        override fun contactFaces(axis: Int) = ContactFaces.PERIODIC
    }

    /** Two spheres, positions and velocities drawn by x, y, z and then taken in [order], each at its own local time. */
    private class Draw(private val v: DoubleArray, private val boxes: IntArray, private val order: IntArray) {
        val rows = StepRows().apply {
            load(populationOf(sphere(0), sphere(6)), intArrayOf(0, 1), 1.0, false)
            state[TIME] = v[12]
            state[STRIDE + TIME] = v[13]
        }
        val code = Images.code(boxes[order[0]], boxes[order[1]], boxes[order[2]])

        private fun sphere(k: Int): Sphere {
            val (x, y, z) = order.map { v[k + it] }
            val (vx, vy, vz) = order.map { v[k + 3 + it] }
            return Sphere(x, y, z, vx, vy, vz, r = 0.6, m = 1.0 + k)
        }

        /** Of both spheres after their collision at [time]: place and velocity by the x, y, z of the draw. */
        fun collided(images: Images, time: Double): List<Double> {
            CollisionLaw(ConstantRestitution(0.5)).collide(rows, 0, 1, code, images, time, CollisionOutcome())
            return List(12) { rows.state[it / 6 * STRIDE + it % 6 / 3 * 3 + order.indexOf(it % 3)] }
        }
    }

    private fun compare(order: IntArray, one: Images, other: Images) {
        val random = SeededRandom(3)
        var contacts = 0
        repeat(10_000) {
            val v = DoubleArray(14) { k -> if (k < 12) random.nextGaussian() else random.nextDouble() }
            val boxes = IntArray(3) { random.nextInt(3) - 1 }
            val a = Draw(v, boxes, intArrayOf(0, 1, 2))
            val b = Draw(v, boxes, order)
            val time = contactTime(a.rows, 0, 1, a.code, one)
            val same = contactTime(b.rows, 0, 1, b.code, other)
            if (time == NEVER || same == NEVER) {
                assertEquals(time, same)
                return@repeat
            }
            contacts++
            assertEquals(time, same, 1e-9 * time)
            val after = a.collided(one, time)
            val afterSame = b.collided(other, time)
            for (k in after.indices) assertEquals(after[k], afterSame[k], 1e-9 * (1 + time)) { "number $k of $after" }
        }
        assertTrue(contacts > 100) { "only $contacts contacts" }
    }

    private fun at(boundary: PerSphereBoundary) = Images().apply { prepare(boundary, 12.345) }

    @Test
    fun `in a periodic box, whichever way they are named`() {
        for (order in listOf(intArrayOf(1, 2, 0), intArrayOf(2, 0, 1), intArrayOf(0, 2, 1))) {
            compare(order, at(Periodic(box(intArrayOf(0, 1, 2)))), at(Periodic(box(order))))
        }
    }

    @Test
    fun `where images slide along x across y, or along y across x`() {
        val order = intArrayOf(1, 0, 2)
        compare(order, at(LeesEdwards(box(intArrayOf(0, 1, 2)), RATE)), at(AlongY(box(order))))
    }

    private companion object {
        const val RATE = 0.37
    }
}
