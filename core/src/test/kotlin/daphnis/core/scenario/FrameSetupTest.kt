package daphnis.core.scenario

import daphnis.core.hill.HillFrame
import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What a frame in a scenario says of the frequencies of orbits, and what it must not say. */
class FrameSetupTest {
    private fun frequencies(frame: String) = FrameSetup.frequencies(ring(frame), "ring")!!

    private fun ring(frame: String) =
        BuiltIn.scenario("self-gravity-wakes", listOf("""frame={"type":"hill",$frame}""", "units.lengthInMetres=1"))

    private val oblate = """"oblateness":{"radiusInKm":60330,"j2":16290.71e-6,"j4":-935.83e-6,"j6":86.14e-6}"""

    @Test
    fun `a planet's oblateness gives all three frequencies, numbers take their place`() {
        val f = frequencies(""""distanceInKm":140224,$oblate""")
        val day = 86_400 * ring("\"angularSpeed\":1").units.timeInSeconds!!.let { 1 / it }
        assertEquals(2.698, Math.toDegrees((f.omega - f.kappa) * day), 0.002)
        assertTrue(f.verticalFactor > 1.0)
        assertEquals(3.6, frequencies(""""distanceInKm":140224,"verticalFactor":3.6,$oblate""").verticalFactor)
        val point = frequencies(""""distanceInKm":140224""")
        assertEquals(1.0, point.radialFactor)
        assertEquals(1.0, point.verticalFactor)
        val given = frequencies(""""angularSpeed":0.7,"radialFactor":0.95,"verticalFactor":1.2""")
        assertEquals(listOf(0.7, 0.95, 1.2), listOf(given.omega, given.radialFactor, given.verticalFactor))
    }

    @Test
    fun `another planet is its own G times mass`() {
        val saturn = frequencies(""""distanceInKm":140224""")
        val same = frequencies(""""distanceInKm":140224,"planet":"uranus","gravitationalParameter":37931206""")
        assertEquals(saturn.omega, same.omega, 1e-15 * saturn.omega)
    }

    @Test
    fun `what does not fit is refused with its key`() {
        for ((frame, key) in listOf(
            """"angularSpeed":1,"radialFactor":0""" to "frame.radialFactor",
            """"angularSpeed":1,"radialFactor":2""" to "frame.radialFactor",
            """"angularSpeed":1,"verticalFactor":-1""" to "frame.verticalFactor",
            """"angularSpeed":1,$oblate""" to "frame.oblateness",
            """"angularSpeed":1,"gravitationalParameter":0""" to "frame.gravitationalParameter",
            """"distanceInKm":1e5,"gravitationalParameter":-1""" to "frame.gravitationalParameter",
            """"distanceInKm":1e5,"radialFactor":0.9,$oblate""" to "frame.radialFactor",
            """"distanceInKm":1e5,"oblateness":{"radiusInKm":0,"j2":0.01}""" to "frame.oblateness.radiusInKm",
            """"distanceInKm":1e5,"oblateness":{"radiusInKm":60330,"j2":3}""" to "frame.oblateness",
            """"distanceInKm":6e4,"oblateness":{"radiusInKm":60330,"j2":0.01}""" to "frame.distanceInKm",
            """"distanceInKm":1e5,"oblateness":{"j2":0.01}""" to "frame.oblateness.radiusInKm",
        )) {
            val message = assertThrows(InputException::class.java) { frequencies(frame) }.message!!
            assertTrue("$key: " in message || "$key " in message) { "$frame: $message" }
            assertTrue('\n' !in message) { message }
        }
    }

    @Test
    fun `the boundary and the frame of a patch have the frequencies of its scenario`() {
        val setup = ScenarioSetup.of(BuiltIn.scenario("ring-patch", listOf("frame.radialFactor=0.9")), "ring")
        assertEquals(-(4 - 0.81) / 2 * setup.angularSpeed!!, setup.boundary.meanFlow!!.rate, 1e-15)
        assertEquals(0.9, setup.frequencies!!.radialFactor)
        val frame = setup.forces.filterIsInstance<HillFrame>().single()
        assertEquals(0.9, frame.frequencies.radialFactor)
    }
}
