package daphnis.app.bench

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.util.Random

class TimingComparisonTest {
    private fun timing(vararg seconds: Double) = timing(10, "", seconds.asList())

    private fun timing(steps: Long, java: String, seconds: List<Double>) =
        Timing("gas", 1000, "serial", 1, steps, 500, seconds, seconds.map { Double.NaN }, java)

    private fun pair(old: Timing, new: Timing) = TimingComparison(listOf(old), listOf(new)).pairs.single()

    private fun verdict(old: Timing, new: Timing) = pair(old, new).verdict

    @Test
    fun `rounds that do not overlap have a verdict`() {
        val old = timing(1.0, 1.1, 1.2)
        assertEquals(Verdict.SLOWER, verdict(old, timing(1.3, 1.25, 1.4)))
        assertEquals(Verdict.FASTER, verdict(old, timing(0.99, 0.8, 0.9)))
        assertEquals(Verdict.UNKNOWN, verdict(old, timing(1.19, 1.4, 1.5)))
        assertEquals(Verdict.UNKNOWN, verdict(old, timing(0.8, 0.9, 1.01)))
    }

    @Test
    fun `one round tells nothing, nor do two`() {
        assertEquals(Verdict.UNKNOWN, verdict(timing(1.0), timing(9.0)))
        assertEquals(Verdict.UNKNOWN, verdict(timing(1.0, 1.0), timing(9.0, 9.0)))
        assertEquals(Verdict.UNKNOWN, verdict(timing(*DoubleArray(50) { 1.0 + it * 0.001 }), timing(9.0)))
        assertEquals(9.0, pair(timing(1.0), timing(9.0)).ratio)
    }

    @Test
    fun `less than three percent is no change, and the same is said only when it is seen`() {
        val old = timing(1.000, 1.001, 1.002)
        assertEquals(Verdict.SAME, verdict(old, timing(1.01, 1.011, 1.012)))
        assertEquals(Verdict.SAME, verdict(old, old))
        assertEquals(Verdict.SLOWER, verdict(old, timing(1.04, 1.05, 1.06)))
        assertEquals(Verdict.FASTER, verdict(timing(1.04, 1.05, 1.06), old))
        assertEquals(Verdict.UNKNOWN, verdict(timing(1.0, 1.1, 1.2), timing(1.0, 1.1, 1.2)))
    }

    @Test
    fun `a round that was disturbed does not decide`() {
        val old = timing(1.00, 1.01, 1.02, 1.03, 1.04, 1.05, 9.0)
        assertEquals(Verdict.SLOWER, verdict(old, timing(1.20, 1.21, 1.22, 1.23, 1.24, 1.25, 1.26)))
        assertEquals(1.19, pair(old, timing(1.20, 1.21, 1.22, 1.23, 1.24, 1.25, 1.26)).ratio, 0.02)
    }

    @Test
    fun `the interval is that of the tables of Mann and Whitney`() {
        // Critical values of U at 5 % on one side, of which the interval leaves out as many ratios and one more less.
        for ((sizes, critical) in mapOf((3 to 3) to 0, (4 to 4) to 1, (5 to 5) to 4, (5 to 8) to 8, (10 to 10) to 27)) {
            val (m, n) = sizes
            // Ratios 2^(k + 1): ascending, so that each says its own place.
            val new = List(m) { Math.pow(2.0, it.toDouble() * n) }
            val old = List(n) { Math.pow(2.0, -it.toDouble()) }
            val interval = RankInterval.of(new, old)!!
            assertEquals(critical.toDouble(), log2(interval.low), 1e-9) { "$m and $n" }
            assertEquals((m * n - 1 - critical).toDouble(), log2(interval.high), 1e-9) { "$m and $n" }
        }
        for ((m, n) in listOf(2 to 2, 2 to 4, 1 to 100)) assertNull(RankInterval.of(List(m) { 1.0 }, List(n) { 1.0 }))
    }

    private fun log2(value: Double) = Math.log(value) / Math.log(2.0)

    @Tag("thorough")
    @Test
    fun `nine intervals of ten hold the true ratio, also of many rounds`() {
        val random = Random(7)
        for (rounds in listOf(6, 30)) {
            fun sample(scale: Double) = List(rounds) { scale * Math.exp(0.3 * random.nextGaussian()) }
            val inside = (1..2000).count {
                RankInterval.of(sample(1.5), sample(1.0))!!.let { 1.5 in it.low..it.high }
            }
            assertTrue(inside in 1750..1890) { "$rounds rounds: $inside of 2000" }
        }
    }

    @Test
    fun `other steps are not compared, and named`() {
        val old = timing(1.0)
        val new = timing(20, "", listOf(1.0))
        val comparison = TimingComparison(listOf(old), listOf(new))
        assertTrue(comparison.pairs.isEmpty())
        assertEquals(2, comparison.unmatched.size)
        assertTrue("20 steps" in comparison.unmatched[0]) { comparison.unmatched[0] }
    }

    @Test
    fun `another Java is named where it is known`() {
        fun said(old: String, new: String) =
            TimingComparison(listOf(timing(10, old, listOf(1.0))), listOf(timing(10, new, listOf(1.0)))).otherJava()
        assertEquals("the first was timed with Java 17.0.9, the second with Java 25", said("17.0.9", "25"))
        for ((old, new) in listOf("25" to "25", "" to "25", "25" to "")) assertNull(said(old, new))
    }
}
