package daphnis.core.compression

import daphnis.core.Simulation
import daphnis.core.Sphere
import daphnis.core.assertInvariants
import daphnis.core.boundary.Box
import daphnis.core.force.Drift
import daphnis.core.force.Force
import daphnis.core.force.Kick
import daphnis.core.hill.HillFrame
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Population
import daphnis.core.population.stateDigest
import daphnis.core.populationOf
import daphnis.core.randomSpheres
import daphnis.core.simulationOf
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.abs
import kotlin.math.sqrt

class GrowingSpheresTest {
    private val box = Box.centred(20.0, 16.0, 12.0)

    private fun growing(rate: Double, from: Double = 0.0, thermostat: Boolean = false, box: Box = this.box) =
        GrowingSpheres(box, rate, from, thermostat)

    /** Of [population], without a thermostat, after [steps] steps of [dt]. */
    private fun after(
        population: Population,
        rate: Double,
        dt: Double,
        steps: Int = 1,
        box: Box = this.box,
    ): Population {
        val simulation = simulationOf(population, growing(rate, box = box), dt)
        repeat(steps) { simulation.advance() }
        return simulation.population
    }

    private fun Population.of(id: Int, axis: Int) = position(axis)[indexOf(id)]

    private fun Population.speed(id: Int, axis: Int) = velocity(axis)[indexOf(id)]

    @Test
    fun `two that meet head-on touch at their radii of that moment and part by twice the growth more`() {
        for (axis in 0..2) {
            fun sphere(at: Double, v: Double) = Sphere(
                if (axis == 0) at else 1.0,
                if (axis == 1) at else 1.0,
                if (axis == 2) at else 1.0,
                if (axis == 0) v else 0.0,
                if (axis == 1) v else 0.0,
                if (axis == 2) v else 0.0,
            )
            // 1.5 − t = 1 + 0.1 t at t = 0.5/1.1; then each has 1 + 2 · 0.1.
            val p = after(populationOf(sphere(-1.5, 1.0), sphere(1.5, -1.0)), 0.1, 0.8)
            val t = 0.5 / 1.1
            for (id in 0..1) {
                val side = if (id == 0) -1.0 else 1.0
                assertEquals(side * 1.2, p.speed(id, axis), 1e-14)
                assertEquals(side * (1.5 - t + 1.2 * (0.8 - t)), p.of(id, axis), 1e-14)
                assertEquals(1.0, p.of(id, (axis + 1) % 3), 1e-15)
                assertEquals(0.0, p.speed(id, (axis + 1) % 3), 1e-15)
                assertEquals(1.08, p.radius[p.indexOf(id)], 1e-15)
            }
        }
    }

    @Test
    fun `two that meet through a face do the same`() {
        for (axis in 0..2) {
            val half = box.length(axis) / 2
            fun sphere(at: Double, v: Double) = Sphere(
                if (axis == 0) at else 1.0,
                if (axis == 1) at else 1.0,
                if (axis == 2) at else 1.0,
                if (axis == 0) v else 0.0,
                if (axis == 1) v else 0.0,
                if (axis == 2) v else 0.0,
            )
            val p = after(populationOf(sphere(half - 1.5, 1.0), sphere(1.5 - half, -1.0)), 0.1, 0.8)
            val t = 0.5 / 1.1
            for (id in 0..1) {
                val side = if (id == 0) 1.0 else -1.0
                assertEquals(-side * 1.2, p.speed(id, axis), 1e-13)
                assertEquals(side * (half - (1.5 - t + 1.2 * (0.8 - t))), p.of(id, axis), 1e-13)
            }
        }
    }

    @Test
    fun `two that would pass at rest touch where they grow enough, and miss one another where they do not`() {
        // Nearest at t = 0.5, 2.06 apart. With the rate γ (4 (t − 0.5))² + 2.06² = 4 (1 + γ t)² has roots from γ = 0.0591 on.
        fun pair() = populationOf(Sphere(-1.0, 0.0, 0.0, 2.0), Sphere(1.0, 2.06, 0.0, -2.0))
        assertEquals(2.0, after(pair(), 0.0590, 0.6).speed(0, 0), 1e-14)
        assertTrue(after(pair(), 0.0592, 0.6).speed(0, 1) < 0)
    }

    @Test
    fun `a lone sphere flies straight on through faces, also far from the origin`() {
        val far = Box(100.0, 200.0, -70.0, 112.0, 210.0, -60.0)
        for (rate in listOf(0.05, -0.05)) {
            val p = after(populationOf(Sphere(105.0, 203.0, -61.0, 3.0, -2.0, 4.0)), rate, 0.7, 10, far)
            assertArrayEquals(doubleArrayOf(3.0, -2.0, 4.0), doubleArrayOf(p.vx[0], p.vy[0], p.vz[0]), 1e-12)
            assertEquals(105.0 + 21 - 24, p.x[0], 1e-11)
            assertEquals(203.0 - 14 + 20, p.y[0], 1e-11)
            assertEquals(-61.0 + 28 - 30, p.z[0], 1e-11)
            assertEquals(listOf(2, -2, 3), (0..2).map { p.boxesCrossed(0, it) })
            assertEquals(1 + rate * 7, p.radius[0], 1e-14)
        }
    }

