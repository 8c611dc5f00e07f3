package daphnis.core.scenario

import daphnis.core.collision.GuardSpec
import daphnis.core.input.InputException
import daphnis.core.surface.BridgesSpec
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ScenarioJsonTest {
    private val good = """
        { // a comment
          "box": { "lengths": [10, 10, 10] }, "boundary": { "type": "periodic" },
          "particles": { "count": 20, "sizes": { "type": "equal", "radius": 0.5 } },
          "velocities": { "type": "gaussian", "sigma": 1.0 },
          "restitution": { "type": "constant", "coefficient": 0.9 },
          "timeStep": { "type": "fixed", "dt": 0.1 },
          "until": 1.0, /* another */
        }
    """.trimIndent()

    /** Expects one line that holds all of [parts]. */
    private fun assertWrong(text: String, settings: List<String>, vararg parts: String) {
        val e =
            assertThrows(InputException::class.java) {
                ScenarioSetup.of(ScenarioJson.parse(text, "my.json", settings), "my.json")
            }
        val message = e.message.orEmpty()
        assertFalse('\n' in message) { message }
        for (part in parts) assertTrue(part in message) { "'$part' is not in: $message" }
    }

    private fun assertWrong(setting: String, vararg parts: String) = assertWrong(good, listOf(setting), *parts)

    @Test
    fun `comments and trailing commas are allowed, defaults are filled in`() {
        val setup = ScenarioSetup.of(ScenarioJson.parse(good, "my.json"), "my.json")
        assertEquals(20, setup.population.size)
        assertEquals("horizon", setup.scenario.engine.name)
        val guard = setup.scenario.guard as GuardSpec.FloorSpeed
        assertEquals(1.7e-6, guard.speed!!, 0.5e-6)
    }

    @Test
    fun `what is written means the same again`() {
        val first = ScenarioSetup.of(ScenarioJson.parse(good, "my.json"), "my.json")
        val text = ScenarioJson.write(first.scenario)
        val second = ScenarioSetup.of(ScenarioJson.parse(text, "again"), "again")
        assertEquals(text, ScenarioJson.write(second.scenario))
        assertEquals(first.population.x.toList(), second.population.x.toList())
    }

    @Test
    fun `every built-in scenario is right, and says what it is`() {
        for (name in BuiltIn.names) {
            val scenario = BuiltIn.scenario(name)
            assertEquals(name, scenario.name)
            assertTrue(scenario.description.length > 20)
            ScenarioSetup.of(scenario, name)
        }
    }

    @Test
    fun `settings replace keys, add them, and take whole objects`() {
        val s = ScenarioJson.parse(
            good,
            "x",
            listOf(
                "timeStep.dt=0.05",
                "name=my gas",
                "output.snapshotEvery=7",
                """restitution={"type":"bridges"}""",
                "seed=42",
            ),
        )
        assertEquals(0.05, (s.timeStep as TimeStepSpec.Fixed).dt)
        assertEquals("my gas", s.name)
        assertEquals(7, s.output.snapshotEvery)
        assertEquals(0.34, (s.restitution as BridgesSpec).prefactor)
        assertEquals(42L, s.seed)
    }

    @Test
    fun `an unknown key is named with the nearest known one`() {
        assertWrong(good.replace("\"until\"", "\"untill\""), emptyList(), "my.json", "untill", "did you mean 'until'?")
        assertWrong("timestep.dt=0.1", "timestep: unknown key; did you mean 'timeStep'?")
        // Another type may have it.
        assertWrong("timeStep.path=1", "timeStep.path: unknown key for type fixed; it is a key of type automatic")
        assertWrong("particles.sizes.raduis=3", "particles.sizes.raduis", "did you mean 'radius'?")
        assertWrong("boundary.type=periodc", "boundary.type", "did you mean 'periodic'?")
    }

    @Test
    fun `malformed JSON is named by line and column`() {
        val e =
            assertThrows(InputException::class.java) {
                ScenarioJson.parse("{\n  \"box\": { \"lengths\" [1, 2, 3] }\n}", "my.json")
            }
        assertTrue(Regex("""^my\.json:2:\d+: malformed JSON: .+""").matches(e.message.orEmpty())) { e.message }
    }

    @Test
    fun `a text that ends too early is told so, and a key of another type by that type`() {
        for (text in listOf("{", "{\"a\":", "{\"a\": \"x", "{\"a\": 1}}")) {
            val e = assertThrows(InputException::class.java) { ScenarioJson.parse(text, "my.json") }
            assertTrue("EOF" !in e.message!! && "end" in e.message!! && "Json" !in e.message!!) { e.message }
        }
        assertWrong("restitution.speed=1", "restitution.speed", "is a key of type", "give restitution.type=")
        assertWrong("restitution.coeficient=1", "did you mean 'coefficient'")
    }

    @Test
    fun `whole numbers may be written with a point or an exponent, as the schema has them`() {
        fun of(vararg settings: String) = ScenarioJson.write(ScenarioJson.parse(good, "test", settings.toList()))
        assertEquals(of("particles.count=20", "seed=-3"), of("particles.count=20.0", "seed=-3.0"))
        assertEquals(of("particles.count=20", "seed=0"), of("particles.count=2e1", "seed=-0.0"))
        assertTrue("\"seed\": ${Long.MIN_VALUE}," in of("seed=${Long.MIN_VALUE}"))
        assertEquals(of("seed=9007199254740993"), of("seed=9007199254740993.0"))
    }

    @Test
    fun `a missing key, a wrong kind of value and numbers that are none are named`() {
        assertWrong(good.replace("\"until\": 1.0,", ""), emptyList(), "until", "is missing")
        assertWrong("until=soon", "until", "\"soon\"", "finite number")
        assertWrong("until=NaN", "until", "NaN", "finite number")
        assertWrong("until=1e999", "until", "1e999", "finite number")
        assertWrong("until=null", "until", "is missing")
        assertWrong("until=[1]", "until", "[1]", "finite number")
        assertWrong("particles.count=1.5", "particles.count", "1.5", "whole number")
        assertWrong("particles.count=\"20\"", "particles.count", "whole number")
        assertWrong("particles.count=1e10", "particles.count", "1e10", "whole number below")
        assertWrong("particles.count=1e999999999", "particles.count", "whole number below")
        assertWrong("seed=9223372036854775808.0", "seed", "whole number")
        assertWrong("seed=1.0000000000000000000000001", "seed", "whole number")
        assertWrong("seed=1e-400", "seed", "whole number")
        assertWrong("box.lengths=[1,2]", "box.lengths", "three")
        assertWrong("box.lengths=[10,10,\"x\"]", "box.lengths[2]", "finite number")
        assertWrong("box=3", "box", "3", "object")
        assertWrong("name=\"a\\ud800b\"", "name", "half of a character")
    }

    @Test
    fun `values that make no simulation are named with what would be right`() {
        assertWrong("particles.sizes.radius=0", "particles.sizes", "0", "> 0")
        assertWrong("particles.sizes.radius=-1", "particles.sizes", "-1", "> 0")
        assertWrong("particles.mass=0", "particles.mass", "> 0")
        assertWrong("particles.density=-2", "particles.density", "> 0")
        assertWrong("timeStep.dt=0", "timeStep.dt", "0.0", "> 0")
        assertWrong("timeStep.dt=-1", "timeStep.dt", "-1", "> 0")
        assertWrong("until=0", "until", "> 0")
        assertWrong("particles.count=0", "particles.count", "0", "1..")
        assertWrong("restitution.coefficient=1.2", "restitution.coefficient", "1.2", "[0, 1]")
        assertWrong("restitution.coefficient=-0.1", "restitution.coefficient", "[0, 1]")
        assertWrong(
            "particles.fillingFactor=0.1",
            "particles",
            "exactly one of count, fillingFactor, opticalDepth and surfaceDensity",
        )
        assertWrong(
            "particles={\"fillingFactor\":0.5,\"sizes\":{\"type\":\"equal\",\"radius\":0.5}}",
            "particles.fillingFactor",
            "0.5",
            "lattice",
        )
        assertWrong(
            "particles={\"fillingFactor\":0.8,\"sizes\":{\"type\":\"equal\",\"radius\":0.5}}",
            "particles.fillingFactor",
            "0.8",
        )
        assertWrong("particles.count=5000000", "particles.count", "filling factor")
        assertWrong("box.lengths=[10,10,0.9]", "box.lengths[2]", "0.9", "1.0")
        assertWrong("box.lengths=[10,0,10]", "box.lengths[1]", "> 0")
        assertWrong("timeStep.dt=1e6", "timeStep", "smaller dt")
        assertWrong("guard={\"type\":\"floor-speed\"}", "guard", "exactly one")
        assertWrong("velocities.shearProfile=true", "velocities.shearProfile", "lees-edwards")
        assertWrong("engine.threads=-1", "engine.threads", "1..")
        assertWrong("engine.threads=1000", "engine.threads", "1..")
        assertWrong("output.snapshotEvery=-1", "output.snapshotEvery", "at least 0")
        assertWrong("placement={\"type\":\"file\",\"path\":\"nowhere.csv\"}", "particles", "left out")
    }

    @Test
    fun `a setting without an equals sign or through a number is refused`() {
        assertWrong("until", "settings: ", "path=value")
        assertWrong("until.x=1", "settings: ", "not an object")
    }
}
