package daphnis.app

import daphnis.core.run.Summary
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** The commands with a scenario that leaves the length of a step open. */
class AutomaticStepCommandTest {
    @TempDir
    lateinit var folder: Path

    private fun out(name: String) = "${folder.resolve(name)}"

    private val gas by lazy {
        out("gas.json").also {
            Files.writeString(
                Path.of(it),
                """{ "name": "gas", "box": { "lengths": [9, 9, 9] }, "boundary": { "type": "periodic" },
                "particles": { "count": 100, "sizes": { "type": "equal", "radius": 0.5 } },
                "velocities": { "type": "gaussian", "sigma": 1 }, "engine": { "threads": 2 },
                "restitution": { "type": "constant", "coefficient": 0.8 }, "until": 1.5,
                "output": { "seriesInterval": 0.4, "snapshotInterval": 0.5 } }""",
            )
        }
    }

    private fun digest(name: String) = Summary.read(folder.resolve(name).resolve("summary.json")).stateDigest

    @Tag("thorough")
    @Test
    fun `every engine ends in the same state, and a bench compares them`() {
        for (engine in allEngines.names) {
            val threads = if (engine == "serial") "1" else "2"
            assertDone(daphnis("run", gas, "--engine", engine, "--threads", threads, "--out", out(engine), "--quiet"))
        }
        assertEquals(1, allEngines.names.map { digest(it) }.toSet().size)
        // Not where a bench goes by itself: files among the sources would have ./daphnis build anew.
        val words = arrayOf("--engines", "serial,horizon", "--threads", "1", "--rounds", "1", "--out", out("bench"))
        val said = assertDone(daphnis("bench", gas, *words))
        assertTrue("horizon" in said) { said }
    }

    @Test
    fun `describe says which step is chosen and why`() {
        val said = assertDone(daphnis("describe", gas))
        assertTrue("chosen, since no force acts" in said) { said }
        assertTrue(
            Regex(
                "at \\S+ units of speed along an axis,\\s+moves at most \\S+ length units in a",
            ).containsMatchIn(said),
        ) {
            said
        }
        assertTrue("steps end at the times of outputs and at the end exactly" in said) { said }
        assertTrue("4 rows of series.csv" in said && "4 snapshots" in said) { said }
    }

    @Test
    fun `describe counts the steps that outputs cut short`() {
        val rest = arrayOf("--set", "velocities={\"type\":\"rest\"}")
        val said = assertDone(daphnis("describe", gas, *rest))
        assertTrue("about 6 of 0.4 time units" in said && "fewer where the gas cools" in said) { said }
        assertDone(daphnis("run", gas, *rest, "--out", out("rest"), "--quiet"))
        assertEquals(6, Summary.read(folder.resolve("rest/summary.json")).steps)
        val long = assertDone(daphnis("describe", gas, *rest, "--set", "output={\"seriesInterval\":1e-6}"))
        assertTrue(Regex("about (1500000|1\\.5e6) of 1e-6").containsMatchIn(long)) { long }
    }

    @Tag("thorough")
    @Test
    fun `a sweep, a start from a time, a set interval in place of a number of steps, and a resume`() {
        val words = arrayOf("sweep", gas, "--set", "output.snapshotInterval=0.5,1.5", "--seeds", "1", "--out", out("s"))
        assertDone(daphnis(*words, "--quiet"))
        assertDone(daphnis("run", gas, "--out", out("a"), "--quiet"))
        assertDone(daphnis("run", "--from", "${out("a")}@time=1.0", "--out", out("b"), "--quiet"))
        assertEquals(digest("a"), digest("b"))
        val some = arrayOf("cooling-gas", "--set", "particles.count=60", "--until", "1", "--quiet")
        val interval = arrayOf("--set", "output.snapshotInterval=0.5", "--set", "timeStep={\"type\":\"automatic\"}")
        assertDone(daphnis("run", *some, *interval, "--out", out("c")))
        assertEquals(3, folder.resolve("c/snapshots").toFile().list()!!.size)
        assertDone(daphnis("resume", out("c"), "--until", "2", "--quiet"))
        assertEquals(5, folder.resolve("c/snapshots").toFile().list()!!.size)
        assertRefused(daphnis("run", gas, "--steps", "5", "--out", out("d")), "needs a fixed time step")
    }
}
