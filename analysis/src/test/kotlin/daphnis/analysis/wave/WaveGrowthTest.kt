package daphnis.analysis.wave

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs

class WaveGrowthTest {
    private val frequency = 1.1

    /** Per unit of time. */
    private fun perTime(rate: Double) = rate / MadeWaves.PERIOD

    private class Coverage {
        var rate = 0
        var frequency = 0
        var found = 0
        val off = ArrayList<Double>()

        fun part(percent: Int) = found * percent / 100

        override fun toString() = "$rate and $frequency of $found cover, off by ${off.average()}"
    }

    private fun coverage(rate: Double, waves: (Int) -> WaveAmplitudes) = Coverage().apply {
        for (seed in 1..SEEDS) {
            val growth = WaveGrowth.of(waves(seed)) ?: continue
            if (!growth.isGrowing) continue
            found++
            off += growth.rate * MadeWaves.PERIOD - rate
            if (abs(growth.rate - perTime(rate)) < growth.rateError) this.rate++
            if (abs(growth.frequency - this@WaveGrowthTest.frequency) < growth.frequencyError) frequency++
        }
    }

    @Tag("thorough")
    @Test
    fun `errors of rate and frequency cover what was put in, under noise of particles and under driving`() {
        val all = ArrayList<Coverage>()
        for (rate in listOf(0.08, 0.12, 0.25)) {
            for (memory in listOf(0.1, 1.0)) {
                all += coverage(rate) { seed ->
                    val random = SeededRandom(seed.toLong())
                    val outward = MadeWaves.growing(rate, 0.12, 5.0, 2 * PI * random.nextDouble())
                    val inward = MadeWaves.growing(rate, 0.08, 3.0, 2 * PI * random.nextDouble())
                    MadeWaves.of(PERIODS, frequency, outward, inward, 0.25, memory, random)
                }
            }
            for (kick in listOf(0.03, 0.1)) {
                all += coverage(rate) { seed ->
                    val random = SeededRandom(seed.toLong())
                    val outward = MadeWaves.driven(rate, 0.1, 5.0, kick, random)
                    val inward = MadeWaves.driven(rate, 0.05, 5.0, kick, random)
                    MadeWaves.of(PERIODS, frequency, outward, inward, 0.1, 0.3, random)
                }
            }
        }
        val words = all.joinToString("\n")
        // Each kind of noise by itself is known less well than which kind it is.
        for (one in all) {
            assertTrue(one.found >= 0.95 * SEEDS) { words }
            assertTrue(one.rate in one.part(42)..one.part(82)) { words }
            assertTrue(one.frequency in one.part(50)..one.part(82)) { words }
            assertEquals(0.0, one.off.average(), 0.005) { words }
        }
        val found = all.sumOf { it.found }
        assertTrue(all.sumOf { it.rate } in found * 60 / 100..found * 75 / 100) { words }
        assertTrue(all.sumOf { it.frequency } in found * 60 / 100..found * 75 / 100) { words }
    }

    @Test
    fun `without noise the rate, the frequency and the directions are those of the waves`() {
        val zero = doubleArrayOf(0.0, 0.0)
        val free = MadeWaves.growing(0.1, 0.01, 1e9, 0.4)
        for ((outward, inward) in listOf(free to { _: Int -> zero }, { _: Int -> zero } to free, free to free)) {
            val waves = MadeWaves.of(40, frequency, outward, inward)
            val growth = WaveGrowth.of(waves)!!
            assertTrue(growth.isGrowing)
            assertEquals(0.1, growth.rate * MadeWaves.PERIOD, 1e-6)
            assertEquals(frequency, growth.frequency, 1e-6)
            val out = WaveAverages.direction(waves, 0.0).mean
            assertEquals(
                if (outward === inward) {
                    0.0
                } else if (outward === free) {
                    1.0
                } else {
                    -1.0
                },
                out,
                1e-2,
            )
            assertEquals(frequency, WaveAverages.frequency(waves, 0.0).mean, 1e-6)
        }
    }

    @Test
    fun `where nothing grows the rate is nothing within its error, and it is said`() {
        var covered = 0
        var grown = 0
        for (seed in 1..SEEDS) {
            val random = SeededRandom(seed.toLong())
            val still = { _: Int -> doubleArrayOf(0.0, 0.0) }
            val growth = WaveGrowth.of(MadeWaves.of(60, frequency, still, still, 0.3, 0.5, random))!!
            if (growth.isGrowing) grown++
            if (abs(growth.rate) < growth.rateError) covered++
        }
        assertEquals(0, grown)
        assertTrue(covered in SEEDS * 60 / 100..SEEDS * 76 / 100) { "$covered of $SEEDS" }
    }

    @Test
    fun `noise that fills an even start is no growth, though it rises by a factor of e`() {
        // As the wave of 66.7 radii of the scenario overstability does.
        val seen = listOf(0.09, 0.11, 0.2, 0.3, 0.48, 0.48, 0.45, 0.4, 0.6, 0.61, 0.58, 0.54)
        fun filling(before: Int) = MadeWaves.of(40, frequency, { k ->
            val period = k / MadeWaves.ROWS - before
            doubleArrayOf(seen.getOrElse(period) { if (it < 0) 0.09 else 0.75 + 0.02 * (it % 3) }, 0.0)
        })
        assertFalse(WaveGrowth.of(filling(0))!!.isGrowing)
        // The same rise is growth where it comes later.
        assertTrue(WaveGrowth.of(filling(10))!!.isGrowing)
    }

    @Test
    fun `a harmonic has a speed, but no growth, no frequency and no direction of epicycles`() {
        val growing = MadeWaves.growing(0.12, 0.1, 5.0, 0.4)
        val waves = MadeWaves.of(60, 2.3, growing)
        assertTrue(waves.coherence(0 until 60) < 0.1)
        assertEquals(5.0 / Math.sqrt(2.0), waves.rmsSpeed(59), 0.01)
        assertTrue(waves.coherentSpeed(59) < 1)
        val growth = WaveGrowth.of(waves)!!
        assertFalse(growth.isGrowing)
        assertTrue(growth.frequency.isNaN() && growth.frequencyError.isNaN())
        assertTrue(WaveAverages.frequency(waves, 0.0).mean.isNaN() && WaveAverages.direction(waves, 0.0).mean.isNaN())
        val epicyclic = MadeWaves.of(60, frequency, growing)
        assertTrue(epicyclic.coherence(0 until 60) in 0.9..1.0)
    }

    @Test
    fun `few periods, few rows and no motion tell nothing`() {
        val growing = MadeWaves.growing(0.1, 0.1, 5.0, 0.0)
        assertNull(WaveGrowth.of(MadeWaves.of(7, frequency, growing)))
        assertFalse(WaveGrowth.of(MadeWaves.of(8, frequency, growing)) == null)
        assertNull(WaveGrowth.of(MadeWaves.of(20, frequency, { doubleArrayOf(0.0, 0.0) })))
        val times = DoubleArray(30) { it * MadeWaves.PERIOD / 3 }
        val zero = times to times
        assertNull(WaveAmplitudes.of(times, zero, zero, MadeWaves.FREQUENCIES))
        assertNull(WaveAmplitudes.of(DoubleArray(0), DoubleArray(0) to DoubleArray(0), zero, MadeWaves.FREQUENCIES))
    }

    private companion object {
        const val SEEDS = 200
        const val PERIODS = 70
    }
}
