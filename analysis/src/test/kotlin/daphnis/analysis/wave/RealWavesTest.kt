package daphnis.analysis.wave

import daphnis.core.orbit.OrbitalFrequencies
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Growth and frequency in small real runs: `real-waves.txt` has the amplitudes by epicyclic period of modes 1 and 2 of
 * the scenario `overstability` with 360 steps in an orbit, seeds 1 to 24, for 40 orbits, and of the same at optical
 * depth 0.5, where nothing grows, for 60 orbits. A line is a run: optical depth, seed, mode, then real and imaginary
 * parts outward and inward, in hundredths of rΩ.
 */
class RealWavesTest {
    private class Run(val depth: Double, val mode: Int, val growth: WaveGrowth)

    private val runs: List<Run> by lazy {
        val lines = checkNotNull(javaClass.getResource("real-waves.txt")).readText().trim().lines()
        lines.map { line ->
            val numbers = line.split(' ').map { it.toDouble() }
            val amplitudes = numbers.drop(3).map { it / 100 }.chunked(4)
            val waves = (0..1).map { d ->
                Array(2) { part -> DoubleArray(amplitudes.size) { amplitudes[it][2 * d + part] } }
            }
            val frequencies = OrbitalFrequencies(1.0)
            Run(numbers[0], numbers[2].toInt(), checkNotNull(WaveGrowth.of(WaveAmplitudes.of(waves, frequencies))))
        }
    }

    private class Seeds(val values: List<Double>, val errors: List<Double>) {
        val mean = values.average()
        val spread = sqrt(values.sumOf { (it - mean) * (it - mean) } / (values.size - 1))
        val covered = values.indices.count { abs(values[it] - mean) < errors[it] }
        val ratio = spread / sqrt(errors.sumOf { it * it } / errors.size)

        override fun toString() = "mean $mean, $covered of ${values.size} cover, spread over ± $ratio"
    }

    private fun seeds(depth: Double, mode: Int, value: (WaveGrowth) -> Double, error: (WaveGrowth) -> Double) =
        runs.filter { it.depth == depth && it.mode == mode }.map { it.growth }.let { all ->
            assertEquals(24, all.size)
            Seeds(all.map(value), all.map(error))
        }

    private val kinds = listOf(1.64 to 1, 1.64 to 2, 0.5 to 1, 0.5 to 2)

    /** [covered] is of all 96 runs. */
    private fun check(what: String, all: List<Seeds>) {
        val words = what + all.joinToString("\n", "\n")
        assertTrue(all.sumOf { it.covered } in 57..73) { words }
        for (one in all) {
            assertTrue(one.covered in 11..22) { words }
            assertTrue(one.ratio in 0.55..1.45) { words }
        }
    }

    @Test
    fun `errors of growth rates cover the mean over seeds of real runs`() {
        val period = 2 * Math.PI
        val all = kinds.map { (depth, mode) -> seeds(depth, mode, { it.rate * period }, { it.rateError * period }) }
        check("rates", all)
        assertEquals(0.107, all[1].mean, 0.005)
    }

    @Test
    fun `errors of frequencies cover the mean over seeds of real runs`() {
        val all = kinds.map { (depth, mode) -> seeds(depth, mode, { it.frequency }, { it.frequencyError }) }
        check("frequencies", all)
        assertEquals(1.141, all[1].mean, 0.002)
    }

    @Test
    fun `the wave of a hundred radii grows with every seed, and none grows in a thin ring`() {
        assertTrue(runs.filter { it.depth > 1 && it.mode == 2 }.all { it.growth.isGrowing })
        assertTrue(runs.filter { it.depth < 1 }.none { it.growth.isGrowing })
    }
}
