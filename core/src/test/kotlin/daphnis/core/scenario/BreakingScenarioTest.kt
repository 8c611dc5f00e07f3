package daphnis.core.scenario

import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.run.RunOrigin
import daphnis.core.run.Summary
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

/** Spheres that break and merge, from a scenario to its end, and on from each of its states. */
class BreakingScenarioTest {
    @TempDir
    lateinit var home: Path

    private fun scenario(vararg settings: String) = ScenarioJson.parse(GAS, "test", settings.toList())

    private fun run(name: String, from: RunOrigin? = null): Summary =
        Run.start(scenario(), "test", home.resolve(name), from = from).use { it.execute() }

    @Test
    fun `from each of its states, whose pieces overlap, a run goes on to the same end`() {
        val whole = run("whole")
        val recorded = Run.open(home.resolve("whole"))
        var deepest = 0.0
        for (step in recorded.steps().dropLast(1)) {
            val again = run("$step", RunOrigin(recorded, recorded.atStep(step)))
            assertEquals(whole.stateDigest, again.stateDigest) { "step $step" }
            if (step == 0L) {
                assertEquals(listOf(whole.broken, whole.mergers), listOf(again.broken, again.mergers))
                deepest = again.maxOverlap
            }
        }
        assertTrue(whole.broken > 50 && whole.mergers > 20 && deepest > 0.1) {
            "${whole.broken} ${whole.mergers} $deepest"
        }
        assertEquals(60 + 2 * whole.broken - whole.mergers, whole.particles.toLong())
    }

    @Test
    fun `what cannot break is refused with its key`() {
        for ((setting, words) in mapOf(
            "breaking.speed=-1" to "breaking.speed",
            "breaking.speed=1e999" to "breaking.speed",
            "breaking.pieces=1" to "breaking.pieces: is 1; must be in 2..1000",
            "breaking.pieces=2.5" to "breaking.pieces",
            "breaking.spread=0" to "breaking.spread",
            "breaking.smallest=0" to "breaking.smallest",
            "breaking.seed=3" to "breaking.seed",
            "breaking={\"speed\": 1}" to "breaking",
            "dimensions=2" to "breaking: needs spheres in three dimensions",
            "bonds={\"length\": 2, \"greatest\": 1.2}" to "without interaction and bonds",
            "interaction={\"type\": \"square-well\", \"ratio\": 1.2, \"depth\": 1}" to "without interaction and bonds",
            "roughness={\"type\": \"constant\", \"coefficient\": 0.5}" to "smooth spheres without spins",
            "growth={\"rate\": 0.1}" to "growth",
        )) {
            val e = assertThrows(InputException::class.java) {
                // Discs do not merge either, which is said first.
                val others = if (setting.startsWith(
                        "dim",
                    )
                ) {
                    arrayOf("merging=null", "box.lengths=[9,9]")
                } else {
                    arrayOf("merging=null")
                }
                ScenarioSetup.of(scenario(setting, *others), "test")
            }
            assertTrue(words in e.message!!) { "$setting: ${e.message}" }
        }
    }

    private companion object {
        const val GAS = """{"name": "breaking", "until": 2, "box": {"lengths": [9, 9, 9]},
            "boundary": {"type": "periodic"}, "placement": {"type": "random"},
            "particles": {"count": 60, "sizes": {"type": "equal", "radius": 0.8}, "mass": 1.0},
            "velocities": {"type": "gaussian", "sigma": 2.0}, "merging": {"type": "slow", "speed": 1},
            "breaking": {"speed": 2, "pieces": 3, "spread": 0.3, "smallest": 0.2},
            "restitution": {"type": "constant", "coefficient": 0.9}, "timeStep": {"type": "fixed", "dt": 0.1},
            "output": {"snapshotEvery": 4}}"""
    }
}
