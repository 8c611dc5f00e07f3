package daphnis.app.progress

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The line that a run rewrites: what is left of it where there is little room. */
class ProgressLineTest {
    private val line = ProgressLine(0.0, 12.5, 50.0, 1250, 3725.0, 1.2e6, 3.14159)
    private val longest = ProgressLine(0.0, -1.2345e-105, 1.2345e105, 9_876_543_210, 9e9, 1.23e105, -1.2345e-105)

    @Test
    fun `everything is said where there is room`() {
        assertEquals(
            " 25 %  step 1250  time 12.50 of 50.00  1:02:05 left  1.20e+06 collisions/s  energy 3.1416",
            line.text(200),
        )
    }

    @Test
    fun `times and energies have their units where these have names`() {
        val text = ProgressLine(0.0, 12.5, 50.0, 1250, 3725.0, 1.2e6, 3.14159, "orbits", "J").text(200)
        val rest = "1:02:05 left  1.20e+06 collisions/s  energy 3.1416 J"
        assertEquals(" 25 %  step 1250  time 12.50 of 50.00 orbits  $rest", text)
    }

    @Test
    fun `a line never is wider than the terminal`() {
        for (progress in listOf(line, longest)) {
            for (columns in 0..200) {
                assertTrue(progress.text(columns).length <= columns) { progress.text(columns) }
            }
        }
    }

    @Test
    fun `on 80 columns the energy goes, on 40 the step and the time are short`() {
        assertEquals(" 25 %  step 1250  time 12.50 of 50.00  1:02:05 left  1.20e+06 collisions/s", line.text(79))
        assertEquals(" 25 %  12.50/50.00  1:02:05 left", line.text(39))
        assertEquals(" 25 %  1:02:05 left", line.text(20))
        assertEquals(" 25 %", line.text(10))
    }

    @Test
    fun `a time left that is not known is no time`() {
        assertTrue("0:00 left" in ProgressLine(0.0, 1.0, 2.0, 1, Double.NaN, 0.0, 0.0).text(100))
    }
}
