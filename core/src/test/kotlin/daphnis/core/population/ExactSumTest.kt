package daphnis.core.population

import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import java.math.BigDecimal

class ExactSumTest {
    /** Ways to draw a term that are hard on a sum. */
    enum class Terms(val draw: (SeededRandom) -> Double) {
        ORDINARY({ it.nextGaussian() }),
        ANY_BITS({ Double.fromBits(it.nextLong()).let { d -> if (d.isFinite()) d / 4096 else 1.0 } }),
        WIDE({ Math.scalb(it.nextGaussian(), it.nextInt(200) - 100) }),
        SUBNORMAL({ Double.fromBits(it.nextLong() and ((1L shl 53) - 1)) * if (it.nextInt(2) == 0) 1 else -1 }),
        LARGEST({ if (it.nextInt(2) == 0) Double.MAX_VALUE else -Double.MAX_VALUE }),
        CANCELLING({ listOf(1e308, -1e308, 1.0, -1.0, 1e-308, -1e-308, Double.MIN_VALUE)[it.nextInt(7)] }),
        POWERS({ Math.scalb(if (it.nextInt(2) == 0) 1.0 else -1.0, it.nextInt(2046) - 1074) }),
        TIES({
            listOf(1.0, Math.ulp(1.0) / 2, -Math.ulp(1.0) / 2, Math.ulp(1.0), 2.0, Double.MIN_VALUE)[it.nextInt(6)]
        }),
        ZEROS({ if (it.nextInt(2) == 0) 0.0 else -0.0 }),
    }

    /** As the standard library sums and rounds. */
    private fun expected(terms: DoubleArray): Double =
        terms.fold(BigDecimal.ZERO) { sum, term -> sum.add(BigDecimal(term)) }.toDouble()

    private fun sumOf(terms: DoubleArray) = ExactSum().apply { addAll(terms) }

    private fun assertSame(expected: Double, found: Double, say: () -> String) {
        assertEquals(expected.toRawBits(), found.toRawBits()) { "${say()}: $found instead of $expected" }
    }

    @ParameterizedTest
    @EnumSource
    fun `a sum is the true one rounded once, whatever its terms, one by one and in blocks`(kind: Terms) {
        for (seed in 0L until 60) {
            val random = SeededRandom(seed)
            val terms = DoubleArray(1 + random.nextInt(if (seed == 0L) 9000 else 40)) { kind.draw(random) }
            val one = ExactSum()
            for (k in terms.indices) {
                one.add(terms[k])
                if (seed < 40 && k < 40) {
                    val first = expected(terms.copyOf(k + 1))
                    assertSame(first, one.value()) { "$kind, seed $seed, the first ${k + 1}" }
                }
            }
            assertSame(expected(terms), one.value()) { "$kind, seed $seed, one by one" }
            assertSame(expected(terms), sumOf(terms).value()) { "$kind, seed $seed, in blocks" }
        }
    }

