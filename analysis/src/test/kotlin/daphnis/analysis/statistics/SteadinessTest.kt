package daphnis.analysis.statistics

import daphnis.analysis.statistics.Steadiness.Verdict
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.exp
import kotlin.math.sqrt

class SteadinessTest {
    private fun noise(n: Int, memory: Double, random: SeededRandom): DoubleArray {
        val keep = if (memory == 0.0) 0.0 else exp(-1 / memory)
        var v = random.nextGaussian()
        return DoubleArray(n) { v.also { v = keep * v + sqrt(1 - keep * keep) * random.nextGaussian() } }
    }

    private fun drifting(n: Int, memory: Double, deviation: Double, seed: Long = 7, signal: (Double) -> Double): Int {
        val random = SeededRandom(seed)
        return (0 until REALISATIONS).count {
            val a = noise(n, memory, random)
            Steadiness.of(DoubleArray(n) { k -> deviation * a[k] + signal(k / n.toDouble()) }).verdict ==
                Verdict.DRIFTING
        }
    }

    @Test
    fun `a steady series is seldom called drifting`() {
        for ((n, memory, most) in listOf(
            Triple(
                30,
                0.0,
                0.02,
            ),
            Triple(
                100,
                0.0,
                0.02,
            ),
            Triple(1000, 0.0, 0.02), Triple(100, 1.0, 0.03), Triple(300, 3.0, 0.02), Triple(1000, 10.0, 0.02),
            Triple(5000, 50.0, 0.02), Triple(100, 5.0, 0.06), Triple(1000, 50.0, 0.06),
        )) {
            val alarms = drifting(n, memory, 1.0) { 0.0 }
            assertTrue(alarms <= most * REALISATIONS) { "$n numbers, memory $memory: $alarms of $REALISATIONS" }
        }
    }

    @Test
    fun `an oscillation of any period raises no false alarms, also one of just more periods than are looked at`() {
        // With S(0) by the twelve ordinates alone some 30 % at 12 periods.
        for ((n, periods) in listOf(300 to 12.0, 300 to 13.0, 116 to 12.0, 116 to 14.5, 116 to 40.6, 300 to 6.0)) {
            val random = SeededRandom(11)
            val alarms = (0 until REALISATIONS).count {
                val a = noise(n, 0.0, random)
                val phase = 2 * PI * random.nextDouble()
                Steadiness.of(DoubleArray(n) { a[it] + 2 * cos(2 * PI * periods * it / n + phase) }).verdict ==
                    Verdict.DRIFTING
            }
            assertTrue(alarms <= 0.08 * REALISATIONS) { "$n numbers, $periods periods: $alarms of $REALISATIONS" }
        }
    }

    @Test
    fun `a gas that cools, a transient and a slow drift are seen`() {
        val signals = listOf<Triple<String, Double, (Double) -> Double>>(
            Triple("cooling", 0.001) { 1 / ((1 + 4 * it) * (1 + 4 * it)) },
            Triple("cooling in noise", 0.1) { 1 / ((1 + 4 * it) * (1 + 4 * it)) },
            Triple("approach", 0.05) { 1 - exp(-it / 0.3) },
            Triple("short transient", 0.05) { 1 - exp(-it / 0.1) },
            Triple("slow drift", 1.0) { 4 * it },
        )
        for ((name, deviation, signal) in signals) {
            for (n in listOf(100, 1000)) {
                val seen = drifting(n, 2.0, deviation, signal = signal)
                assertTrue(seen >= 0.9 * REALISATIONS) { "$name, $n numbers: $seen of $REALISATIONS" }
            }
        }
    }

    /** Drifts of so many standard errors of the mean that are found among [REALISATIONS], in series of 300 numbers. */
    private fun found(memory: Double, errors: Double): Int {
        val random = SeededRandom(17)
        val keep = if (memory == 0.0) 0.0 else exp(-1 / memory)
        val error = sqrt((1 + keep) / (1 - keep) / 300)
        return (0 until REALISATIONS).count {
            val a = noise(300, memory, random)
            val drift = errors * error
            Steadiness.of(DoubleArray(300) { a[it] + drift * it / 299 }).verdict == Verdict.DRIFTING
        }
    }

