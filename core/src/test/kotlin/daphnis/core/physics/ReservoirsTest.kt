package daphnis.core.physics

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.source.Mean
import daphnis.core.source.SourceSums
import daphnis.core.source.blocks
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/** Gases that sources, sinks and reservoirs keep up. */
@Tag("physics")
class ReservoirsTest {
    /** Runs the scenario and shows [see] each step. */
    private fun run(text: String, see: (Simulation, SourceSums) -> Unit) {
        val setup = ScenarioSetup.of(ScenarioJson.parse(text, "test"), "test")
        Simulation(
            setup.population,
            setup.boundary,
            setup.collisions(),
            setup.timeStep,
            outputs = listOf(Output { if (it.step > 0) see(it, it.sources!!.sums) }),
            sources = setup.sources,
        ).use { while (it.time < setup.scenario.end - 1e-9) it.advance() }
    }

    private fun gas(sources: String, until: Int, seed: Int, filling: Double = 0.1, axes: String = "x") = """{
        "seed": $seed, "box": {"lengths": [12, 6, 6]}, "boundary": {"type": "walls", "axes": "$axes"},
        "particles": {"fillingFactor": $filling, "sizes": {"type": "equal", "radius": 0.5}, "mass": 1.0},
        "velocities": {"type": "gaussian", "sigma": 1.0}, "restitution": {"type": "constant", "coefficient": 1},
        "timeStep": {"type": "fixed", "dt": 0.1}, "until": $until, "sources": [$sources]}"""

    private fun reservoir(from: Double, to: Double, filling: Double, more: String = "") =
        """{"type": "reservoir", "region": {"x": [$from, $to]}, "fillingFactor": $filling, "temperature": 1$more}"""

    @Test
    fun `a box between two reservoirs has their density everywhere, and its number varies as theory says`() {
        val ends = reservoir(-6.0, -3.0, 0.1, ", \"trials\": 100") + "," + reservoir(3.0, 6.0, 0.1, ", \"trials\": 100")
        val number = ArrayList<Double>()
        val energy = ArrayList<Double>()
        val text = gas(
            ends,
            if (fullPhysics) 4_000 else 600,
            1,
        ).replace("\"type\": \"walls\", \"axes\": \"x\"", "\"type\": \"periodic\"")
        run(text) { it, _ ->
            val p = it.population
            number += p.size.toDouble()
            energy += (0 until p.size).sumOf { k -> p.vx[k] * p.vx[k] + p.vy[k] * p.vy[k] + p.vz[k] * p.vz[k] } / p.size
        }
        val all = number.drop(200)
        val mean = blocks(all)
        val expected = 0.1 * 432 / (PI / 6)
        println("N = $mean of $expected")
        assertTrue(abs(mean.value - expected) < 4 * mean.error && mean.error < 0.01 * expected) { "$mean" }
        val variance = blocks(all.map { (it - mean.value) * (it - mean.value) / mean.value })
        println("variance/N = $variance")
        assertTrue(abs(variance.value - 0.4569) < 4 * variance.error && variance.error < 0.06) { "$variance" }
        val temperature = blocks(energy.drop(200).map { it / 3 })
        assertTrue(abs(temperature.value - 1) < 4 * temperature.error && temperature.error < 0.02) { "$temperature" }
    }

    @Test
    fun `between reservoirs of different density there is one flux through all planes`() {
        val ends = reservoir(-6.0, -3.0, 0.15, ", \"trials\": 300") + "," + reservoir(3.0, 6.0, 0.03)
        val flux = List(3) { ArrayList<Double>() }
        val came = List(2) { ArrayList<Double>() }
        val slabs = List(3) { ArrayList<Double>() }
        run(gas(ends, if (fullPhysics) 4_000 else 500, 2)) { it, sums ->
            if (it.time < 50) return@run
            val p = it.population
            for (s in 0..2) {
                val inside = (0 until p.size).filter { k -> p.x[k] >= -3 + 2 * s && p.x[k] < -1 + 2 * s }
                // Momentum per length: what goes through a plane per time, on average over the slab.
                flux[s] += inside.sumOf { k -> p.vx[k] } / 2
                slabs[s] += inside.size.toDouble()
            }
            for (s in 0..1) came[s] += (sums.came(s) - sums.left(s)) / 0.1
        }
        val all = (flux + came).map { blocks(it) }
        println("flux through slabs and from reservoirs $all, spheres in slabs ${slabs.map { it.average() }}")
        assertTrue(slabs[0].average() > slabs[1].average() && slabs[1].average() > slabs[2].average())
        val from = all[3]
        assertTrue(from.value > 15 * from.error) { "$from" }
        fun assertSame(one: Mean, sign: Double) = assertTrue(
            abs(one.value - sign * from.value) < 4 * sqrt(one.error * one.error + from.error * from.error),
        ) { "$one and $from" }
        for (s in 0..2) assertSame(all[s], 1.0)
        assertSame(all[4], -1.0)
    }

    @Test
    fun `what effuses from a dilute gas is n√(T÷2π) per area, with a mean energy of 2T`() {
        var covered = 0
        val seeds = 1..if (fullPhysics) 40 else 12
        for (seed in seeds) {
            // Of points: so many trials renew the gas in each step, and what gets beyond x = 2 is a first flight.
            val points = """"sizes": {"type": "equal", "radius": 1e-4}"""
            val n = 2.0
            val filling = n * 4 / 3 * PI * 1e-12
            val sources = """{"type": "outflow", "region": {"x": [2, 6]}},""" +
                reservoir(-6.0, 2.0, filling, ", \"trials\": 4000, \"particles\": {$points}")
            val text = gas(
                sources,
                30,
                seed,
                filling,
            ).replace("\"sizes\": {\"type\": \"equal\", \"radius\": 0.5}", points)
            val left = ArrayList<Double>()
            var energy = 0.0
            run(text) { it, sums ->
                // The first of these were there at the start.
                if (it.step == 1L) return@run
                left += sums.left(0).toDouble()
                energy -= sums.energy(0)
            }
            val count = left.sum()
            val rate = count / (0.1 * left.size * 36)
            val error = rate / sqrt(count)
            val expected = n * 0.39894228
            assertTrue(abs(rate - expected) < 4 * error) { "seed $seed: $rate ± $error, expected $expected" }
            if (abs(rate - expected) < error) covered++
            assertEquals(2.0, energy / count, 4 * sqrt(2 / count)) { "seed $seed" }
        }
        println("$covered of ${seeds.count()} within an error")
        assertTrue(covered > 0.4 * seeds.count() && covered < seeds.count()) { "$covered" }
    }
}