    private fun gas(count: Int, seed: Long, radius: (SeededRandom) -> Double = { 0.8 }) =
        randomSpheres(count, growing(0.1), seed, 1.0, radius)

    @Test
    fun `the length of a step is no physics`() {
        val start = gas(150, 3) { it.nextDouble(0.4, 1.0) }
        val coarse = after(start.copy(), 0.2, 0.2, 2)
        val fine = after(start.copy(), 0.2, 0.05, 8)
        for (id in 0 until start.size) {
            for (axis in 0..2) {
                val apart = abs(coarse.of(id, axis) - fine.of(id, axis))
                assertEquals(0.0, minOf(apart, box.length(axis) - apart), 1e-9)
                assertEquals(coarse.speed(id, axis), fine.speed(id, axis), 1e-9)
            }
        }
        assertTrue((0 until start.size).count { coarse.speed(it, 0) != start.speed(it, 0) } > 50)
    }

    @Test
    fun `momentum stays, and a thermostat keeps the energy around a mean of 0`() {
        val free = simulationOf(gas(200, 5), growing(0.2), 0.1)
        val before = free.conserved()
        repeat(10) { free.advance() }
        assertEquals(before.momentumX, free.conserved().momentumX, 1e-12)
        assertEquals(before.momentumZ, free.conserved().momentumZ, 1e-12)
        assertTrue(free.conserved().kineticEnergy > 1.1 * before.kineticEnergy)

        val kept = simulationOf(gas(200, 5), growing(0.2, thermostat = true), 0.1)
        kept.advance()
        val first = kept.conserved()
        val mean = sqrt(
            before.momentumX * before.momentumX + before.momentumY * before.momentumY +
                before.momentumZ * before.momentumZ,
        )
        val peculiar = before.kineticEnergy - mean * mean / before.mass / 2
        assertEquals(peculiar, first.kineticEnergy, 1e-12 * peculiar)
        repeat(20) { kept.advance() }
        assertEquals(peculiar, kept.conserved().kineticEnergy, 1e-12 * peculiar)
        assertEquals(0.0, kept.conserved().momentumY, 1e-12)
    }

    @Test
    fun `no two spheres overlap, in exact arithmetic, and each state starts a run`() {
        val simulation = simulationOf(gas(200, 7) { it.nextDouble(0.5, 1.0) }, growing(0.4, thermostat = true), 0.05)
        repeat(30) {
            simulation.advance()
            assertInvariants(simulation, 1e-13)
            if (it % 10 == 9) assertTrue(deepestExactly(simulation.population) < BigDecimal("1e-13"))
        }
        assertTrue(filling(simulation.population) > 0.3) { "${filling(simulation.population)}" }
    }

    /** Of all pairs, at nearest images, relative to the sum of radii squared. */
    private fun deepestExactly(p: Population): BigDecimal {
        var deepest = BigDecimal(-1)
        for (i in 0 until p.size) {
            for (j in 0 until i) {
                var square = BigDecimal.ZERO
                for (axis in 0..2) {
                    val length = BigDecimal(box.length(axis))
                    val apart = (BigDecimal(p.position(axis)[i]) - BigDecimal(p.position(axis)[j])).abs()
                    val least = apart.min((length - apart).abs())
                    square += least * least
                }
                val sum = BigDecimal(p.radius[i]) + BigDecimal(p.radius[j])
                val depth = (sum * sum - square).divide(sum * sum, MathContext.DECIMAL128)
                deepest = deepest.max(depth)
            }
        }
        return deepest
    }

    private fun filling(p: Population) = p.radius.sumOf { 4.0 / 3 * Math.PI * it * it * it } / box.volume

    @Test
    fun `a step that fails leaves everything as it was, radii too, and can be done again`() {
        var fails = false
        val force = object : Force {
            override fun beforeDrift(population: Population, start: Double, duration: Double) = Unit

            override fun afterDrift(population: Population, end: Double, duration: Double) {
                check(!fails) { "asked to" }
            }
        }
        fun simulation() = Simulation.builder(gas(100, 9)).boundary(growing(0.2, thermostat = true))
            .restitution { 1.0 }.timeStep(0.1).force(force).build()
        val one = simulation()
        val other = simulation()
        repeat(3) {
            fails = true
            val before = stateDigest(one.population)
            assertThrows(IllegalStateException::class.java) { one.advance() }
            assertEquals(before, stateDigest(one.population))
            fails = false
            one.advance()
            other.advance()
            assertEquals(stateDigest(other.population), stateDigest(one.population))
        }
    }

