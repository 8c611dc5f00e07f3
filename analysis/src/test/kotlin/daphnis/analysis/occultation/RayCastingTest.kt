package daphnis.analysis.occultation

import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.prepare
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import daphnis.core.space.Images
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.exp
import kotlin.math.sin

class RayCastingTest {
    private fun one(
        x: Double,
        y: Double,
        z: Double,
        boundary: daphnis.core.boundary.BoundaryConditions,
        time: Double = 0.0,
    ) = State(
        Population(
            doubleArrayOf(x),
            doubleArrayOf(y),
            doubleArrayOf(z),
            DoubleArray(1),
            DoubleArray(1),
            DoubleArray(1),
            doubleArrayOf(1.0),
            doubleArrayOf(1.0),
        ),
        boundary,
        time,
    )

    @Tag("thorough")
    @Test
    fun `a shadow a hundred times as long as the box leaves what lies beside it`() {
        // At 0.1° along the orbit: a strip as wide as the sphere, all along y.
        val strip = RayCasting(Math.toRadians(0.1), PI / 2).cast(one(0.3, 2.0, 0.0, HillSheet(box, 1.0)))
        assertEquals(1 - 2.0 / 10, strip.transmission, 2.0 / 1024)
        assertEquals(listOf(0.0, 1.0), strip.scan().distinct().sorted())
        val all = uniform(2_000, HillSheet(box, 1.0), radius = 0.1)
        for (azimuth in listOf(0.0, 0.4)) {
            val grazing = LineOfSight(Math.toRadians(0.1), azimuth)
            assertEquals(0.0, RayCasting(grazing.elevation, azimuth).cast(all).transmission)
            assertTrue(
                Scan(grazing, Footprint.rectangle(2.0, 2.0), 0.3).of(all).transmission.all { track ->
                    track.all {
                        it ==
                            0.0
                    }
                },
            )
        }
    }

    private val box = Box.centred(10.0, 12.0, 8.0)

