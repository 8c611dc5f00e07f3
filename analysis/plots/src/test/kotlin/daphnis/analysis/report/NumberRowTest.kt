package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.initial.SeededRandom
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.exp
import kotlin.math.sqrt

class NumberRowTest {
    @Test
    fun `an average over a time that is not steady is marked so, also where states are too few for an error`() {
        val rows = NumberRows()
        rows.average("a", "with an error", BlockAverage(2.0, 0.1, 40), "s")
        rows.average("b", "of few states", BlockAverage(2.0, Double.NaN, 4), "s")
        rows.exact("c", "of the particles", 2.0, "s")
        assertEquals(listOf(null, Unknown.TOO_FEW, null), rows.list().map { it.unknown })
        val unsteady = rows.list().map { it.unsteady() }
        assertEquals(listOf(Unknown.UNSTEADY, Unknown.UNSTEADY, null), unsteady.map { it.unknown })
        assertEquals(listOf(true, true, true), unsteady.map { it.error.isNaN() && it.value == 2.0 })
    }

    @Test
    fun `a time as much longer as is said gives an error as a rule, and an error says nothing`() {
        val random = SeededRandom(3)
        // Some eleven independent numbers, as the temperature of shear-cell has.
        val short = List(400) { series(300, random) }.filter { !BlockAverage.of(it).isLevelled }
        assertTrue(short.size in 100..300) { "${short.size}" }
        val longer = short.map { longer(it) }
        assertTrue(longer.all { it > 3 }) { "$longer" }
        val usual = longer.sorted()[longer.size / 2]
        assertTrue(usual < 8) { "$usual" }
        val given = longer.count { BlockAverage.of(series((300 * it).toInt(), random)).isLevelled }
        assertTrue(given >= 0.9 * longer.size) { "$given of ${longer.size}" }
        assertTrue(longer(series(3000, random)).isNaN())
        assertTrue(longer(DoubleArray(10) { it % 2.0 }).isNaN())
    }

    private fun longer(series: DoubleArray): Double =
        NumberRows().also { it.average("a", "a number", BlockAverage.of(series), "") }.list().single().longer

    /** Steady noise that is forgotten in 14 numbers: its integrated correlation time is 28. */
    private fun series(length: Int, random: SeededRandom): DoubleArray {
        val kept = exp(-1 / 14.0)
        var x = random.nextGaussian()
        return DoubleArray(length) {
            x = kept * x + sqrt(1 - kept * kept) * random.nextGaussian()
            x
        }
    }
}
