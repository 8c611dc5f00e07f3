package daphnis.core.force.thermostat

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.OpenPlane
import daphnis.core.force.Force
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.population.Conserved
import daphnis.core.population.Population
import daphnis.core.population.granularTemperature
import daphnis.core.population.stateDigest
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.exp
import kotlin.math.sqrt

/** Thermostats without collisions, where what they do is known. */
class ThermostatTest {
    private fun spheres(n: Int, mass: (Int) -> Double = { 1.0 }, drift: Double = 0.0): Population {
        val random = SeededRandom(3)
        fun column(width: Double) = DoubleArray(n) { width * random.nextGaussian() }
        val vx = column(0.5)
        for (k in vx.indices) vx[k] += drift
        val radii = DoubleArray(n) { 0.1 }
        val masses = DoubleArray(n) { mass(it) }
        return Population(column(9.0), column(9.0), column(9.0), vx, column(0.5), column(0.5), radii, masses)
    }

    private val all: Map<String, (BoundaryConditions, Int) -> Thermostat> = mapOf(
        "noise" to { f, b -> WhiteNoise(7, 0.3, boundary = f, firstBody = b) },
        "noise that conserves momentum" to
            { f, b -> WhiteNoise(7, 0.3, 0.2, conservesMomentum = true, boundary = f, firstBody = b) },
        "bath" to { f, b -> WhiteNoise(7, 0.4, 0.2, overMass = true, boundary = f, firstBody = b) },
        "Andersen" to { f, b -> Andersen(7, 2.0, 1.0, conservesMomentum = true, boundary = f, firstBody = b) },
        "scaling" to { f, b -> Rescaling(2.0, 0.3, f, b) },
    )

    private fun steps(force: Force, p: Population, count: Int, h: Double = 0.1, from: Double = 0.0) {
        repeat(count) {
            force.beforeDrift(p, from + it * h, h)
            force.afterDrift(p, from + (it + 1) * h, h)
        }
    }

    /** Σ m w²/3(N − 1) without a flow. */
    private fun temperature(p: Population) = granularTemperature(p, Open) * p.mass.average()

    private fun shuffled(p: Population): Population {
        val order = IntArray(p.size) { (it * 7 + 11) % p.size }
        fun of(c: DoubleArray) = DoubleArray(c.size) { c[order[it]] }
        return Population(of(p.x), of(p.y), of(p.z), of(p.vx), of(p.vy), of(p.vz), of(p.radius), of(p.mass), order)
    }

    @Test
    fun `bits do not depend on threads or order, and bodies are left alone`() {
        val mass = { k: Int -> 1.0 + k % 3 }
        for ((name, make) in all) {
            val flow = LeesEdwards(Box.centred(9.0, 9.0, 9.0), 0.2)
            val p = spheres(COUNT, mass)
            steps(make(flow, COUNT - 10), p, 3)
            val q = shuffled(spheres(COUNT, mass))
            FixedPool(3).use {
                val thermostat = make(flow, COUNT - 10)
                thermostat.useLoop(ParallelLoop(it, LoopStrategy.DYNAMIC))
                steps(thermostat, q, 3)
            }
            assertEquals(stateDigest(p), stateDigest(q), name)
            val start = spheres(COUNT, mass)
            for (id in 0 until COUNT) assertEquals(id >= COUNT - 10, start.vy[id] == p.vy[id], "$name, $id")
        }
    }

    @Test
    fun `momentum stays where that is asked for, and only there`() {
        for ((name, make) in all) {
            val p = spheres(COUNT, { 1.0 + it % 3 }, drift = 1.0)
            val before = Conserved.of(p)
            steps(make(Open, Int.MAX_VALUE), p, 10)
            val after = Conserved.of(p)
            val change = listOf(
                after.momentumX - before.momentumX,
                after.momentumY - before.momentumY,
                after.momentumZ - before.momentumZ,
            ).maxOf { abs(it) } / after.mass
            if (name == "noise" || name == "bath") {
                assertTrue(change > 1e-4, "$name: $change")
            } else {
                assertTrue(change < 1e-14, "$name: $change")
            }
        }
    }

    @Test
    fun `noise heats by its intensity, whatever the length of a step, and a start of a step is not its end`() {
        for (h in listOf(0.01, 0.1, 1.0)) {
            val p = spheres(COUNT)
            val before = temperature(p)
            val steps = (2 / h).toInt()
            steps(WhiteNoise(7, 0.6), p, steps, h)
            // Two halves of a step have numbers of their own, also where one step ends and the next begins: the sum of
            // 2 steps kicks has the variance of independent ones.
            val gained = temperature(p) - before
            assertEquals(1.2, gained, 4 * 1.2 * sqrt(2.0 / (3 * COUNT)) * 2, "h = $h")
        }
    }

