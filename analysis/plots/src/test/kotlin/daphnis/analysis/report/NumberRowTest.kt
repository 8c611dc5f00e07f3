package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class NumberRowTest {
    @Test
    fun `an average over a time that is not steady is marked so, also where states are too few for an error`() {
        val rows = NumberRows()
        rows.average("a", "with an error", BlockAverage(2.0, 0.1, 40), "s")
        rows.average("b", "of few states", BlockAverage(2.0, Double.NaN, 4), "s")
        rows.exact("c", "of the particles", 2.0, "s")
        assertEquals(listOf(null, Unknown.TOO_FEW, null), rows.list().map { it.unknown })
        val unsteady = rows.list().map { it.without(Unknown.UNSTEADY) }
        assertEquals(listOf(Unknown.UNSTEADY, Unknown.UNSTEADY, null), unsteady.map { it.unknown })
        assertEquals(listOf(true, true, true), unsteady.map { it.error.isNaN() && it.value == 2.0 })
    }
}
