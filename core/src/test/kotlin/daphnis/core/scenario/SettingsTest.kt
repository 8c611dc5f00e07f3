package daphnis.core.scenario

import daphnis.core.force.ForceSpec
import daphnis.core.force.SelfGravitySpec
import daphnis.core.force.UniformAccelerationSpec
import daphnis.core.input.InputException
import daphnis.core.input.Nearest
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `--set path=value`, and what is said of paths that lead nowhere. */
class SettingsTest {
    private val text = """{ "box": { "lengths": [4, 5, 6] }, "boundary": { "type": "periodic" },
        "forces": [
            { "type": "uniform-acceleration", "acceleration": [0, 0, -1] },
            { "type": "self-gravity", "constant": 1 }
        ],
        "restitution": { "type": "constant", "coefficient": 1 },
        "timeStep": { "type": "fixed", "dt": 1 }, "until": 1 }"""

    private fun with(vararg settings: String) = ScenarioJson.parse(text, "s", settings.toList())

    /** @param end whether the last of [parts] ends the message */
    private fun assertRefused(setting: String, vararg parts: String, end: Boolean = false) {
        val e = assertThrows(InputException::class.java) { with(setting) }
        if (end) assertTrue(e.message.orEmpty().endsWith(parts.last())) { e.message.orEmpty() }
        for (part in parts) assertTrue(part in e.message.orEmpty()) { "'$part' is not in ${e.message}" }
        assertFalse('\n' in e.message.orEmpty())
    }

    @Test
    fun `of a part without a type its keys tell which one is meant`() {
        val free = text.replace(""""timeStep": { "type": "fixed", "dt": 1 }, """, "")
        fun refusal(setting: String) = assertThrows(InputException::class.java) {
            ScenarioJson.parse(free, "s", listOf(setting))
        }.message.orEmpty()
        val mend = "timeStep.type: is missing; dt is of type fixed, so give timeStep.type=fixed too; it must be one of"
        assertTrue(mend in refusal("timeStep.dt=0.1")) { refusal("timeStep.dt=0.1") }
        val both = refusal("""timeStep={"fraction":0.1,"longest":1}""")
        assertTrue("fraction, longest are of type cell-crossing" in both) { both }
        for (unknown in listOf("timeStep={}", "timeStep.tt=1")) {
            assertTrue("timeStep.type: is missing; it must be one of" in refusal(unknown)) { refusal(unknown) }
        }
    }

    @Test
    fun `an entry of a list is replaced where the path says, the others stay`() {
        assertEquals(listOf(4.0, 5.0, 9.0), with("box.lengths[2]=9").box.lengths)
        assertEquals(listOf(7.0, 5.0, 8.0), with("box.lengths[2]=8", "box.lengths[0]=7").box.lengths)
        val forces = with("forces[1].openingAngle=0.25", "forces[0].acceleration[1]=2.5").forces
        assertEquals(0.25, (forces[1] as SelfGravitySpec).openingAngle)
        assertEquals(1.0, (forces[1] as SelfGravitySpec).constant)
        assertEquals(listOf(0.0, 2.5, -1.0), (forces[0] as UniformAccelerationSpec).acceleration)
        val replaced = with("""forces[0]={"type":"self-gravity","constant":2}""").forces
        assertEquals(listOf(2.0, 1.0), replaced.map { (it as SelfGravitySpec).constant })
    }

    @Test
    fun `an entry is added at the end of a list, whether the list is there or not`() {
        fun constants(forces: List<ForceSpec>) = forces.filterIsInstance<SelfGravitySpec>().map { it.constant }
        val more = """{"type":"self-gravity","constant":2}"""
        assertEquals(listOf(1.0, 2.0), constants(with("forces[+]=$more").forces))
        assertEquals(listOf(1.0, 3.0), constants(with("forces[+]=$more", "forces[2].constant=3").forces))
        assertEquals(listOf(1.0, 2.0, 2.0), constants(with("forces[+]=$more", "forces[+]=$more").forces))
        for (none in listOf("", "\"forces\": null,", "\"forces\": [],")) {
            val without = text.replace(Regex("(?s)\"forces\": \\[.*?\\}\\s*],"), none)
            assertEquals(listOf(2.0), constants(ScenarioJson.parse(without, "s", listOf("forces[+]=$more")).forces))
        }
        assertRefused("forces[+].constant=1", "forces[2].type", "is missing")
        assertRefused("restitution[+]=1", "restitution is not a list", "[+]")
        assertRefused("forcs[+]=$more", "forcs", "did you mean 'forces'?")
    }

    @Test
    fun `an index that is not there is refused with those that are`() {
        assertRefused(
            "forces[2].constant=1",
            "settings: ",
            "forces[2].constant=1",
            "forces has 2 entries, [0] to [1]",
            "forces[+]={…} adds one",
            "[2]",
        )
        assertRefused("forces[0].acceleration[3]=1", "forces[0].acceleration has 3 entries")
        assertRefused("bodies[0].radius=1", "bodies is not a list", "it has no [0]; bodies[+]={…} adds one")
        assertRefused("bodies[0]={}", "it has no [0]; bodies[+]={…} adds one")
        assertRefused("forcs[0].x=1", "forcs is not a list", "it has no [0]; did you mean 'forces'?")
        assertRefused("box[0]=1", "box is not a list")
        assertRefused("forces[99999999999].constant=1", "2 entries")
        assertRefused("forces.constant=1", "forces is a list", "forces[0]")
        assertRefused("until[0]=1", "until is not a list in this scenario, so it has no [0]", end = true)
        assertRefused("output[0]=1", "output is not a list in this scenario, so it has no [0]", end = true)
    }

    @Test
    fun `a path that is none is refused`() {
        val lists = listOf("forces[", "forces]", "forces[0", "forces[a]", "[0]", "forces[-1]", "forces[0]x")
        for (path in lists + listOf("box..lengths", ".box", "box.")) {
            assertRefused("$path=1", "settings: ", "$path=1", "is not a key")
        }
        assertRefused("nothing", "path=value")
        assertRefused("=1", "path=value")
    }

    @Test
    fun `a key in a list that does not exist is named by the path that was typed`() {
        assertRefused("forces[1].openingangle=1", "forces[1].openingangle", "did you mean 'openingAngle'?")
        assertRefused("box.lengths[1]=NaN", "box.lengths[1]", "NaN", "finite number")
        assertRefused("until=5 s", "until", "5 s", "finite number")
        assertRefused("until=", "until", "finite number")
    }

    @Test
    fun `the nearest word is found, swapped letters and all, and none when all are far`() {
        assertEquals("run", Nearest.to("rnu", listOf("resume", "run", "scenarios")))
        assertEquals("describe", Nearest.to("DESRCIBE", listOf("describe", "resume")))
        assertEquals(1, Nearest.distance("rnu", "run"))
        assertEquals(3, Nearest.distance("kitten", "sitting"))
        assertEquals(4, Nearest.distance("", "four"))
        assertNull(Nearest.to("quark", listOf("resume", "analyze")))
        assertNull(Nearest.to("quark", emptyList()))
    }
}
