package daphnis.core.run

import daphnis.core.input.InputException
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import kotlin.math.PI

class TimeWordsTest {
    @Test
    fun `a time has its unit and its orbits where there are any`() {
        val ring = BuiltIn.scenario("ring-patch", listOf("frame={\"type\":\"hill\",\"angularSpeed\":0.001}"))
        assertEquals("time 3141.593 s (0.5 orbits)", TimeWords.of(ring, "ring").text(1000 * PI))
        assertEquals("time 0.25", TimeWords.of(BuiltIn.scenario("cooling-gas"), "gas").text(0.25))
        assertEquals("time 1000000", TimeWords.of(null, "").text(1e6))
        assertEquals("time 1E-300", TimeWords.PLAIN.text(1e-300))
        assertEquals("time 0", TimeWords.PLAIN.text(0.0))
        assertEquals("time NaN", TimeWords.PLAIN.text(Double.NaN))
    }

    @Test
    fun `an end that has passed is told with all digits where few are not enough`() {
        fun said(until: Double, now: Double) = assertThrows(InputException::class.java) {
            checkLater(until, now, 0.0, TimeWords.PLAIN) { InputException("run", "until", it) }
        }.message
        assertEquals("run: until: is time 1; the run is at time 2, give a later end", said(1.0, 2.0))
        val close = "run: until: is 1.9999999999; the run is at time 2.0, give a later end"
        assertEquals(close, said(1.9999999999, 2.0))
        checkLater(1.9999999999, 2.0, 1e-9, TimeWords.PLAIN) { InputException("run", "until", it) }
    }
}
