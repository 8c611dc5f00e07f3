package daphnis.analysis.report

import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class SpeedUnitTest {
    private fun of(scenario: String, vararg settings: String) =
        SpeedUnit(BuiltIn.scenario(scenario, settings.asList()), "units of speed").let { it.name to it.factor }

    @Test
    fun `speeds are in centimetres per second where the scenario knows how fast they are`() {
        assertEquals("cm/s" to 100.0, of("ring-patch"))
        // Without lengths in metres, but with a law of restitution in cm/s.
        assertEquals("cm/s" to 1.0, of("paper-figure-1"))
        assertEquals("cm/s" to 3.0, of("shear-cell", "units.speedInCmPerSecond=3"))
        assertEquals("units of speed" to 1.0, of("shear-cell"))
        assertEquals("units of speed", SpeedUnit(null, "units of speed").name)
    }
}
