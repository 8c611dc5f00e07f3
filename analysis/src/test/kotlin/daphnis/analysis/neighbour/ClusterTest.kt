package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import daphnis.core.Sphere
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

class ClusterTest {
    private val box = Box.centred(10.0, 10.0, 10.0)
    private val near = ClusterCriterion(1.05)

    private fun clusters(p: Population, boundary: BoundaryConditions, time: Double = 0.0): List<Cluster> {
        boundary.endStep(p, time)
        val state = State(p, boundary, time)
        return Cluster.of(state, Clusters.of(state, near))
    }

    private fun cross(a: DoubleArray, b: DoubleArray) = DoubleArray(3) {
        a[(it + 1) % 3] * b[(it + 2) % 3] - a[(it + 2) % 3] * b[(it + 1) % 3]
    }

    /** Spheres at these places about [centre], which moves with [v] against the flow, that turn with [w]. */
    private fun rigid(
        boundary: BoundaryConditions,
        places: List<List<Double>>,
        radii: List<Double>,
        centre: List<Double>,
        v: DoubleArray,
        w: DoubleArray,
    ): Population {
        val mass = radii.map { it * it * it }
        val middle = DoubleArray(3) { a -> places.indices.sumOf { mass[it] * places[it][a] } / mass.sum() }
        val all = places.indices.map { k ->
            val r = DoubleArray(3) { places[k][it] - middle[it] }
            val turn = cross(w, r)
            val u = DoubleArray(3) { v[it] + turn[it] }
            boundary.meanFlow?.let { u[it.flowAxis] += it.rate * centre[it.normalAxis] }
            Sphere(
                centre[0] + r[0],
                centre[1] + r[1],
                centre[2] + r[2],
                u[0],
                u[1],
                u[2],
                r = radii[k],
                m = mass[k],
            )
        }
        return populationOf(*all.toTypedArray())
    }

    @Test
    fun `a rigid body of two sizes that turns across faces, sliding ones too, has its spin and is cold`() {
        val places =
            listOf(listOf(0.0, 0.0, 0.0), listOf(1.0, 0.0, 0.0), listOf(0.0, 0.8, 0.0), listOf(0.0, 0.0, 0.8))
        val radii = listOf(0.5, 0.5, 0.3, 0.3)
        val v = doubleArrayOf(0.3, -0.2, 0.1)
        val w = doubleArrayOf(0.4, -0.7, 1.3)
        val mass = radii.sumOf { it * it * it }
        val middle = DoubleArray(3) { a ->
            places.indices.sumOf { radii[it] * radii[it] * radii[it] * places[it][a] } /
                mass
        }
        val square = places.indices.sumOf { k ->
            val r = radii[k]
            r * r * r * ((0..2).sumOf { (places[k][it] - middle[it]) * (places[k][it] - middle[it]) } + 0.6 * r * r)
        } / mass
        for (boundary in listOf(Periodic(box), LeesEdwards(box, 0.7), HillSheet(box, 1.1), BoundaryConditions.open())) {
            for (centre in listOf(listOf(0.0, 0.0, 0.0), listOf(4.9, 4.9, 4.9), listOf(-4.8, 4.9, -4.9))) {
                val found = clusters(rigid(boundary, places, radii, centre, v, w), boundary, 1.3)
                val one = found.single()
                assertEquals(4, one.members)
                assertEquals(mass, one.mass, 1e-12)
                assertArrayEquals(v, one.velocity, 1e-12)
                assertArrayEquals(w, one.spin, 1e-11)
                assertEquals(0.0, one.temperature, 1e-20)
                assertEquals(sqrt(square), one.gyrationRadius, 1e-12)
                val ball = sqrt(5.0 / 3 * square)
                assertEquals(mass / (ball * ball * ball), one.fillingFactor, 1e-11)
                for (axis in 0..2) assertEquals(centre[axis], one.centre[axis], 1e-11)
            }
        }
    }

    @Test
    fun `the centre of a cluster that lies beyond a sliding face is where its image in the box is`() {
        val boundary = LeesEdwards(box, 0.3)
        // Most of it is above, at y = 5.4: in the box 10 lower, and 3 to the left.
        val p = populationOf(Sphere(1.0, 4.9, r = 0.5), Sphere(1.0, 5.9, r = 0.5, vx = 0.3 * 5.9))
        val one = clusters(p, boundary, 1.0).single()
        assertArrayEquals(doubleArrayOf(-2.0, -4.6, 0.0), one.centre, 1e-11)
    }

