package daphnis.analysis.table

import daphnis.core.input.UnitsSpec
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class UnitNamesTest {
    private fun all(units: UnitsSpec?) = UnitNames(units).let {
        val mechanics = listOf(it.length, it.time, it.mass, it.speed, it.temperature, it.energy)
        mechanics + listOf(it.viscosity, it.surfaceDensity, it.density, it.rate, it.waveNumber)
    }

    @Test
    fun `metric units have their names`() {
        assertEquals("m s kg m/s m^2/s^2 J m^2/s kg/m^2 kg/m^3 1/s 1/m".split(' '), all(UnitsSpec(100.0, 1.0, 1.0)))
        assertEquals(
            "km s kg km/s km^2/s^2 |kg km^2/s^2| km^2/s kg/km^2 kg/km^3 1/s 1/km",
            all(UnitsSpec(100_000.0, 1000.0, 1.0)).joinToString(" ") { if (' ' in it) "|$it|" else it },
        )
        assertEquals("cm", UnitNames(UnitsSpec(1.0, 0.01, 0.001)).length)
        assertEquals("g/cm^2", UnitNames(UnitsSpec(1.0, 0.01, 0.001)).surfaceDensity)
    }

    @Test
    fun `units without a name say what they measure, and a compound is metric only when all its parts are`() {
        val generic =
            listOf(
                "units of length",
                "units of time",
                "units of mass",
                "units of length/time",
                "units of length^2/time^2",
                "units of mass length^2/time^2",
            )
        assertEquals(generic, all(null).take(6))
        assertEquals(generic, all(UnitsSpec()).take(6))
        assertEquals(listOf("1/(unit of time)", "1/(unit of length)"), all(UnitsSpec()).takeLast(2))
        // A metre, but a time unit of 100 s: the speed is not in m/s.
        val mixed = UnitNames(UnitsSpec(1.0, 1.0, 1.0))
        assertEquals(
            listOf("m", "units of time", "kg", "units of length/time", "kg/m^2"),
            listOf(mixed.length, mixed.time, mixed.mass, mixed.speed, mixed.surfaceDensity),
        )
    }

    @Test
    fun `amounts and axes read well`() {
        assertEquals("1 unit of length", UnitNames.amount("1", "units of length"))
        assertEquals("2 units of length", UnitNames.amount("2", "units of length"))
        assertEquals("1 m", UnitNames.amount("1", "m"))
        assertEquals("temperature [m²/s²]", UnitNames.axis("temperature", "m^2/s^2"))
        assertEquals("optical depth", UnitNames.axis("optical depth", ""))
    }

    @Test
    fun `an amount of an unnamed rate is said in words`() {
        assertEquals("2 per unit of time", UnitNames.amount("2", UnitNames(UnitsSpec()).rate))
        assertEquals("2 1/s", UnitNames.amount("2", "1/s"))
        assertEquals("1 unit of length", UnitNames.amount("1", "units of length"))
    }
}
