package daphnis.app.progress

import daphnis.core.input.UnitsSpec
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import kotlin.math.PI

class TimesInWordsTest {
    @Test
    fun `times are orbits in Hill's frame, else in the units of the scenario, in few digits`() {
        val ring = TimesInWords(2 * PI / 10, UnitsSpec(100.0, 1.0, 1.0))
        assertEquals("0.025 orbits", ring.text(0.25))
        assertEquals("14.3333 to 40 orbits", ring.span(430.0 / 3, 400.0))
        assertEquals("orbits", ring.shortUnit)
        assertEquals("12.5 s", TimesInWords(null, UnitsSpec(100.0, 1.0, 1.0)).text(12.5))
        val gas = TimesInWords.of(BuiltIn.scenario("cooling-gas", emptyList()))
        assertEquals("0 to 100 units of time", gas.span(0.0, 100.0))
        assertEquals("1 unit of time", gas.text(1.0))
        assertEquals("", gas.shortUnit)
    }

    @Test
    fun `very long and very short times are not written out`() {
        val plain = TimesInWords(null, null)
        assertEquals("1E+300 units of time", plain.text(1e300))
        assertEquals("1E-9 units of time", plain.text(1e-9))
        assertEquals("-0.0002 units of time", plain.text(-2e-4))
    }
}
