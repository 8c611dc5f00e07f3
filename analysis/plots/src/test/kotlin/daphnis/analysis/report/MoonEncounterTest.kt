package daphnis.analysis.report

import daphnis.analysis.table.UnitNames
import daphnis.core.boundary.Box
import daphnis.core.input.UnitsSpec
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.Scenario
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class MoonEncounterTest {
    private val box = Box.centred(10.0, 12600.0, 0.6)
    private val omega = 1.259e-4
    private val orbits = OrbitalFrequencies(omega)

    private fun wake(vararg settings: String): Scenario = BuiltIn.scenario("satellite-wake", settings.asList())

    @Test
    fun `a moon given by its mass has the encounter of the same moon given by its ratio`() {
        val ratio = MoonEncounter.of(wake(), orbits, box)!!
        // μ GM/Ω² of the frame.
        assertEquals(2.2396 * 8.71e-12 * 3.7931206e7 / (omega * omega * 167 * 167), ratio.amplitude, 0.001)
        // GM of Saturn over G, in kilograms.
        val mass = 8.71e-12 * 3.7931206e16 / UnitsSpec.GRAVITATIONAL_CONSTANT
        val byMass = MoonEncounter.of(
            wake("forces=[{\"type\":\"satellite\",\"mass\":$mass,\"x\":-167,\"y\":-7500}]"),
            orbits,
            box,
        )!!
        assertEquals(ratio.massRatio, byMass.massRatio, 1e-12 * ratio.massRatio)
        assertEquals(ratio.amplitude, byMass.amplitude, 1e-9)
        assertEquals(ratio.distance, byMass.distance)
    }

    @Test
    fun `a frame given by its angular speed is where Kepler puts it`() {
        val given = wake("frame={\"type\":\"hill\",\"planet\":\"saturn\",\"angularSpeed\":$omega}")
        val kepler = MoonEncounter.of(given, orbits, box)!!
        assertEquals(Math.cbrt(3.7931206e7 / (omega * omega)), kepler.semiMajorAxis, 1e-6)
        assertEquals(167.0, kepler.distance)
    }

    @Test
    fun `the rows say what is of the circle and what of the epicycle`() {
        val units = UnitNames(wake().units)
        fun rows(e: Double) = MoonEncounter.rows(
            MoonEncounter.of(
                wake("forces=[{\"type\":\"satellite\",\"massRatio\":8.71e-12,\"x\":-167,\"y\":-7500,\"e\":$e}]"),
                orbits,
                box,
            )!!,
            box,
            units,
            MoonEncounter.moons(wake()).first().orbitsBetweenPassages(FrameSetup.distance(wake(), orbits)!!, orbits),
        )
        // The run's: the circumference in the middle of the frame over 3/2 · 167 km.
        val between = rows(0.0).single { it.name == "time between passages" }.value
        assertEquals(133_746 / (1.5 * 167), between, 1e-3)
        assertEquals(1, rows(0.0).count { "amplitude" in it.name })
        val swinging = rows(30.0)
        val least = swinging.single { "least" in it.name }.value
        val largest = swinging.single { "largest" in it.name && "amplitude" in it.name }.value
        val circle = rows(0.0).single { "amplitude" in it.name }.value
        assertTrue(least < 0.9 * circle && largest > 1.1 * circle) { "$least $circle $largest" }
        assertTrue(swinging.any { "swings 30" in it.note })
        assertEquals(1.5 * 167 * 167 / largest, swinging.single { "cross" in it.name }.value, 1e-9)
        val crossing = rows(200.0)
        assertTrue(crossing.single { "amplitude" in it.name }.value.isNaN())
        assertFalse(crossing.any { "cross without" in it.name })
    }

    @Test
    fun `each of several moons has its encounter`() {
        val moon = "{\"type\":\"satellite\",\"massRatio\":8.71e-12,\"y\":-7500,\"x\":"
        val two = wake("forces=[$moon-167},$moon 300,\"returns\":true,\"inclination\":5}]")
        val found = MoonEncounter.moons(two).map { MoonEncounter.of(two, orbits, box, it)!!.distance }
        assertEquals(listOf(167.0, -300.0), found)
    }

    @Test
    fun `no moon, no encounter`() {
        assertNull(MoonEncounter.of(wake("forces=[]"), orbits, box))
        assertNull(MoonEncounter.of(null, orbits, box))
        assertNull(
            MoonEncounter.of(
                wake("forces=[{\"type\":\"satellite\",\"massRatio\":8.71e-12,\"x\":0,\"y\":-7500}]"),
                orbits,
                box,
            ),
        )
    }
}
