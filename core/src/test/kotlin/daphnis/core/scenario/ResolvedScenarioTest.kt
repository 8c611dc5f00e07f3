package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ResolvedScenarioTest {
    private fun moonlet(vararg settings: String) =
        BuiltIn.scenario("moonlet", listOf("box.lengths=[150,150,6]") + settings)

    @Test
    fun `bodies come after the particles, and their first id is that of the run for its states alone`() {
        val setup = ScenarioSetup.of(moonlet(), "moonlet")
        val n = setup.population.size
        assertEquals(n - 1, setup.scenario.firstBody)
        assertEquals(listOf(false, true), listOf(n - 2, n - 1).map { setup.scenario.isBody(it) })
        val file = ScenarioJson.parse(ScenarioJson.write(setup.scenario), "file")
        // A state of the run that has lost ten particles.
        val state = setup.population.copy().apply { retain { k -> id[k] >= 10 } }
        assertEquals(n - 1, ScenarioSetup.of(file, "file", state).scenario.firstBody)
        assertEquals(n - 1, file.firstBody(spheres = state.size))
        // The same file with fewer particles from the start: the moonlet is another sphere.
        val fewer = listOf("particles.opticalDepth=0.05")
        val thinner = ScenarioJson.parse(ScenarioJson.write(setup.scenario), "file", fewer)
        val anew = ScenarioSetup.of(thinner, "file")
        assertTrue(anew.population.size < n - 10)
        assertEquals(anew.population.size - 1, anew.scenario.firstBody)
        assertEquals(40.0, anew.population.radius[anew.population.indexOf(anew.scenario.firstBody)])
    }

    @Test
    fun `a lattice that is left out is named in the file`() {
        for ((name, settings) in mapOf("fcc" to listOf("particles.count=256"), "hexagonal" to listOf("dimensions=2"))) {
            val box = if (name == "fcc") "box.lengths=[20,20,20]" else "box.lengths=[60,60]"
            val scenario = BuiltIn.scenario(if (name == "fcc") "elastic-gas" else "hard-discs", settings + box)
            val lattice = ScenarioJson.changed(scenario, name, listOf("placement={\"type\": \"lattice\"}"))
            assertTrue("\"lattice\": \"$name\"" in ScenarioJson.write(ScenarioSetup.of(lattice, name).scenario))
        }
    }

    @Test
    fun `without bodies no id is one, and the file names none`() {
        val scenario = ScenarioSetup.of(BuiltIn.scenario("cooling-gas", listOf("particles.count=20")), "gas").scenario
        assertEquals(Int.MAX_VALUE, scenario.firstBody)
        assertFalse(scenario.isBody(Int.MAX_VALUE))
        assertFalse("firstBody" in ScenarioJson.write(scenario))
    }

    @Test
    fun `times in orbits are written out`() {
        val steps = """timeStep={"type":"orbit-fraction","steps":100}"""
        val setup = ScenarioSetup.of(moonlet("untilOrbits=2", steps), "moonlet")
        val orbit = 2 * Math.PI / setup.angularSpeed!!
        assertEquals(2 * orbit, setup.scenario.end)
        assertEquals(orbit / 100, (setup.scenario.timeStep as TimeStepSpec.Fixed).dt)
        val file = ScenarioJson.parse(ScenarioJson.write(setup.scenario), "file")
        assertEquals(2 * orbit, file.until)
        assertNull(file.untilOrbits)
    }

    @Test
    fun `box, boundary, frame and times are had without a population, the same as with one`() {
        for (name in BuiltIn.names) {
            val scenario = BuiltIn.scenario(name)
            val around = Surroundings.of(scenario, name)
            val setup = if (name in SMALL) ScenarioSetup.of(scenario, name) else continue
            assertEquals(words(setup.boundary), words(around.boundary))
            assertEquals(setup.angularSpeed, around.angularSpeed)
            assertEquals(setup.scenario.end, around.end)
        }
        // More particles than any machine has room for are no matter here.
        val huge = BuiltIn.scenario("elastic-gas", listOf("particles.count=199999999"))
        assertEquals(1.0, Surroundings.of(huge, "huge").boundary.box.let { it.length(0) / huge.box.lengths[0] })
        val wrong = assertThrows(InputException::class.java) {
            Surroundings.of(BuiltIn.scenario("elastic-gas", listOf("box.lengths=[1,2]")), "gas")
        }
        assertTrue("box.lengths" in wrong.message!!)
    }

    private fun words(boundary: BoundaryConditions) = (0..2).map { axis ->
        listOf(
            boundary.contactFaces(axis),
            boundary.box.length(axis),
            boundary.meanFlow?.rate,
            boundary.shear?.velocity,
        )
    }

    @Test
    fun `a frame takes the boundaries that are the same at both radial faces, and no other`() {
        fun fits(boundary: String, vararg more: String): Boolean = try {
            Surroundings.of(BuiltIn.scenario("ring-patch", listOf("boundary=$boundary") + more), "ring")
            true
        } catch (e: InputException) {
            val message = e.message.orEmpty()
            assertTrue("boundary.type: is " in message && "cannot be combined with a frame" in message) { message }
            false
        }
        val flat = "frame.verticalFactor=0"
        assertTrue(fits("""{"type":"open"}"""))
        assertTrue(fits("""{"type":"hill-sheet"}"""))
        assertTrue(fits("""{"type":"hill-sheet","radiallyOpen":true}"""))
        assertTrue(fits("""{"type":"walls","axes":"xz"}"""))
        assertTrue(fits("""{"type":"walls","axes":"x"}""", flat))
        for (axes in listOf("x", "yz")) assertFalse(fits("""{"type":"walls","axes":"$axes"}"""))
        for (none in listOf("periodic", "lees-edwards", "sheared-periodic")) {
            val more = mapOf("lees-edwards" to ""","shearRate":1""", "sheared-periodic" to ""","velocityJump":1""")
            assertFalse(fits("""{"type":"$none"${more[none].orEmpty()}}""", flat))
        }
    }

    private companion object {
        val SMALL = setOf("cooling-gas", "elastic-gas", "paper-figure-1", "satellite-wake")
    }
}
