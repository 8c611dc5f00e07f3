package daphnis.analysis.profile

import daphnis.analysis.flow.FlowField
import daphnis.analysis.insitu.Averages
import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.Sphere
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.hill.HillSheet
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population
import daphnis.core.population.VelocityMoments
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.sqrt

class ProfileTest {
    private val box = Box.centred(10.0, 20.0, 4.0)
    private fun column(name: String) = Profile.COLUMNS.indexOf(name)
    private val width = Profile.COLUMNS.size

    @Test
    fun `a Maxwellian in Hill's sheet has its temperature in every bin, once the shear is taken out`() {
        val state = uniform(60_000, HillSheet(box, 2.0), omega = 2.0) { 0.3 * it.nextGaussian() }
        for (axis in 0..2) {
            val profile = Profile(axis, box.lower(axis), box.upper(axis), 5)
            val r = profile.of(state)
            for (bin in 0 until 5) {
                for (c in listOf("c_xx", "c_yy", "c_zz")) assertEquals(0.09, r[bin * width + column(c)], 0.004)
                assertEquals(0.0, r[bin * width + column("c_xy")], 0.003)
                assertEquals(0.0, r[bin * width + column("mean_vy")], 0.015)
                assertEquals(12_000.0, r[bin * width + column("count")], 500.0)
            }
        }
        val moments = VelocityMoments.of(state.population, state.boundary.meanFlow, OrbitalFrequencies(2.0))
        assertEquals(0.3 * sqrt(3.0), moments.dispersion, 0.003)
        assertEquals(sqrt(16.0 / 12), moments.scaleHeight, 0.01)
    }

    @Test
    fun `bins add up to the surface density, optical depth and volume of all`() {
        val state = uniform(500, Periodic(box), radius = 0.2)
        for (axis in 0..2) {
            // Wide enough that no sphere sticks out of the last bin.
            val margin = 0.3
            val profile = Profile(axis, box.lower(axis) - margin, box.upper(axis) + margin, 8)
            val r = profile.of(state)
            val bin = (box.length(axis) + 2 * margin) / 8
            fun sum(c: String) = (0 until 8).sumOf { r[it * width + column(c)] }
            assertEquals(500.0, sum("count"))
            if (axis == 2) {
                assertEquals(500 * PI * 0.04 / 200, sum("optical_depth"), 1e-12)
                assertEquals(500.0, sum("surface_density") * 200 * bin, 1e-9)
                assertEquals(500 * 4.0 / 3 * PI * 0.008, sum("filling_factor") * 200 * bin, 1e-9)
            } else {
                val across = box.length(1 - axis)
                assertEquals(500.0, sum("surface_density") * bin * across, 1e-9)
                assertEquals(500 * PI * 0.04, sum("optical_depth") * bin * across, 1e-9)
                assertEquals(500 * 4.0 / 3 * PI * 0.008, sum("filling_factor") * bin * across * 4, 1e-9)
            }
        }
    }

    @Test
    fun `a sphere is cut at the faces of its bins`() {
        val p =
            Population(
                doubleArrayOf(0.0),
                doubleArrayOf(0.0),
                doubleArrayOf(0.5),
                DoubleArray(1),
                DoubleArray(1),
                DoubleArray(1),
                doubleArrayOf(1.0),
                doubleArrayOf(1.0),
            )
        val r = Profile(2, -2.0, 2.0, 2).of(State(p, Periodic(box), 0.0))
        // Below z = 0 lies the cap of height ½: π h² (3r − h)/3.
        val cap = PI * 0.25 * 2.5 / 3
        assertEquals(cap, r[column("filling_factor")] * 200 * 2, 1e-12)
        assertEquals(4.0 / 3 * PI - cap, r[width + column("filling_factor")] * 200 * 2, 1e-12)
        assertTrue(r[column("mean_vx")].isNaN())
    }

    @Test
    fun `the ellipsoid of a known tensor`() {
        val turn = 0.4
        val c = Math.cos(turn)
        val s = Math.sin(turn)
        val e = VelocityEllipsoid.of(9 * c * c + s * s, 9 * s * s + c * c, 4.0, 8 * s * c)
        assertEquals(3.0, e.major, 1e-12)
        assertEquals(1.0, e.minor, 1e-12)
        assertEquals(2.0, e.vertical, 1e-12)
        assertEquals(turn, e.orientation, 1e-12)
        assertEquals(sqrt(14.0), e.dispersion, 1e-12)
        assertEquals(sqrt(9 + 4 + 6.25), VelocityEllipsoid.of(4.0, 9.0, 6.25, 0.0).dispersion, 1e-12)
    }

