package daphnis.core.search

import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.parallel.InlineLoop
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

class GridExtentTest {
    /** Periodic along x and y, from −2 to 8 and from 0 to 20. */
    private val boundary = Periodic(Box(-2.0, 0.0, -1.0, 8.0, 20.0, 1.0), true, true, false)

    private fun measured(middle: Double, vararg x: Double) = GridExtent().apply {
        val p = populationOf(*x.map { Sphere(x = it, y = 3.0, z = 5.0 - it) }.toTypedArray())
        measure(p, boundary, doubleArrayOf(middle, Double.NaN, Double.NaN), InlineLoop)
    }

    private fun GridExtent.hold(from: List<Double>, size: List<Double>, spanFrom: List<Double>, span: List<Double>) {
        val pairs = listOf(from to this.from, size to this.size, spanFrom to this.spanFrom, span to this.span)
        for ((wanted, found) in pairs) {
            for (axis in 0..2) assertEquals(wanted[axis], found[axis], 1e-14) { "axis $axis of ${found.toList()}" }
        }
    }

    @Test
    fun `the box along periodic axes, the spheres along others`() {
        val extent = measured(Double.NaN, 1.0, 4.0)
        extent.hold(listOf(-2.0, 0.0, 1.0), listOf(10.0, 20.0, 3.0), listOf(-2.0, 0.0, 1.0), listOf(10.0, 20.0, 3.0))
        val none = measured(1.0)
        none.hold(listOf(-2.0, 0.0, 0.0), listOf(10.0, 20.0, 0.0), listOf(-2.0, 0.0, 0.0), listOf(10.0, 20.0, 0.0))
    }

    @Test
    fun `the part around the middle in which spheres lie, across a face too, unless it is nearly all`() {
        // From 7 across the face at 8 to the image of −1 at 9; z goes with x.
        val across = measured(8.5, 7.0, -1.0)
        across.hold(listOf(-2.0, 0.0, -2.0), listOf(10.0, 20.0, 8.0), listOf(7.0, 0.0, -2.0), listOf(2.0, 20.0, 8.0))
        // Seen from the other side the same part is one box lower.
        assertEquals(listOf(-3.0, 2.0), measured(-1.5, 7.0, -1.0).let { listOf(it.spanFrom[0], it.span[0]) })
        assertEquals(listOf(1.0, 3.0), measured(2.0, 4.0, 1.0).let { listOf(it.spanFrom[0], it.span[0]) })
        // A sphere beyond a face counts as on it.
        assertEquals(listOf(7.0, 1.0), measured(7.5, 7.0, 8.3).let { listOf(it.spanFrom[0], it.span[0]) })
        assertEquals(listOf(-2.0, 1.0), measured(-1.0, -2.5, -1.0).let { listOf(it.spanFrom[0], it.span[0]) })
        // Nine tenths are worth a part, more are not.
        assertEquals(listOf(-1.5, 9.0), measured(3.0, -1.5, 7.5).let { listOf(it.spanFrom[0], it.span[0]) })
        assertEquals(listOf(-2.0, 10.0), measured(3.0, -1.5, 7.625).let { listOf(it.spanFrom[0], it.span[0]) })
    }

    @Test
    fun `bounds that were measured elsewhere give the same extent`() {
        val p = populationOf(Sphere(x = 1.0, y = 3.0, z = 4.0), Sphere(x = 4.0, y = 3.0, z = -2.0))
        val bounds = StepBounds().apply { measure(p, boundary, true, InlineLoop) }
        val extent = GridExtent().apply { take(bounds, boundary) }
        extent.hold(listOf(-2.0, 0.0, -2.0), listOf(10.0, 20.0, 6.0), listOf(-2.0, 0.0, -2.0), listOf(10.0, 20.0, 6.0))
        val none = StepBounds().apply { measure(populationOf(), boundary, true, InlineLoop) }
        GridExtent().apply { take(none, boundary) }
            .hold(listOf(-2.0, 0.0, 0.0), listOf(10.0, 20.0, 0.0), listOf(-2.0, 0.0, 0.0), listOf(10.0, 20.0, 0.0))
    }

    @Test
    fun `spheres too far apart to compute with are refused, at either end of an open axis`() {
        measured(Double.NaN, 1.0, 4.0).requireComputable(1.0)
        for (far in listOf(1e200, -1e200)) {
            // z is 5 − x; x is periodic.
            val extent = measured(Double.NaN, 1.0, far)
            assertThrows(IllegalArgumentException::class.java) { extent.requireComputable(1.0) }
        }
    }
}