    @Test
    fun `a drift is found as often as the error of a line allows`() {
        // A change of 10 standard errors of the mean is one of 2.9 of its own, and 15 are 4.3.
        for (memory in listOf(0.0, 1.0, 4.0)) {
            val found = listOf(5.0, 10.0, 15.0, 25.0).map { found(memory, it) / REALISATIONS.toDouble() }
            assertTrue(found[0] in 0.02..0.25 && found[1] in 0.33..0.6 && found[2] in 0.7..0.95 && found[3] > 0.97) {
                "memory $memory: $found"
            }
        }
    }

    @Test
    fun `of many steady series that are judged together hardly ever one drifts even among so many`() {
        for (judged in listOf(2, 4, 8)) {
            val random = SeededRandom(18)
            val alarms = (0 until REALISATIONS).count {
                (0 until judged).any { Steadiness.of(noise(200, 2.0, random)).isDriftingAmong(judged) }
            }
            assertTrue(alarms <= 0.02 * REALISATIONS) { "$judged judged: $alarms of $REALISATIONS" }
        }
        val line = Steadiness.of(DoubleArray(100) { it.toDouble() })
        assertTrue(line.isDriftingAmong(1000) && !line.steady().isDriftingAmong(1))
    }

    @Test
    fun `the largest change that may have been missed is larger than the true one in 95 of 100 cases`() {
        for ((n, memory) in listOf(30 to 0.0, 100 to 1.0, 1000 to 10.0, 200 to 10.0)) {
            for (change in listOf(0.3, 1.0)) {
                val random = SeededRandom(19)
                val all = List(REALISATIONS) {
                    val a = noise(n, memory, random)
                    Steadiness.of(DoubleArray(n) { a[it] + change * it / (n - 1) })
                }
                val held = all.count { it.largest >= change } / REALISATIONS.toDouble()
                assertTrue(held >= 0.92) { "$n numbers, memory $memory, change $change: $held" }
                // And it is no larger than it must be: an error of the line covers the truth in 60 to 80 %.
                val covered = all.count { abs(it.change - change) <= it.error } / REALISATIONS.toDouble()
                assertTrue(covered in 0.60..0.82) { "$n numbers, memory $memory, change $change: $covered" }
            }
        }
    }

    @Test
    fun `the change of a line is that of the line, whatever the noise`() {
        val random = SeededRandom(2)
        for (n in listOf(40, 1000)) {
            val a = noise(n, 0.0, random)
            val s = Steadiness.of(DoubleArray(n) { 5 - 3.0 * it / (n - 1) + 0.01 * a[it] })
            assertEquals(-3.0, s.change, 0.08)
            assertTrue(s.significance < -3 && s.verdict == Verdict.DRIFTING)
        }
    }

    @Test
    fun `the time from which a run is steady is that at which its transient ends`() {
        val random = SeededRandom(3)
        var sum = 0
        repeat(100) {
            val a = noise(1000, 2.0, random)
            val from = Steadiness.steadyFrom(DoubleArray(1000) { k -> a[k] + if (k < 200) 6 - 0.03 * k else 0.0 })
            assertTrue(from in 60..500) { "$from" }
            sum += from
        }
        assertTrue(sum / 100 in 140..240) { "${sum / 100}" }
        assertEquals(-1, Steadiness.steadyFrom(DoubleArray(1000) { it * 1.0 }))
        assertEquals(-1, Steadiness.steadyFrom(DoubleArray(40) { it * 1.0 }))
        assertEquals(0, Steadiness.steadyFrom(DoubleArray(100) { 7.0 }))
    }

    @Test
    fun `nothing, few numbers, NaN and a constant`() {
        for (a in listOf(
            DoubleArray(0),
            DoubleArray(23) { it * 1.0 },
            DoubleArray(50) {
                if (it == 3) {
                    Double.NaN
                } else {
                    1.0
                }
            },
        )) {
            val s = Steadiness.of(a)
            assertTrue(s.verdict == Verdict.TOO_SHORT && s.change.isNaN())
        }
        val constant = Steadiness.of(DoubleArray(100) { 2.5 })
        assertTrue(constant.verdict == Verdict.STEADY && abs(constant.change) < 1e-12)
        assertEquals(Verdict.DRIFTING, Steadiness.of(DoubleArray(100) { 2.5 * it }).verdict)
    }

    private companion object {
        const val REALISATIONS = 400
    }
}