    @Test
    fun `spins of the spheres are in that of the cluster, and a row of smooth ones has none along it`() {
        val p = populationOf(Sphere(0.0, vy = -0.5, r = 0.5), Sphere(1.0, vy = 0.5, r = 0.5))
        val smooth = clusters(p, Periodic(box)).single()
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 1.0), smooth.spin, 1e-12)
        assertEquals(0.0, smooth.temperature, 1e-20)
        // I: two points of mass 1 at ½, and twice 0.4 · ¼.
        val w = doubleArrayOf(2.0, 2.0)
        val rough = clusters(p.withSpin(w, DoubleArray(2), DoubleArray(2)), Periodic(box)).single()
        assertArrayEquals(doubleArrayOf(2.0, 0.0, 0.5 / 0.7), rough.spin, 1e-12)
        val turned = clusters(
            p.withSpin(DoubleArray(2), DoubleArray(2), doubleArrayOf(1.0, 1.0)),
            Periodic(box),
        ).single()
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 1.0), turned.spin, 1e-12)
        // R_g² of two balls in contact: 1/4 + 3/20.
        assertEquals(sqrt(0.4), smooth.gyrationRadius, 1e-12)
    }

    @Test
    fun `a chain through a sliding face spans where it meets its image and then has no radius`() {
        val boundary = LeesEdwards(box, 0.3)
        val lean = Array(12) { k -> Sphere((k / 12.0) * 3 - 1.5, -5 + (k + 0.5) / 1.2, r = 0.5) }
        val spanning = clusters(populationOf(*lean), boundary, 1.0).single()
        assertTrue(spanning.isSpanning && spanning.gyrationRadius.isNaN() && spanning.centre.all { it.isNaN() })
        assertTrue(spanning.spin.all { it.isNaN() } && spanning.fillingFactor.isNaN() && !spanning.temperature.isNaN())
        // Without slide its ends do not meet.
        val open = clusters(populationOf(*lean), boundary, 0.0).single()
        assertTrue(!open.isSpanning && open.gyrationRadius > 2)
        assertEquals(12, open.members)
    }

    @Test
    fun `a full ball of small spheres has its radius and filling factor, and discs those of a disc`() {
        val places = ArrayList<Sphere>()
        for (x in -12..12) {
            for (y in -12..12) {
                for (z in -12..12) {
                    if (x * x + y * y + z * z <= 144) places += Sphere(x * 0.2, y * 0.2, z * 0.2, r = 0.1)
                }
            }
        }
        val ball = clusters(populationOf(*places.toTypedArray()), BoundaryConditions.open()).single()
        assertEquals(PI / 6, ball.fillingFactor, 0.01)
        assertEquals(2.4 * sqrt(0.6), ball.gyrationRadius, 0.02)
        val flat = places.filter { it.z == 0.0 }
        val disc = clusters(populationOf(*flat.toTypedArray()), Periodic(Box.flat(10.0, 10.0))).single()
        assertEquals(PI / 4, disc.fillingFactor, 0.01)
        assertEquals(2.4 / sqrt(2.0), disc.gyrationRadius, 0.03)
        // Two discs in contact that turn: one degree of freedom left, the motion along their line.
        val pair = populationOf(Sphere(0.0, vx = -0.1, vy = -1.0, r = 0.5), Sphere(1.0, vx = 0.1, vy = 1.0, r = 0.5))
        val two = clusters(pair, Periodic(Box.flat(10.0, 10.0))).single()
        assertArrayEquals(doubleArrayOf(0.0, 0.0, 2.0), two.spin, 1e-12)
        assertEquals(0.02, two.temperature, 1e-12)
    }

    @Test
    fun `the temperature inside is that of the velocities, whatever the number of members`() {
        val random = SeededRandom(5)
        for (members in 2..6) {
            val all = DoubleArray(4000) {
                val ring = Array(members) { k ->
                    val angle = 2 * PI * k / members
                    val radius = 0.5 / sin(PI / members)
                    Sphere(
                        radius * cos(angle),
                        radius * sin(angle),
                        0.0,
                        random.nextGaussian(),
                        random.nextGaussian(),
                        random.nextGaussian(),
                        r = 0.5,
                    )
                }
                clusters(populationOf(*ring), Periodic(box)).single().temperature
            }
            val mean = all.average()
            val error = sqrt(all.sumOf { (it - mean) * (it - mean) }) / all.size
            assertTrue(abs(mean - 1) < 4 * error) { "$members: $mean ± $error" }
        }
    }
}
