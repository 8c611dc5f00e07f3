package daphnis.core.scenario

import daphnis.core.Engines
import daphnis.core.input.InputException
import daphnis.core.population.stateDigest
import daphnis.core.run.Run
import daphnis.core.run.RunOrigin
import daphnis.core.run.Summary
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.nio.file.Path

/** Spheres that swap places, from a scenario to its end, and on from any of its states. */
class SwapsScenarioTest {
    @TempDir
    lateinit var home: Path

    private fun scenario(vararg settings: String) = ScenarioJson.parse(MIXTURE, "test", settings.toList())

    private fun run(name: String, from: RunOrigin? = null, vararg settings: String): Summary =
        Run.start(scenario(*settings), "test", home.resolve(name), from = from, engines = Engines)
            .use { it.execute() }

    @ParameterizedTest
    @ValueSource(
        strings = [
            "name=periodic",
            "growth={\"rate\": 0.02, \"untilFillingFactor\": 0.3}",
            "boundary={\"type\": \"walls\"}",
            """boundary={"type": "walls", "axes": "z", "surfaces": [{"type": "cylinder", "axis": [0, 0, 1],
            "radius": 4.5}]}""",
            "boundary={\"type\": \"walls\", \"faces\": {\"lowerZ\": {\"motion\": {\"type\": \"piston\", \"mass\": 90}}}}",
            "boundary={\"type\": \"walls\", \"faces\": {\"lowerX\": {\"temperature\": 2}}}",
        ],
    )
    fun `every engine gives the bits and counts of the serial one, nothing overlaps, and a run goes on to the same`(
        setting: String,
    ) {
        val whole = run("whole", null, setting, "engine.name=serial")
        assertTrue(whole.swaps > 100 && whole.swapAttempts > whole.swaps) { "${whole.swaps} ${whole.swapAttempts}" }
        assertTrue(whole.maxOverlap < 1e-12) { "${whole.maxOverlap}" }
        for (engine in listOf("horizon", "islands", "thread-pool")) {
            val other = run(engine, null, setting, "engine.name=$engine", "engine.threads=3")
            assertEquals(whole.stateDigest, other.stateDigest, engine)
            assertEquals(whole.swaps to whole.swapAttempts, other.swaps to other.swapAttempts, engine)
        }
        val torn = home.resolve("torn")
        Run.start(scenario(setting, "output.checkpointEvery=3"), "test", torn, engines = Engines)
            .use { it.execute(cancelled = { it.simulation.step >= 7 }) }
        val resumed = Run.resume(torn, engines = Engines).use { it.execute() }
        assertEquals(whole.stateDigest, resumed.stateDigest)
        assertEquals(whole.swaps to whole.swapAttempts, resumed.swaps to resumed.swapAttempts)
        val recorded = Run.open(home.resolve("whole"))
        val step = recorded.steps()[2]
        if ("piston" !in setting) {
            val again = run("again", RunOrigin(recorded, recorded.atStep(step)), setting)
            assertEquals(whole.stateDigest, again.stateDigest)
        }
    }

    @Test
    fun `discs swap places, and spheres that swap none are another run`() {
        val flat = arrayOf("dimensions=2", "box.lengths=[16, 16]")
        val swapped = run("flat", null, *flat)
        assertTrue(swapped.swaps > 100) { "${swapped.swaps}" }
        assertEquals(swapped.stateDigest, run("horizon", null, *flat, "engine.name=horizon").stateDigest)
        val none = run("none", null, *flat, "swaps=null")
        assertEquals(0, none.swapAttempts)
        assertTrue(none.stateDigest != swapped.stateDigest)
        val setup = ScenarioSetup.of(scenario(*flat), "test")
        assertEquals(
            stateDigest(setup.population),
            stateDigest(ScenarioSetup.of(scenario(*flat, "swaps=null"), "test").population),
        )
    }

    @Test
    fun `rates out of range, and what is not known to keep its balance, are refused with the key`() {
        for ((setting, words) in mapOf(
            "swaps.rate=0" to "swaps.rate: is 0.0; must be > 0",
            "swaps.rate=-1" to "swaps.rate",
            "swaps.rate=1e999" to "swaps.rate",
            "swaps.rate=1e5" to "swaps.rate: is 100000.0; draws more than 1000 pairs per sphere in a step",
            "until=1e13" to "swaps.rate: is 40.0; draws more than",
            "swaps={}" to "swaps",
            "swaps.seed=3" to "swaps.seed",
            "bodies=[{\"radius\": 1, \"position\": [0, 0, 0], \"density\": 1, \"material\": \"a\"}]" to
                "swaps: need spheres without bodies",
            "bonds={\"length\": 2, \"greatest\": 1.2}" to "swaps: need spheres without interaction and bonds",
            "interaction={\"type\": \"square-well\", \"ratio\": 1.2, \"depth\": 1}" to
                "swaps: need spheres without inter",
            "merging={\"type\": \"always\"}" to "swaps: need spheres that neither merge nor break",
            "breaking={\"speed\": 2, \"pieces\": 3, \"spread\": 0.3, \"smallest\": 0.2}" to
                "swaps: need spheres that ne",
            "forces=[{\"type\": \"uniform-acceleration\", \"acceleration\": [0, 0, -1]}]" to
                "swaps: need spheres on which no force",
            "boundary={\"type\": \"lees-edwards\", \"shearRate\": 0.1}" to "swaps: need a boundary without shear",
            "boundary={\"type\": \"sheared-periodic\", \"velocityJump\": 0.1}" to
                "swaps: need a boundary without shear",
            "frame={\"type\": \"hill\", \"angularSpeed\": 1}|boundary={\"type\": \"open\"}" to
                "swaps: need a frame that does not turn",
        )) {
            val settings = setting.split('|').toTypedArray()
            val e = assertThrows(InputException::class.java, { ScenarioSetup.of(scenario(*settings), "test") }, setting)
            assertTrue(words in e.message!!) { "$setting: ${e.message}" }
        }
    }

    private companion object {
        const val MIXTURE = """{"name": "swaps", "until": 2, "box": {"lengths": [9.5, 9.5, 9.5]},
            "boundary": {"type": "periodic"}, "placement": {"type": "random"},
            "particles": {"materials": [
            {"name": "a", "count": 70, "density": 1, "sizes": {"type": "equal", "radius": 0.5}},
            {"name": "b", "count": 70, "density": 2, "sizes": {"type": "equal", "radius": 0.4}}]},
            "velocities": {"type": "gaussian", "sigma": 1.0}, "swaps": {"rate": 40},
            "restitution": {"type": "constant", "coefficient": 1}, "timeStep": {"type": "fixed", "dt": 0.05},
            "output": {"snapshotEvery": 4}}"""
    }
}
