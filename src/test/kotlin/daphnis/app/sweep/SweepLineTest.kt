package daphnis.app.sweep

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SweepLineTest {
    @Test
    fun `it says what there is to say`() {
        assertEquals(
            " 25 % of the work  3 of 12 runs finished  2 running  1 failed  1:01:05 left",
            SweepLine(3, 1, 0, 2, 12, 0.25, 3665.0).text(80),
        )
        assertEquals(" 50 % of the work  0 of 1 run finished  0:09 left", SweepLine(0, 0, 0, 0, 1, 0.5, 9.2).text(80))
        assertEquals("100 % of the work  2 of 2 runs finished", SweepLine(2, 0, 0, 0, 2, 1.0, 0.0).text(80))
        assertEquals("  0 % of the work  0 of 2 runs finished", SweepLine(0, 0, 0, 0, 2, 0.0, Double.NaN).text(80))
    }

    @Test
    fun `it fits in every width`() {
        val line = SweepLine(3, 1, 2, 2, 12, 0.25, 3665.0)
        for (columns in 0..80) assertTrue(line.text(columns).length <= columns) { "$columns" }
        assertEquals(" 25 %  3 of 12 runs  1 failed  2 busy", line.text(45))
        assertEquals(" 25 %", line.text(6))
    }
}
