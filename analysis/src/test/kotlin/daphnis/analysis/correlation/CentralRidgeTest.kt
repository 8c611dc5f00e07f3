package daphnis.analysis.correlation

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

@Tag("thorough")
class CentralRidgeTest {
    private val sheet = HillSheet(Box.centred(60.0, 72.0, 2.0), 1.0)

    /** [clumps] streaks of 40 particles each, at places without order, longer along [pitch] than across. */
    private fun streaks(clumps: Int, pitch: Double, long: Double, short: Double, random: SeededRandom): State {
        val state = uniform(40 * clumps, sheet, random.nextLong())
        val (x, y) = state.population.x to state.population.y
        for (k in x.indices) {
            val centre = k - k % 40
            if (k == centre) continue
            val along = long * random.nextGaussian()
            val across = short * random.nextGaussian()
            x[k] = within(x[centre] - along * sin(pitch) + across * cos(pitch), 60.0)
            y[k] = within(y[centre] + along * cos(pitch) + across * sin(pitch), 72.0)
        }
        return State(state.population, sheet, 0.0)
    }

    private fun within(v: Double, length: Double) = v - length * Math.floor((v + length / 2) / length)

    private fun ridge(states: List<State>): CentralRidge? {
        lateinit var map: SurfaceMap
        val maps = states.map { SurfaceMap.of(it, 2.0).also { m -> map = m }.autocorrelation(14, 16) }
        return CentralRidge.of(maps, 14, 16, map.dx, map.dy)
    }

    @Test
    fun `streaks that do not repeat have the pitch they were made with, and errors that cover it`() {
        val random = SeededRandom(7)
        for (pitch in listOf(0.35, -0.9)) {
            val found = List(RUNS) { ridge(List(20) { streaks(25, pitch, 6.0, 1.5, random) })!!.pitch }
            val covered = found.count { abs(it.mean - pitch) <= it.error }
            assertTrue(covered in RUNS * 58 / 100..RUNS * 77 / 100) { "$pitch: $covered of $RUNS" }
            val spread = sqrt(found.sumOf { (it.mean - pitch) * (it.mean - pitch) } / RUNS)
            assertEquals(1.0, spread / found.map { it.error }.average(), 0.2) { "$pitch" }
        }
    }

    @Test
    fun `a ridge along the orbit or across it is found on both sides of a right angle`() {
        val random = SeededRandom(8)
        for (pitch in listOf(0.0, PI / 2)) {
            val away = List(40) {
                val found = ridge(List(20) { streaks(25, pitch, 6.0, 1.5, random) })!!.pitch
                (found.mean - pitch - PI * Math.rint((found.mean - pitch) / PI)) / found.error
            }
            assertTrue(abs(away.average()) < 0.5) { "$pitch: off by ${away.average()} errors" }
            assertEquals(1.0, sqrt(away.sumOf { it * it } / away.size), 0.3) { "$pitch" }
        }
    }

    @Test
    fun `a uniform patch and round clumps have no ridge, nor have a single state's too few lags`() {
        val random = SeededRandom(9)
        val uniform = (1..200).count { ridge(listOf(uniform(1000, sheet, random.nextLong()))) != null }
        assertTrue(uniform <= 2) { "$uniform of 200 uniform patches" }
        val round = (1..100).count { ridge(List(4) { streaks(25, 0.0, 2.0, 2.0, random) }) != null }
        assertTrue(round <= 2) { "$round of 100 patches of round clumps" }
        assertNull(CentralRidge.of(emptyList(), 10, 10, 1.0, 1.0))
        assertNull(CentralRidge.of(listOf(DoubleArray(25) { 1.0 }), 2, 2, 1.0, 1.0))
        val one = ridge(listOf(streaks(25, 0.35, 6.0, 1.5, random)))!!
        assertTrue(one.pitch.error.isNaN() && abs(one.pitch.mean - 0.35) < 0.3)
    }

    private companion object {
        const val RUNS = 100
    }
}
