package daphnis.core.scenario

import daphnis.core.input.InputException
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.descriptors.elementDescriptors
import kotlinx.serialization.descriptors.elementNames
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What the guide says of forces holds for all of them. */
@OptIn(ExperimentalSerializationApi::class)
class ForceConstantTest {
    private fun setup(force: String, vararg settings: String) = ScenarioSetup.of(
        ScenarioJson.parse(
            """
            {
              "frame": { "type": "hill", "angularSpeed": 1 }, "box": { "lengths": [20, 20, 10] },
              "boundary": { "type": "hill-sheet" },
              "particles": { "count": 5, "sizes": { "type": "equal", "radius": 1 }, "mass": 1 },
              "bodies": [{ "radius": 3, "mass": 16, "position": [0, 0, 0] }],
              "velocities": { "type": "rest" }, "restitution": { "type": "constant", "coefficient": 1 },
              "forces": [$force], "timeStep": { "type": "orbit-fraction", "steps": 1000 }, "untilOrbits": 1
            }
            """.trimIndent(),
            "patch",
            settings.toList(),
        ),
        "patch",
    )

    private fun refused(force: String, vararg settings: String): String =
        assertThrows(InputException::class.java) { setup(force, *settings) }.message!!

    /** The keys of each type of force, by its name in scenarios. */
    private val keys: Map<String, List<String>> =
        ForceKinds.descriptor.elementDescriptors.last().elementDescriptors
            .associate { it.serialName to it.elementNames.toList() }

    private val needed = mapOf(
        "self-gravity" to "",
        "body-gravity" to "",
        "satellite" to ""","mass":1,"x":30,"y":0""",
    )

    @Test
    fun `every force with gravity takes its constant, or follows from the unit of length, or says what is missing`() {
        val without = setOf("uniform-acceleration", "white-noise", "andersen", "rescaling")
        assertEquals(needed.keys + without, keys.keys)
        for ((type, rest) in needed) {
            setup("""{"type":"$type"$rest,"constant":0.5}""")
            setup("""{"type":"$type"$rest}""", "units.lengthInMetres=1")
            val missing = refused("""{"type":"$type"$rest}""")
            assertTrue("forces[0].constant" in missing && "units.lengthInMetres" in missing) { missing }
            val negative = refused("""{"type":"$type"$rest,"constant":-1}""")
            assertTrue("forces[0].constant" in negative && "at least 0" in negative) { negative }
        }
    }

    @Test
    fun `a mass ratio has its pull from the planet and takes no constant`() {
        val moon = """{"type":"satellite","massRatio":1e-24,"x":30,"y":0"""
        setup("$moon}", "units.lengthInMetres=1")
        assertTrue("goes with mass" in refused("$moon,\"constant\":1}", "units.lengthInMetres=1"))
    }
}
