package daphnis.core.population

import daphnis.core.Sphere
import daphnis.core.initial.SeededRandom
import daphnis.core.populationOf
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sin
import kotlin.math.sqrt

@Tag("jdk-neutral")
class GranularTemperatureTest {
    private val flow = MeanFlow(normalAxis = 1, flowAxis = 0, rate = 0.7)
    private val hill = MeanFlow(normalAxis = 0, flowAxis = 1, rate = -1.5)

    /**
     * A Maxwellian with ⟨c_x²⟩, ⟨c_y²⟩, ⟨c_z²⟩ = 1, 2, 3 and ⟨c_x c_y⟩ = ½ at mass 1, energy shared equally, on a flow.
     */
    private fun maxwellian(
        count: Int,
        random: SeededRandom,
        mass: (Int) -> Double = { 1.0 },
        velocity: (x: Double, y: Double) -> DoubleArray,
    ): Population {
        fun place() = DoubleArray(count) { random.nextDouble(-4.0, 4.0) }
        val m = DoubleArray(count) { mass(it) }
        val x = place()
        val y = place()
        val v = Array(3) { DoubleArray(count) }
        for (k in 0 until count) {
            val cool = 1 / sqrt(m[k])
            val a = random.nextGaussian()
            val u = velocity(x[k], y[k])
            v[0][k] = a * cool + u[0]
            v[1][k] = (0.5 * a + sqrt(1.75) * random.nextGaussian()) * cool + u[1]
            v[2][k] = sqrt(3.0) * random.nextGaussian() * cool + u[2]
        }
        return Population(x, y, place(), v[0], v[1], v[2], DoubleArray(count) { 0.1 }, m)
    }

    private fun assertUnbiased(
        what: String,
        count: Int,
        flow: MeanFlow?,
        mass: (Int) -> Double = {
            1.0
        },
        velocity: (Double, Double) -> DoubleArray,
    ) {
        val random = SeededRandom(11)
        val draws = 12_000 / count + 200
        val truth = doubleArrayOf(1.0, 2.0, 3.0, 0.5, 0.0, 0.0)
        val sum = DoubleArray(6)
        val square = DoubleArray(6)
        repeat(draws) {
            val p = maxwellian(count, random, mass, velocity)
            // ⟨c_a c_b⟩ by mass of a shared energy is that of mass 1 over the mean mass.
            val scale = p.mass.average()
            val found = VelocityMoments.of(p, flow).moments
            for (e in 0 until 6) {
                sum[e] += found[e] * scale
                square[e] += found[e] * found[e] * scale * scale
            }
        }
        for (e in 0 until 6) {
            val mean = sum[e] / draws
            val error = sqrt((square[e] / draws - mean * mean) / draws)
            assertTrue(abs(mean - truth[e]) < 3.5 * error) {
                "$what, $count spheres: moment $e is $mean ± $error over $draws draws, it is ${truth[e]}"
            }
        }
    }

    @Tag("thorough")
    @Test
    fun `the moments of a Maxwellian have no bias at 2, 10, 100 and 1000 spheres, at rest, drifting and in shear`() {
        for (count in listOf(2, 10, 100, 1000)) {
            assertUnbiased("at rest", count, null) { _, _ -> DoubleArray(3) }
            assertUnbiased("drifting", count, null) { _, _ -> doubleArrayOf(5.0, -3.0, 2.0) }
            assertUnbiased("in shear", count, flow) { _, y -> doubleArrayOf(0.7 * y + 3, 1.0, 0.0) }
            assertUnbiased("in Hill's sheet", count, hill) { x, _ -> doubleArrayOf(0.0, -1.5 * x, 0.0) }
            // The flow may have another rate than the boundary's, if there are spheres enough to measure it.
            if (count > 2) {
                assertUnbiased("slower than driven", count, flow) { _, y -> doubleArrayOf(0.2 * y, 0.0, 0.0) }
            }
        }
    }

    @Test
    fun `unequal masses that share the energy equally have no bias either`() {
        for (count in listOf(3, 10, 1000)) {
            assertUnbiased("masses 1 to 8", count, flow, { 1.0 + it % 8 }) { _, y -> doubleArrayOf(0.7 * y, 0.0, 0.0) }
        }
    }