    @Test
    fun `one sphere shadows an ellipse of area π r² over sin B, wherever it stands and through whatever faces`() {
        val sheet = HillSheet(Box.centred(10.0, 12.0, 8.0), 1.0)
        for (elevation in listOf(PI / 2, 1.0, 0.4)) {
            for (azimuth in listOf(0.0, 0.9, 2.0)) {
                for (state in listOf(
                    one(0.0, 0.0, 0.0, sheet),
                    one(4.9, -5.8, 1.0, sheet, 0.37),
                    one(-4.5, 3.0, -3.0, sheet, 2.2),
                )) {
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
    fun `rays are blocked by the spheres and images that a plain search along each ray finds, whichever axis slides`() {
        val box = Box.centred(10.0, 12.0, 8.0)
        for (boundary in listOf(
            HillSheet(box, 1.0),
            LeesEdwards(box, 0.7),
            LeesEdwards(box, -0.7),
            HillSheet(box, 1.0, true),
        )) {
            val time = 0.83
            val state = uniform(14, boundary, radius = 0.7).let { State(it.population, boundary, time) }
            val images = Images().also { it.prepare(boundary, time) }
            for ((elevation, azimuth) in listOf(PI / 2 to 0.0, 0.5 to 0.0, 0.5 to 1.1, 0.35 to 3.9)) {
                val shadow = RayCasting(elevation, azimuth, rays = 36).cast(state)
                val expected = BooleanArray(shadow.blocked.size) { at ->
                    val x = -5 + (at / shadow.ny + 0.5) * 10 / shadow.nx
                    val y = -6 + (at % shadow.ny + 0.5) * 12 / shadow.ny
                    isBlocked(state, images, x, y, elevation, azimuth)
                }
                assertArrayEquals(expected, shadow.blocked) {
                    "${boundary.javaClass.simpleName}, B $elevation, A $azimuth"
                }
            }
        }
    }

    @Test
    fun `a wake lets most light through along its crests and least across`() {
        // Walls of spheres along crests that lean by 25 degrees from the orbit, 15 apart along x, as high as they are
        // apart; rays 20 degrees above the plane.
        val pitch = Math.toRadians(25.0)
        val ly = 60 / Math.tan(pitch)
        val spheres = ArrayList<DoubleArray>()
        for (crest in 0 until 4) {
            for (k in 0 until 200) {
                val y = -ly / 2 + (k + 0.5) / 200 * ly
                val x = -22.5 + 15 * crest - y * Math.tan(pitch)
                for (h in -4..4) spheres += doubleArrayOf(x - 60 * Math.floor((x + 30) / 60), y, 0.8 * h)
            }
        }
        fun column(c: Int) = DoubleArray(spheres.size) { spheres[it][c] }
        val zero = DoubleArray(spheres.size)
        val p =
            Population(
                column(0),
                column(1),
                column(2),
                zero,
                zero,
                zero,
                DoubleArray(spheres.size) {
                    0.7
                },
                DoubleArray(spheres.size) { 1.0 },
            )
        val state = State(p, HillSheet(Box.centred(60.0, ly, 10.0), 1.0), 0.0)
        val t = (0 until 36).associateWith {
            RayCasting(Math.toRadians(20.0), Math.toRadians(5.0 * it), rays = 256).cast(state).transmission
        }
        // Crests run from y backward outward: 90 + 25 degrees from x toward y, and rays climb the other way as well.
        assertEquals(115, 5 * t.maxByOrNull { it.value }!!.key)
        val darkest = 5 * t.minByOrNull { it.value }!!.key
        assertTrue(Math.abs(Math.floorMod(darkest - 25 + 90, 180) - 90) <= 60) { "least light at $darkest degrees: $t" }
        assertTrue(t[5]!! < 0.5 * t[23]!!) { "$t" }
    }

    @Test
    fun `the depth is that of the mean transmission, finite although one state is opaque`() {
        val rays = RayCasting(PI / 6)
        val depth = rays.depth(BlockAverage(0.25, 0.05, 8))
        assertEquals(-0.5 * Math.log(0.25), depth.mean, 1e-12)
        assertEquals(0.5 * 0.05 / 0.25, depth.error, 1e-12)
        assertEquals(Double.POSITIVE_INFINITY, rays.depth(BlockAverage(0.0, 0.0, 8)).mean)
        val opaque = one(0.0, 0.0, 0.0, Periodic(Box.centred(0.5, 0.5, 4.0)))
        val clear = one(0.0, 0.0, 0.0, Periodic(Box.centred(20.0, 20.0, 4.0)))
        val averages = Averages(RayCasting(PI / 2).transmission())
        averages.add(opaque)
        averages.add(clear)
        assertEquals((1 - PI / 400) / 2, averages.average(0).mean, 1e-3)
        assertEquals(-Math.log(averages.average(0).mean), RayCasting(PI / 2).depth(averages.average(0)).mean, 1e-12)
    }

    @Test
    fun `many spheres without correlation let exp(−τ over sin B) through, and the scan is even`() {
        val state = uniform(3000, Periodic(Box.centred(40.0, 40.0, 10.0)), radius = 0.3)
        val depth = 3000 * PI * 0.09 / 1600
        for (elevation in listOf(PI / 2, 0.5)) {
            val rays = RayCasting(elevation)
            assertEquals(exp(-depth / sin(elevation)), rays.cast(state).transmission, 0.02)
            assertEquals(depth, rays.depth(BlockAverage.of(rays.transmission().of(state))).mean, 0.03)
            assertEquals(rays.cast(state).transmission, rays.cast(state).scan().average(), 1e-12)
        }
    }

    @Test
    fun `elevations below the plane and none are refused`() {
        for (elevation in listOf(0.0, -1.0, 2.0, Double.NaN)) {
            assertThrows(IllegalArgumentException::class.java) {
                RayCasting(elevation)
            }
        }
        assertThrows(IllegalArgumentException::class.java) { RayCasting(1.0, Double.NaN) }
    }
}
