package daphnis.core.boundary

import daphnis.core.population.MeanFlow
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Where images stand and how they move, worked out by hand. */
class ImagesTest {
    private val box = Box(0.0, 0.0, 0.0, 10.0, 8.0, 6.0)
    private val code = Images.code(2, -1, 3)

    private fun images(boundary: BoundaryConditions, time: Double) = Images().apply { prepare(boundary, time) }

    @Test
    fun `images that stand still are whole boxes away`() {
        val images = images(Periodic(box), 7.0)
        assertEquals(listOf(20.0, -8.0, 18.0), (0..2).map { images.shift(code, it) })
        assertEquals(listOf(10.0, 8.0, 6.0), (0..2).map { images.period(it) })
        assertEquals(listOf(-1, -1, 0.0, 0.0), images.slides())
        for (axis in 0..2) assertEquals(0.0, images.slide(code, axis)) { "axis $axis" }
    }

    private fun Images.slides() = listOf(normalAxis, slideAxis, shearVelocity, shearOffset)

    @Test
    fun `images that slide do so along x, by what has built up across y`() {
        // 0.25 · 8 = 2 per unit of time, 14 in 7: 4 beyond one length of 10. The image is one box down.
        val images = images(LeesEdwards(box, 0.25), 7.0)
        assertEquals(listOf(1, 0, 2.0, 4.0), images.slides())
        assertEquals(listOf(16.0, -8.0, 18.0), (0..2).map { images.shift(code, it) })
        assertEquals(listOf(-2.0, 0.0, 0.0), (0..2).map { images.slide(code, it) })
        for (axis in 0..2) assertEquals(listOf(0.0, 0.0), listOf(images.shift(0, axis), images.slide(0, axis)))
        // Nothing is left of it when the next boundary stands still.
        images.prepare(Periodic(box), 7.0)
        assertEquals(listOf(20.0, 0.0), listOf(images.shift(code, 0), images.slide(code, 0)))
    }

    @Test
    fun `an axis without images has no period and no displacement`() {
        for (axis in 0..2) {
            val images = images(Periodic(box, axis != 0, axis != 1, axis != 2), 0.0)
            val expected = List(3) { if (it == axis) 0.0 else box.length(it) }
            assertEquals(expected, (0..2).map { images.period(it) })
            val d = doubleArrayOf(100.0, 100.0, 100.0)
            images.toNearest(d)
            // 100 is ten tens, four more than twelve eights, and two less than seventeen sixes.
            val near = listOf(0.0, 4.0, -2.0)
            assertEquals(List(3) { if (it == axis) 100.0 else near[it] }, d.toList())
        }
    }

    @Test
    fun `turns and offset make up the whole slide`() {
        for (rate in listOf(0.25, -0.25)) {
            val shear = ImageShear(box, MeanFlow(normalAxis = 1, flowAxis = 0, rate = rate))
            val slid = 14.0 * if (rate > 0) 1 else -1
            assertEquals(if (rate > 0) 1.0 else -2.0, shear.turns(7.0)) { "rate $rate" }
            assertEquals(slid, shear.turns(7.0) * 10 + shear.offset(7.0)) { "rate $rate" }
        }
    }
}