    @Test
    fun `a bath makes Maxwellians of its temperature for every mass, and drag stops a stream`() {
        val p = spheres(COUNT, { if (it % 2 == 0) 1.0 else 8.0 }, drift = 5.0)
        steps(WhiteNoise(7, 2 * 0.5 * 1.3, 0.5, overMass = true), p, 20, 1.0)
        for (parity in 0..1) {
            val mass = if (parity == 0) 1.0 else 8.0
            val of = (0 until COUNT).filter { it % 2 == parity }
            val t =
                of.sumOf { mass * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) } / (3 * of.size)
            assertEquals(1.3, t, 4 * 1.3 * sqrt(2.0 / (3 * of.size)), "mass $mass")
            assertEquals(5 * exp(-10.0), of.sumOf { p.vx[it] } / of.size, 4 * sqrt(1.3 / mass / of.size))
        }
    }

    @Test
    fun `Andersen's bath replaces as many as it should`() {
        val p = spheres(COUNT, { 2.0 })
        val start = p.copy()
        steps(Andersen(7, 0.7, 3.0), p, 1, 1.0)
        val changed = (0 until COUNT).filter { p.vx[it] != start.vx[it] }
        val chance = 1 - exp(-0.7)
        assertEquals(chance, changed.size.toDouble() / COUNT, 4 * sqrt(chance * (1 - chance) / COUNT))
        val t =
            changed.sumOf { 2 * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) } / (3 * changed.size)
        assertEquals(3.0, t, 4 * 3 * sqrt(2.0 / (3 * changed.size)))
    }

    @Test
    fun `scaling makes the temperature at once, or as fast as it relaxes`() {
        val p = spheres(COUNT, { 1.0 + it % 3 }, drift = 2.0)
        steps(Rescaling(0.8), p, 1)
        assertEquals(0.8, temperature(p), 1e-13)
        steps(Rescaling(2.8, 0.5), p, 10)
        assertEquals(2.8 - 2 * exp(-2.0), temperature(p), 1e-12)
        val cold = spheres(3).apply { for (axis in 0..2) velocity(axis).fill(0.25) }
        steps(Rescaling(1.0), cold, 2)
        assertArrayEquals(DoubleArray(3) { 0.25 }, cold.vx, "what is at rest stays so")
        val one = spheres(1)
        val v = one.vx[0]
        steps(Rescaling(1.0), one, 2)
        assertEquals(v, one.vx[0])
    }

    @Test
    fun `scaling knows the flow`() {
        val flow = LeesEdwards(Box.centred(9.0, 9.0, 9.0), 0.2)
        val p = spheres(COUNT)
        for (k in 0 until COUNT) p.vx[k] += 0.2 * p.y[k]
        val still = spheres(COUNT)
        steps(Rescaling(0.8, 0.0, flow), p, 1)
        steps(Rescaling(0.8), still, 1)
        for (k in 0 until COUNT) assertEquals(still.vx[k], p.vx[k] - 0.2 * p.y[k], 1e-12)
    }

    @Test
    fun `discs get nothing along z, and have two components`() {
        for ((name, make) in all) {
            val p = spheres(COUNT).apply {
                z.fill(0.0)
                vz.fill(0.0)
            }
            steps(make(OpenPlane, Int.MAX_VALUE), p, 20, 1.0)
            assertTrue(p.vz.all { it == 0.0 }, name)
            val t = (0 until COUNT).sumOf { p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] } / (2 * COUNT)
            if (name == "bath") assertEquals(1.0, t, 4 * sqrt(1.0 / COUNT), name)
            if (name == "scaling") assertEquals(2.0, t, 0.001, name)
        }
    }

    @Test
    fun `numbers out of range are refused`() {
        for (bad in listOf(-1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { WhiteNoise(1, bad) }
            assertThrows(IllegalArgumentException::class.java) { WhiteNoise(1, 1.0, bad) }
            assertThrows(IllegalArgumentException::class.java) { Andersen(1, bad, 1.0) }
            assertThrows(IllegalArgumentException::class.java) { Andersen(1, 1.0, bad) }
            assertThrows(IllegalArgumentException::class.java) { Rescaling(bad) }
            assertThrows(IllegalArgumentException::class.java) { Rescaling(1.0, bad) }
        }
    }

    private companion object {
        const val COUNT = 9_000
    }
}