    @Test
    fun `the energy that growth gives tells the pressure of Carnahan and Starling`() {
        val cube = Box.centred(12.0, 12.0, 12.0)
        val boundary = growing(0.002, thermostat = true, box = cube)
        val p = randomSpheres(400, boundary, 11, 1.0) { 0.6 }
        val simulation = simulationOf(p, boundary, 0.1)
        assertTrue(boundary.reducedPressure.isNaN())
        repeat(20) { simulation.advance() }
        var seen = 0.0
        var expected = 0.0
        repeat(400) {
            simulation.advance()
            seen += boundary.reducedPressure
            val phi = p.radius.sumOf { r -> 4.0 / 3 * Math.PI * r * r * r } / cube.volume
            expected += (1 + phi + phi * phi - phi * phi * phi) / Math.pow(1 - phi, 3.0)
        }
        // 50,000 collisions; 12 seeds scatter by 0.4 %.
        assertEquals(expected / 400, seen / 400, 0.015 * expected / 400)
    }

    @Test
    fun `what grows too fast, shrinks away, or has another drift is refused`() {
        assertThrows(IllegalArgumentException::class.java) { growing(0.0) }
        assertThrows(IllegalArgumentException::class.java) { growing(Double.NaN) }
        assertThrows(IllegalArgumentException::class.java) { growing(0.1, box = Box.UNBOUNDED) }
        val fast = simulationOf(gas(10, 1), growing(1.1), 0.1)
        val message = assertThrows(IllegalArgumentException::class.java) { fast.advance() }.message!!
        assertTrue("a tenth at most" in message) { message }
        val crowded = simulationOf(populationOf(Sphere(r = 5.9)), growing(0.1), 0.1)
        crowded.advance()
        val own = assertThrows(IllegalArgumentException::class.java) { crowded.advance() }.message!!
        assertTrue("its own image" in own) { own }
        val vanishing = simulationOf(gas(10, 1), growing(-0.09), 1.0)
        repeat(2) { vanishing.advance() }
        assertThrows(IllegalArgumentException::class.java) { vanishing.advance() }
        val frame: Drift = HillFrame(0.1)
        assertThrows(IllegalArgumentException::class.java) {
            Simulation.builder(gas(10, 1)).boundary(growing(0.1)).restitution { 1.0 }.timeStep(0.1).force(frame).build()
        }
    }

    @Test
    fun `one sphere, and a few at rest or in one flight, tell no pressure and stay finite`() {
        for (count in 1..3) {
            for (rate in listOf(-1.0, 0.01, 0.3, 10.0)) {
                for (speed in listOf(0.0, 1.0, 1e3)) {
                    val spheres = Array(count) { Sphere(-7.0 + 5 * it, 2.1, 3.3, speed, -0.7 * speed, r = 0.1) }
                    val boundary = growing(rate, thermostat = true)
                    val simulation = simulationOf(populationOf(*spheres), boundary, 0.01)
                    repeat(20) {
                        simulation.advance()
                        val p = simulation.population
                        assertTrue(boundary.reducedPressure.isNaN()) { "$count, $rate, $speed" }
                        assertTrue((0..2).all { p.position(it).all(Double::isFinite) })
                        assertEquals(speed, p.speed(0, 0), 1e-9 * (speed + abs(rate)))
                    }
                }
            }
        }
    }

    @Test
    fun `two spheres in motion relative to each other have a pressure and keep their energy`() {
        val boundary = growing(0.3, thermostat = true)
        val simulation = simulationOf(populationOf(Sphere(-3.0, 0.0, 0.0, 1e-3), Sphere(3.0)), boundary, 0.1)
        repeat(10) {
            simulation.advance()
            assertEquals(1.0, boundary.reducedPressure, 1e-9)
            assertEquals(5e-4, abs(simulation.population.speed(0, 0)), 1e-15)
        }
    }

    @Test
    fun `radii count from the time that is given, and kicks act on true velocities`() {
        val boundary = growing(0.1, from = -10.0)
        assertEquals(2.0, boundary.scaleAt(0.0), 1e-15)
        val kick = Kick { p, _, duration -> for (k in 0 until p.size) p.vz[k] += duration }
        val simulation = Simulation.builder(populationOf(Sphere(3.0, 2.0, 1.0, r = 0.5))).boundary(boundary)
            .withoutCollisions().timeStep(0.5).kick(kick).build()
        repeat(4) { simulation.advance() }
        assertEquals(2.0, simulation.population.vz[0], 1e-14)
        assertEquals(1.0 + 2.0, simulation.population.z[0], 1e-14)
        assertEquals(0.55, simulation.population.radius[0], 1e-15)
    }
}
