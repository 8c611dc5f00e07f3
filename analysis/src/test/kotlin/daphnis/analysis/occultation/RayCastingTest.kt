package daphnis.analysis.occultation

import daphnis.analysis.insitu.PatchState
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.boundary.HillSheet
import daphnis.core.boundary.Periodic
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.exp
import kotlin.math.sin

class RayCastingTest {
    private fun one(x: Double, y: Double, z: Double, boundary: daphnis.core.boundary.BoundaryConditions, time: Double = 0.0) = PatchState(
        Population(doubleArrayOf(x), doubleArrayOf(y), doubleArrayOf(z), DoubleArray(1), DoubleArray(1), DoubleArray(1), doubleArrayOf(1.0), doubleArrayOf(1.0)),
        boundary,
        time,
    )

    @Test
    fun `one sphere shadows an ellipse of area π r² over sin B, wherever it stands and through whatever faces`() {
        val sheet = HillSheet(Box.centred(10.0, 12.0, 8.0), 1.0)
        for (elevation in listOf(PI / 2, 1.0, 0.4)) {
            for (azimuth in listOf(0.0, 0.9, 2.0)) {
                for (state in listOf(one(0.0, 0.0, 0.0, sheet), one(4.9, -5.8, 1.0, sheet, 0.37), one(-4.5, 3.0, -3.0, sheet, 2.2))) {
                    val blocked = 1 - RayCasting(elevation, azimuth).cast(state).transmission
                    assertEquals(PI / sin(elevation) / 120, blocked, 0.0005) { "B $elevation, A $azimuth" }
                }
            }
        }
    }

    @Test
    fun `the shadow beyond a radial face falls where the image stands`() {
        val sheet = HillSheet(Box.centred(10.0, 12.0, 8.0), 1.0)
        val time = 0.2
        // At the outer face; its other half is blocked at the inner one, displaced by −offset of the image at +1.
        val shadow = RayCasting(PI / 2, rays = 240).cast(one(5.0, 0.0, 0.0, sheet, time))
        val offset = sheet.shear!!.offset(time)
        var place = -offset
        while (place < -6) place += 12
        val column = (0 until shadow.ny).filter { shadow.blocked[it] }
        val middle = (column.first() + column.last() + 1) / 2.0 / shadow.ny * 12 - 6
        assertEquals(place, middle, 0.1)
    }

    @Test
    fun `many spheres without correlation let exp(−τ over sin B) through, and the scan is even`() {
        val state = uniform(3000, Periodic(Box.centred(40.0, 40.0, 10.0)), radius = 0.3)
        val depth = 3000 * PI * 0.09 / 1600
        for (elevation in listOf(PI / 2, 0.5)) {
            val rays = RayCasting(elevation)
            assertEquals(exp(-depth / sin(elevation)), rays.cast(state).transmission, 0.02)
            assertEquals(depth, rays.depth().of(state)[1], 0.03)
            assertEquals(rays.cast(state).transmission, rays.cast(state).scan().average(), 1e-12)
        }
    }

    @Test
    fun `elevations below the plane and none are refused`() {
        for (elevation in listOf(0.0, -1.0, 2.0, Double.NaN)) assertThrows(IllegalArgumentException::class.java) { RayCasting(elevation) }
    }
}
