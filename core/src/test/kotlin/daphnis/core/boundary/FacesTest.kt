package daphnis.core.boundary

import daphnis.core.Sphere
import daphnis.core.population.Population
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertDoesNotThrow

/** The faces themselves, what a boundary says of itself, and what it is not made of. */
class FacesTest {
    private val box = Box(0.0, 0.0, 0.0, 10.0, 8.0, 6.0)
    private val wrapping = listOf(Periodic(box), ShearedPeriodic(box, 0.1), LeesEdwards(box, 0.5))

    @Test
    fun `what is less than a rounding error below the lower face stays inside, just below the upper`() {
        for (boundary in wrapping) {
            val p = populationOf(Sphere(x = -1e-17, y = -1e-17, z = -1e-17))
            boundary.endStep(p, 0.0)
            for (axis in 0..2) {
                val v = listOf(p.x, p.y, p.z)[axis][0]
                assertEquals(Math.nextDown(box.upper(axis)), v) { "${boundary.javaClass.simpleName}, axis $axis" }
            }
        }
    }

    @Test
    fun `the lower face is inside, the upper is not`() {
        for (boundary in wrapping) {
            val p = populationOf(Sphere(), Sphere(x = 10.0, y = 8.0, z = 6.0))
            boundary.endStep(p, 0.0)
            for (k in 0..1) assertEquals(listOf(0.0, 0.0, 0.0), listOf(p.x[k], p.y[k], p.z[k]))
            val crossed = (0..1).map { id -> (0..2).map { p.boxesCrossed(id, it) } }
            assertEquals(listOf(listOf(0, 0, 0), listOf(1, 1, 1)), crossed) { boundary.javaClass.simpleName }
        }
    }

    @Test
    fun `a boundary that only says its box and what happens at the end of a step is open, and drives no flow`() {
        val own = object : BoundaryConditions {
            override val box = this@FacesTest.box

            override fun endStep(population: Population, time: Double) = Unit
        }
        for (boundary in listOf(own, Open)) {
            for (axis in 0..2) {
                assertEquals(ContactFaces.OPEN, boundary.contactFaces(axis))
                assertEquals(false, boundary.repeats(axis))
            }
            assertEquals(listOf(null, null, 1.0), listOf(boundary.shear, boundary.meanFlow, boundary.walls.restitution))
        }
        for (axis in 0..2) {
            assertEquals(listOf(true, true, true), wrapping.map { it.repeats(axis) })
            assertEquals(axis != 1, Walls(box, walled = booleanArrayOf(false, true, false)).repeats(axis))
            assertEquals(axis == 1, Periodic(box, periodicX = false, periodicZ = false).repeats(axis))
        }
    }

    @Test
    fun `the mean flow is the jump over the height of the box`() {
        val jump = ShearedPeriodic(box, 0.4).meanFlow
        assertEquals(listOf(1, 0, 0.05), listOf(jump.normalAxis, jump.flowAxis, jump.rate))
        val flow = LeesEdwards(box, -0.3).meanFlow
        assertEquals(listOf(1, 0, -0.3), listOf(flow.normalAxis, flow.flowAxis, flow.rate))
        assertEquals(null, Periodic(box).meanFlow)
    }

    @Test
    fun `images that slide stand right above one another at the start, and after each whole turn`() {
        for (rate in listOf(0.5, -0.5)) {
            val shear = LeesEdwards(box, rate).shear
            for (turn in 0..3) assertEquals(0.0, shear.offset(turn * 2.5) + 0.0) { "rate $rate, turn $turn" }
        }
    }

    @Test
    fun `a box without end is refused along the axis that needs one, and named`() {
        for (axis in 0..2) {
            val upper = DoubleArray(3) { if (it == axis) Double.POSITIVE_INFINITY else 1.0 }
            val endless = Box(0.0, 0.0, 0.0, upper[0], upper[1], upper[2])
            for (make in listOf<(Box) -> BoundaryConditions>(
                { Walls(it) },
                { Periodic(it) },
                { LeesEdwards(it, 0.1) },
                { ShearedPeriodic(it, 0.1) },
            )) {
                val refusal = assertThrows(IllegalArgumentException::class.java) { make(endless) }
                assertTrue("along ${"xyz"[axis]} must be finite" in refusal.message!!) { refusal.message!! }
            }
            assertDoesNotThrow { Periodic(endless, axis != 0, axis != 1, axis != 2) }
        }
    }

    @Test
    fun `boundaries at rest keep numbers finite, but for jumps and boxes at the ends of the range`() {
        val thin = Box(0.0, 0.0, 0.0, 10.0, 1e-91, 6.0)
        val flat = Box(0.0, 0.0, 0.0, 10.0, 8.0, 1e-91)
        val keeping = listOf(Periodic(box), Walls(box), ShearedPeriodic(flat, 0.1), ShearedPeriodic(box, -1e90))
        val others = listOf(
            LeesEdwards(box, 0.5),
            ShearedPeriodic(box, 1e91),
            ShearedPeriodic(box, -1e91),
            ShearedPeriodic(thin, 0.1),
            object : PerSphereBoundary by wrapping[0] {},
        )
        assertEquals(keeping.map { true } + others.map { false }, (keeping + others).map { it.keepsFinite(it) })
    }

    @Test
    fun `rates and restitutions that are none are refused, their ends are not`() {
        for (rate in listOf(Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { LeesEdwards(box, rate) }
            assertThrows(IllegalArgumentException::class.java) { ShearedPeriodic(box, rate) }
        }
        for (e in listOf(-0.1, 1.1, Double.NaN)) {
            assertThrows(IllegalArgumentException::class.java) { Walls(box, e) }
        }
        for (e in listOf(0.0, 1.0)) assertEquals(e, Walls(box, e).walls.restitution)
        for (n in listOf(2, 4)) {
            assertThrows(IllegalArgumentException::class.java) { Walls(box, walled = BooleanArray(n)) }
        }
    }
}
