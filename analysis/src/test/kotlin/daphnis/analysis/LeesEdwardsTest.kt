package daphnis.analysis

import daphnis.analysis.correlation.PairCorrelation
import daphnis.analysis.correlation.SurfaceMap
import daphnis.analysis.diffusion.Coordinate
import daphnis.analysis.diffusion.MeanSquareDisplacement
import daphnis.analysis.diffusion.Trajectories
import daphnis.analysis.insitu.State
import daphnis.analysis.occultation.RayCasting
import daphnis.analysis.order.RadialKey
import daphnis.analysis.order.RadialOrder
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.format.Snapshot
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI

/** Made states in a Lees–Edwards box, with answers worked out by hand. */
class LeesEdwardsTest {
    private val box = Box.centred(10.0, 8.0, 6.0)

    /** Images above have slid by 3 to the right, or by 3 to the left; the same modulo 10. */
    private val slid = listOf(
        LeesEdwards(box, 0.5) to 0.75,
        LeesEdwards(box, -0.5) to 0.75,
        LeesEdwards(box, 0.5) to 5.75,
    )

    private fun state(boundary: LeesEdwards, time: Double, vararg place: Triple<Double, Double, Double>): State {
        val n = place.size
        val zero = DoubleArray(n)
        val p = Population(
            DoubleArray(n) { place[it].first },
            DoubleArray(n) { place[it].second },
            DoubleArray(n) { place[it].third },
            zero,
            zero,
            zero,
            DoubleArray(n) { 0.25 },
            DoubleArray(n) { 1.0 },
        )
        return State(p, boundary, time)
    }

    private fun offset(case: Pair<LeesEdwards, Double>) = case.first.shear.offset(case.second)

    @Test
    fun `a pair through the sliding faces is as far apart as the image stands from its neighbour`() {
        for (case in slid) {
            // The image of the second, one box up, is 0.6 to the right of the first and 0.8 above it: 1 away.
            val x = 1.0 - offset(case) + 0.6
            val low = Triple(if (x < -5) x + 10 else x, -3.6, 1.0)
            val high = Triple(1.0, 3.6, 1.0)
            val pairs = PairCorrelation(2.0, 10)
            val g = pairs.of(state(case.first, case.second, high, low))
            // One pair between 1.0 and 1.2, where 2 particles in 480 would have V_shell/480.
            val bin = if (g[5] > 0) 5 else 4
            val a = bin * 0.2
            val shell = 4.0 / 3 * PI * ((a + 0.2) * (a + 0.2) * (a + 0.2) - a * a * a)
            assertEquals(480 / shell, g[bin], 1e-9 * 480 / shell)
            assertEquals(1, g.count { it > 0 }) { "${g.toList()}" }
            // As if images stood still there is no pair within 2.
            val still = pairs.of(state(LeesEdwards(box, 0.0), case.second, high, low))
            assertTrue(still.all { it == 0.0 }) { "${still.toList()}" }
        }
    }

    @Test
    fun `surface density at a lag across the sliding faces is that of the image`() {
        for (case in slid) {
            val high = Triple(1.5, 3.5, 0.0)
            val x = 1.5 - offset(case)
            val low = Triple(if (x < -5) x + 10 else x, -3.5, 0.0)
            val map = SurfaceMap.of(state(case.first, case.second, high, low), 1.0)
            // One cell up from the first is the image of the second: of 80 cells one pair, against a mean of 1/40.
            val a = map.autocorrelation(4, 3)
            val mean = 2.0 / 80
            assertEquals((1.0 / 80 - mean * mean) / (mean * mean), a[4 * 7 + 3 + 1], 1e-9)
            assertEquals(-1.0, a[5 * 7 + 3 + 1], 1e-9)
        }
    }

    @Test
    fun `the shadow beyond an upper face falls where the image stands`() {
        for (case in slid) {
            val shadow = RayCasting(PI / 2, rays = 400).cast(state(case.first, case.second, Triple(0.0, 4.0, 0.0)))
            assertEquals(PI * 0.25 * 0.25 / 80, 1 - shadow.transmission, 1e-4)
            // The half at the lower face belongs to the image one box down, at −offset.
            val row = (0 until shadow.nx).filter { shadow.blocked[it * shadow.ny] }.map { (it + 0.5) / 40 - 5 }
            val x = -offset(case)
            assertEquals(if (x < -5) x + 10 else x, row.average(), 0.03)
        }
    }

    @Test
    fun `ranks along the flow are those of the places in the box, and there is no guiding centre`() {
        val p =
            state(LeesEdwards(box, 0.5), 0.75, Triple(3.0, -1.0, 0.0), Triple(-4.9, 3.9, 0.0), Triple(0.5, 0.0, 0.0))
        val order = RadialOrder().sort(p, RadialKey.X)
        assertEquals(listOf(1, 2, 0), order.order.take(3))
        assertThrows(IllegalArgumentException::class.java) { RadialOrder().sort(p, RadialKey.GUIDING_CENTRE) }
    }

    @Test
    fun `spheres on straight paths are displaced by speed times lag across the flow, however often they wrap`() {
        for ((boundary, _) in slid) {
            val state = uniform(40, boundary, seed = 5) { it.nextGaussian() }
            val p = state.population
            val ids = IntArray(40) { it }
            val trajectories = Trajectories(listOf(Coordinate.Position(1), Coordinate.Position(2)), ids)
            val speeds = (1..2).map { axis -> p.velocity(axis).copyOf() }
            for (step in 0..32) {
                val time = 2.0 * step
                if (step > 0) {
                    for (axis in 0..2) for (k in 0 until 40) p.position(axis)[k] += 2.0 * p.velocity(axis)[k]
                    boundary.endStep(p, time)
                }
                trajectories.add(Snapshot.of(p, boundary, step.toLong(), time))
            }
            assertTrue((0 until 40).any { p.boxesCrossed(it, 1) != 0 && p.boxesCrossed(it, 0) != 0 }) { "none wrapped" }
            val displacement = MeanSquareDisplacement(trajectories)
            for (axis in 0..1) {
                val mean = speeds[axis].average()
                val variance = speeds[axis].sumOf { (it - mean) * (it - mean) } / 40
                val measured = displacement.mean(axis)
                for (lag in 1..measured.size) {
                    val expected = variance * (2.0 * lag) * (2.0 * lag)
                    assertEquals(expected, measured[lag - 1], 1e-10 * expected)
                }
            }
            assertNull(displacement.diffusion(0, 1)) { "straight paths do not diffuse" }
        }
    }
}