    @Test
    fun `a block gives what its terms give one by one, to the last part, wherever it begins and however long it is`() {
        val lengths = (0..15) + (61..66) + listOf(4095, 4096, 4097, 4098, 4103, 4104, 4105, 8193)
        for (seed in 0L until 1500) {
            val random = SeededRandom(seed)
            val n = lengths[random.nextInt(if (seed % 8 == 0L) lengths.size else 22)]
            val from = random.nextInt(4)
            val greatest = random.nextInt(2047)
            val spread = listOf(0, 1, 5, 40, 80, 120, 400, 2046)[random.nextInt(8)]
            val kind = random.nextInt(6)
            val terms = DoubleArray(from + n) {
                val exponent = maxOf(0, greatest - random.nextInt(spread + 1)).toLong()
                val bits = random.nextLong()
                when {
                    kind == 0 && random.nextInt(20) == 0 -> -0.0
                    kind == 1 && random.nextInt(500) == 0 -> NOT_FINITE[random.nextInt(3)]
                    kind == 2 && random.nextInt(20) == 0 -> Double.MIN_VALUE * random.nextInt(5)
                    else -> Double.fromBits((bits and (-1L ushr 12 or Long.MIN_VALUE)) or (exponent shl 52))
                }
            }
            if (kind == 3) for (k in 1 until terms.size step 2) terms[k] = -terms[k - 1]
            val one = ExactSum()
            for (k in from until terms.size) one.add(terms[k])
            val all = ExactSum().apply { addAll(terms, from, terms.size) }
            assertEquals(one.parts(), all.parts()) {
                "seed $seed, $n terms from $from, 2^$greatest to 2^-$spread of it"
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    fun `parts in any number merge in any order to the same bits, and so do those that are written down`(kind: Terms) {
        for (seed in 0L until 20) {
            val random = SeededRandom(seed)
            val terms = DoubleArray(500) { kind.draw(random) }
            val parts = List(1 + random.nextInt(20)) { ExactSum() }
            for (term in terms) parts[random.nextInt(parts.size)].add(term)
            val order = parts.indices.sortedBy { random.nextLong() }
            val merged = ExactSum()
            for (k in order) merged.add(parts[k])
            val expected = expected(terms)
            assertSame(expected, merged.value()) { "$kind, seed $seed, ${parts.size} parts" }
            val written = ExactSum()
            for (k in order) written.addAll(parts[k].parts().toDoubleArray())
            assertSame(expected, written.value()) { "$kind, seed $seed, ${parts.size} parts, written down" }
            terms.forEach { merged.add(-it) }
            assertSame(0.0, merged.value()) { "$kind, seed $seed, all taken away again" }
            assertEquals(emptyList<Double>(), merged.parts())
        }
    }

    @Test
    fun `what overflows on the way is right at the end, and infinite if it is so then`() {
        val most = Double.MAX_VALUE
        assertEquals(most, sumOf(doubleArrayOf(most, most, most, -most, -most)).value())
        assertEquals(Double.POSITIVE_INFINITY, sumOf(doubleArrayOf(most, most)).value())
        assertEquals(Double.NEGATIVE_INFINITY, sumOf(doubleArrayOf(-most, -most)).value())
        val half = Math.ulp(most) / 2
        assertEquals(Double.POSITIVE_INFINITY, sumOf(doubleArrayOf(most, half)).value(), "a tie goes to the even one")
        assertEquals(most, sumOf(doubleArrayOf(most, Math.nextDown(half))).value())
        val held = sumOf(doubleArrayOf(most, most, most)).parts()
        assertEquals(most, sumOf(held.toDoubleArray() + doubleArrayOf(-most, -most)).value())
    }

    @Test
    fun `parts are few, and a sum far beyond the largest number is one infinity`() {
        val most = Double.MAX_VALUE
        val everyBit = ExactSum()
        for (exponent in -1074..1023 step 2) everyBit.add(Math.scalb(1.0, exponent))
        assertTrue(everyBit.parts().size in 35..40) { "${everyBit.parts().size}" }
        assertSame(0.0, sumOf(everyBit.parts().map { -it }.toDoubleArray()).apply { add(everyBit) }.value()) { "rest" }
        fun huge(times: Int) = ExactSum().apply { repeat(times) { add(-most) } }
        assertEquals(List(64) { -most }, huge(64).parts())
        assertEquals(listOf(Double.NEGATIVE_INFINITY), huge(65).parts())
        val doubled = huge(1).apply { repeat(60) { add(this) } }
        assertEquals(listOf(Double.NEGATIVE_INFINITY), doubled.parts())
    }

    @Test
    fun `infinities and NaN sum up as they do in plain addition, in any order and through merges`() {
        val inf = Double.POSITIVE_INFINITY
        for (times in listOf(1, 20)) {
            fun terms(vararg special: Double) = DoubleArray(times) { 1.0 } + special + DoubleArray(times) { -3e300 }
            assertEquals(inf, sumOf(terms(inf, inf)).value())
            assertEquals(-inf, sumOf(terms(-inf)).value())
            assertTrue(sumOf(terms(inf, -inf)).value().isNaN())
            assertTrue(sumOf(terms(Double.NaN)).value().isNaN())
            val merged = sumOf(terms(inf)).apply { add(sumOf(terms(-inf))) }
            assertTrue(merged.value().isNaN())
            merged.clear()
            assertEquals(0.0, merged.value())
        }
    }

    @Test
    fun `nothing and zeros of any sign make 0, and a cleared sum begins anew`() {
        assertSame(0.0, ExactSum().value()) { "of nothing" }
        assertSame(0.0, sumOf(doubleArrayOf(-0.0, -0.0)).value()) { "of negative zeros" }
        assertSame(0.0, sumOf(doubleArrayOf(-1.5, 1.5)).value()) { "of what cancels" }
        val sum = sumOf(DoubleArray(3000) { -1e300 })
        sum.clear()
        sum.add(Double.MIN_VALUE)
        assertEquals(Double.MIN_VALUE, sum.value())
    }

    @Test
    fun `many terms of the greatest mantissa do not run over, nor do many merges`() {
        val most = Double.fromBits(0x7FEFFFFFFFFFFFFF ushr 1)
        val sum = ExactSum()
        repeat(100_000) { sum.add(most) }
        assertEquals(BigDecimal(most).multiply(BigDecimal(100_000)).toDouble(), sum.value())
        val merged = ExactSum()
        repeat(100_000) { merged.add(sum) }
        assertEquals(BigDecimal(most).multiply(BigDecimal("1e10")).toDouble(), merged.value())
        val block = sumOf(DoubleArray(100_000) { most })
        assertEquals(sum.value(), block.value())
    }

    private companion object {
        val NOT_FINITE = listOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)
    }
}
