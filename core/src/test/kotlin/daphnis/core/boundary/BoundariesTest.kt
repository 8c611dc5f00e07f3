package daphnis.core.boundary

import daphnis.core.Sphere
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import daphnis.core.populationOf
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class BoundariesTest {
    private val box = Box.centred(10.0, 8.0, 6.0)

    @Test
    fun `a periodic box wraps each axis once or many times`() {
        val p = populationOf(Sphere(x = 5.5, y = -4.25, z = 2.0), Sphere(x = -36.0, y = 4.0, z = 15.0))
        Periodic(box).endStep(p, 1.0)
        assertEquals(listOf(-4.5, 3.75, 2.0), listOf(p.x[0], p.y[0], p.z[0]))
        assertEquals(listOf(4.0, -4.0, -3.0), listOf(p.x[1], p.y[1], p.z[1]))
    }

    @Test
    fun `open axes of a periodic box are left alone`() {
        val p = populationOf(Sphere(x = 5.5, z = 77.0))
        Periodic(box, periodicZ = false).endStep(p, 1.0)
        assertEquals(-4.5, p.x[0])
        assertEquals(77.0, p.z[0])
    }

    @Test
    fun `the paper's box changes the x velocity at the y faces, against the flow, without an offset`() {
        val p =
            populationOf(
                Sphere(x = 1.0, y = 4.5, vx = 0.3),
                Sphere(x = 1.0, y = -4.5, vx = 0.3),
                Sphere(x = 5.5, vx = 0.3),
            )
        ShearedPeriodic(box, 0.1).endStep(p, 7.0)
        assertEquals(listOf(-3.5, 3.5, 0.0), p.y.toList())
        assertEquals(listOf(1.0, 1.0, -4.5), p.x.toList())
        assertEquals(0.2, p.vx[0], 1e-15)
        assertEquals(0.4, p.vx[1], 1e-15)
        assertEquals(0.3, p.vx[2])
    }

    @Test
    fun `Lees and Edwards shift by the offset of the time as well`() {
        // γ L_y = 4; at t = 0.75 the images have slid by 3, at t = 3 by 12 ≡ 2 (mod 10).
        for ((time, offset) in listOf(0.75 to 3.0, 3.0 to 2.0)) {
            val p = populationOf(Sphere(x = 4.0, y = 4.5, vx = 1.0), Sphere(x = 4.0, y = -4.5, vx = 1.0))
            LeesEdwards(box, 0.5).endStep(p, time)
            assertEquals(4.0 - offset, p.x[0], 1e-14)
            assertEquals(4.0 + offset - 10, p.x[1], 1e-14)
            assertEquals(listOf(-3.0, 5.0), p.vx.toList())
        }
    }

    @Test
    fun `a negative shear rate mirrors everything`() {
        val shear = LeesEdwards(box, -0.5).shear
        assertEquals(-4.0, shear.velocity)
        assertEquals(7.0, shear.offset(0.75), 1e-14)
    }

    @Test
    fun `boxes crossed are counted by axis, upward positive`() {
        val p = populationOf(Sphere(x = 5.5, y = -4.25, z = 2.0), Sphere(x = -36.0, y = 4.0, z = 15.0), Sphere())
        Periodic(box).endStep(p, 1.0)
        assertEquals(listOf(1, -1, 0, -4, 1, 3, 0, 0, 0), crossed(p))
        Periodic(box).endStep(p, 2.0)
        assertEquals(listOf(1, -1, 0, -4, 1, 3, 0, 0, 0), crossed(p)) { "nothing crossed in the second step" }
        for (boundary in listOf(ShearedPeriodic(box, 0.1), Walls(box, walled = booleanArrayOf(false, false, false)))) {
            val q = populationOf(Sphere(x = 5.5, y = -4.25, z = 15.0))
            boundary.endStep(q, 1.0)
            assertEquals(listOf(1, -1, 3), crossed(q))
        }
    }

    private fun crossed(p: Population) = (0 until p.size).flatMap { id -> (0..2).map { p.boxesCrossed(id, it) } }

    @Test
    fun `image codes name boxes, and negate exactly`() {
        for (x in listOf(-127, -1, 0, 1, 127)) {
            for (y in listOf(-3, 0, 2)) {
                val code = Images.code(x, y, -y)
                assertEquals(listOf(x, y, -y), (0..2).map { Images.component(code, it) })
                assertEquals(listOf(-x, -y, y), (0..2).map { Images.component(Images.negated(code), it) })
            }
        }
        val images = Images().apply { prepare(LeesEdwards(box, 0.37), 1.234) }
        val code = Images.code(2, -1, 1)
        for (axis in 0..2) {
            assertEquals(-images.shift(code, axis), images.shift(Images.negated(code), axis))
            assertEquals(-images.slide(code, axis) + 0.0, images.slide(Images.negated(code), axis) + 0.0)
        }
    }

    @Test
    fun `images that cannot slide so are refused`() {
        for ((normal, flow) in listOf(0 to 2, 1 to 2, 0 to 0, 1 to 1)) {
            assertThrows(IllegalArgumentException::class.java) { ImageShear(box, MeanFlow(normal, flow, 0.5)) }
        }
        // Across z as well: the search takes any normal axis.
        assertEquals(3.0, ImageShear(box, MeanFlow(normalAxis = 2, flowAxis = 1, rate = 0.5)).velocity)
    }

    @Test
    fun `boxes that are none are refused`() {
        assertThrows(IllegalArgumentException::class.java) { Box(0.0, 0.0, 0.0, 1.0, 0.0, 1.0) }
        assertThrows(IllegalArgumentException::class.java) { Periodic(Box.UNBOUNDED) }
        assertThrows(IllegalArgumentException::class.java) { Walls(box, 1.5) }
    }
}