    @Test
    fun `averages over states leave empty bins out and refuse another width`() {
        val profile = Profile(0, -5.0, 5.0, 50)
        val averages = Averages(profile)
        repeat(12) { averages.add(uniform(30, Periodic(box), seed = it + 1L) { r -> r.nextGaussian() }) }
        assertEquals(12, averages.size)
        assertEquals(30.0, (0 until 50).sumOf { averages.average(it * width + column("count")).mean }, 1e-9)
        assertTrue((0 until 50).all { averages.average(it * width + column("c_xx")).mean in 0.01..6.0 })
    }

    @Test
    fun `a line of the mean flow in uniform shear goes straight along it`() {
        val state = uniform(20_000, LeesEdwards(box, 1.0))
        val field = FlowField(10, 10)
        val sums = field.of(state)
        val vx = field.mean(sums, 0)
        val vy = field.mean(sums, 1)
        assertEquals(-9.0, vx[0], 0.2)
        assertEquals(9.0, vx[9], 0.2)
        val line = field.line(vx, vy, 5.0, 8.5)
        assertTrue(line.size > 8)
        for (k in line.indices step 2) assertEquals(8.5, line[k + 1], 1e-9)
        assertEquals(10.0, line[line.size - 2], 0.6)
    }

    @Test
    fun `all columns of three particles`() {
        val (u, v, w) = listOf(listOf(1.0, 2.0, 6.0), listOf(-2.0, 4.0, 1.0), listOf(5.0, 3.0, -2.0))
        val p = populationOf(
            Sphere(4.0, 1.0, 1.0, u[0], v[0], w[0], r = 0.5, m = 2.0),
            Sphere(6.0, -1.0, -1.0, u[1], v[1], w[1], r = 0.25, m = 3.0),
            Sphere(5.5, 0.0, 0.0, u[2], v[2], w[2], r = 1.0, m = 4.0),
        )
        // Two bins of 3 across x from 4: the first holds the three, and a part of the first sphere is cut off.
        val profile = Profile(0, 4.0, 10.0, 2)
        val r = profile.of(State(p, Walls(Box(0.0, -10.0, -2.0, 20.0, 10.0, 2.0)), 0.0))
        fun covariance(a: List<Double>, b: List<Double>) =
            (0..2).sumOf { (a[it] - a.average()) * (b[it] - b.average()) } / 2
        val wanted =
            listOf(3.0, 9.0 / 60, PI * (0.25 + 0.0625 + 1) / 60, 4.0 / 3 * PI * (0.0625 + 0.015625 + 1) / 240) +
                listOf(u.average(), v.average(), w.average(), covariance(u, u), covariance(v, v), covariance(w, w)) +
                covariance(u, v)
        for (c in 0 until width) assertEquals(wanted[c], r[c], 1e-12) { Profile.COLUMNS[c] }
        assertEquals(listOf(0, 4.0, 10.0, 2), listOf(profile.axis, profile.from, profile.to, profile.bins))
        assertEquals(listOf(5.5, 8.5), List(2) { profile.centre(it) })
    }

    @Test
    fun `particles of one velocity have no dispersion, whatever rounding makes of the difference of squares`() {
        for (n in 2..60) {
            val r = Profile(0, -5.0, 5.0, 1).of(uniform(n, Periodic(box)) { 0.1 })
            for (c in listOf("c_xx", "c_yy", "c_zz")) {
                assertTrue(r[column(c)] in 0.0..1e-15) { "$n particles, $c ${r[column(c)]}" }
            }
        }
    }

    @Test
    fun `a profile spans a period if its ends are those of the box but for a part in 10⁹`() {
        val spheres = listOf(4.9, -4.9).map { populationOf(Sphere(x = it, r = 0.5)) }
        val atFarEnd = PI * 0.16 * (1.5 - 0.4) / 3
        for ((shift, isWhole) in listOf(0.0 to true, 5e-9 to true, -5e-9 to true, 1e-7 to false, -1e-7 to false)) {
            for ((low, high) in listOf(shift to 0.0, 0.0 to shift)) {
                for ((farBin, p) in spheres.withIndex()) {
                    val r = Profile(0, -5 + low, 5 + high, 2).of(State(p, Periodic(box), 0.0))
                    val found = r[farBin * width + column("filling_factor")] * 5 * 80
                    assertEquals(if (isWhole) atFarEnd else 0.0, found, 1e-6) { "ends off by $low and $high" }
                }
            }
        }
        assertEquals(2, Profile(2, 0.0, 1.0, 1).axis)
    }

    @Test
    fun `a profile has an axis, a bin and a length`() {
        for (axis in listOf(-1, 3)) assertThrows(IllegalArgumentException::class.java) { Profile(axis, 0.0, 1.0, 1) }
        assertThrows(IllegalArgumentException::class.java) { Profile(0, 0.0, 1.0, 0) }
        assertThrows(IllegalArgumentException::class.java) { Profile(0, 1.0, 1.0, 1) }
    }
}