    @Test
    fun `a flow that is not straight is left out by its slabs, and is in the kinetic part of the pressure`() {
        // u = sin(π y/4): its square has the mean ½.
        // Twenty slabs leave the variance of the slope in a slab, (π/4 · 0.4)²/12 · ½.
        val p = maxwellian(40_000, SeededRandom(5)) { _, y -> doubleArrayOf(0.7 * y + sin(Math.PI * y / 4), 0.0, 0.0) }
        val m = VelocityMoments.of(p, flow)
        assertEquals(1.0 + 0.0041, m.moments[VelocityMoments.XX], 0.02)
        assertEquals(1.5, m.kinetic[VelocityMoments.XX], 0.03)
        assertEquals(0.5, m.moments[VelocityMoments.XY], 0.02)
        assertEquals(0.5, m.kinetic[VelocityMoments.XY], 0.03)
        assertEquals((m.moments[0] + m.moments[1] + m.moments[2]) / 3, granularTemperature(p, flow))
    }

    @Test
    fun `around the boundary's flow the plain sums are exact`() {
        val p = populationOf(
            Sphere(y = -1.0, vx = -0.7 + 1.0, vz = 2.0, m = 1.0),
            Sphere(y = 2.0, vx = 1.4 - 1.0, vy = 3.0, m = 3.0),
        )
        val m = VelocityMoments.of(p, flow)
        // w = (1, 0, 2) and (−1, 3, 0), mean (−½, 9/4, ½) by mass.
        assertArrayEquals(doubleArrayOf(-0.5, 2.25, 0.5), m.mean, 1e-15)
        assertArrayEquals(doubleArrayOf(0.75, 1.6875, 0.75, -1.125, 0.75, -1.125), m.kinetic, 1e-15)
        // Of two spheres one degree of freedom of each component is left, and no line is fitted.
        assertArrayEquals(doubleArrayOf(1.5, 3.375, 1.5, -2.25, 1.5, -2.25), m.moments, 1e-14)
    }

    @Test
    fun `a cold flow is cold, however fast, and whatever lies in one plane`() {
        val random = SeededRandom(2)
        val y = DoubleArray(300) { random.nextDouble(-4.0, 4.0) }
        val zero = DoubleArray(300)
        val one = DoubleArray(300) { 1.0 }
        fun gas(height: DoubleArray, u: (Double) -> Double) =
            Population(zero, height, zero, DoubleArray(300) { u(height[it]) }, zero, zero, one, one)
        assertEquals(0.0, granularTemperature(gas(y) { 0.7 * it }, flow), 1e-28)
        assertEquals(0.0, granularTemperature(gas(y) { 3 * it + 1e6 }, flow), 1e-9)
        assertEquals(0.0, granularTemperature(gas(DoubleArray(300) { 2.0 }) { 5.0 }, flow), 1e-24)
        assertEquals(0.0, granularTemperature(populationOf(Sphere(vx = 3.0)), flow))
        assertEquals(0.0, granularTemperature(populationOf(Sphere(vx = 3.0)), null))
        assertEquals(0.0, granularTemperature(populationOf(), flow))
        assertTrue(VelocityMoments.of(populationOf(), flow).kinetic.all { it == 0.0 })
    }

    @Test
    fun `bodies count for mass, momentum and energy, and not for the temperature`() {
        val gas = maxwellian(500, SeededRandom(8)) { _, y -> doubleArrayOf(0.7 * y, 0.0, 0.0) }
        fun with(a: DoubleArray, b: Double) = a + b
        val moonlet = with(gas.mass, 1e5).let { mass ->
            Population(
                with(gas.x, 0.0),
                with(gas.y, 1.0),
                with(gas.z, 0.0),
                with(gas.vx, 7.0),
                with(gas.vy, 0.0),
                with(gas.vz, 0.0),
                with(gas.radius, 1.0),
                mass,
            )
        }
        val sums = PopulationSums(flow, firstBody = 500).apply { take(moonlet) }
        assertEquals(granularTemperature(gas, flow), sums.granularTemperature, 1e-12)
        assertEquals(500.0, sums.particleMass)
        assertEquals(100_500.0, sums.mass)
        assertEquals(7e5 + (0 until 500).sumOf { gas.vx[it] }, sums.momentum(0), 1e-8)
    }
}
