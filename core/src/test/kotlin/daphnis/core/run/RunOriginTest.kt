package daphnis.core.run

import daphnis.core.input.InputException
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** A run that starts from a state of another. */
class RunOriginTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name)

    private fun ring(vararg settings: String) = ScenarioJson.parse(
        """{ "units": { "lengthInMetres": 1 }, "frame": { "type": "hill", "angularSpeed": 0.7 },
          "box": { "lengths": [30, 25, 8] }, "boundary": { "type": "hill-sheet" },
          "particles": { "count": 120, "sizes": { "type": "list", "radii": [0.4, 0.7] }, "density": 2 },
          "bodies": [{ "radius": 2, "position": [3, 0, 0] }],
          "velocities": { "type": "gaussian", "sigma": 0.4, "shearProfile": true },
          "restitution": { "type": "constant", "coefficient": 0.5 },
          "forces": [{ "type": "body-gravity", "constant": 0.1 },
            { "type": "satellite", "mass": 3e5, "x": -20, "y": 3, "e": 0.5, "softening": 0.5 }],
          "timeStep": { "type": "fixed", "dt": 0.037 }, "until": 1.85,
          "output": { "snapshotEvery": 7, "checkpointEvery": 5 } }""",
        "ring",
        settings.toList(),
    )

    private fun run(scenario: Scenario, name: String, from: RunOrigin? = null, steps: Long = Long.MAX_VALUE) =
        Run.start(scenario, "test", at(name), from = from).toStep(steps)

    private fun origin(name: String, step: Long? = null): RunOrigin {
        val run = Run.open(at(name))
        return RunOrigin(run, step?.let { run.atStep(it) } ?: run.last())
    }

    private fun written(name: String) = ScenarioJson.read(at("$name/scenario.json"))

    @Test
    fun `it ends in the bits of the uninterrupted run, from any state, and from a state of a run that did so`() {
        val rough = ring("name=rough", ROUGH, """spins={"type": "gaussian", "sigma": 0.3, "mean": [0, 0.5, 0]}""")
        for (scenario in listOf(ring(), rough, tableScenario(), tableScenario("timeStep.dt=0.0937"))) {
            val name = "${scenario.name}${(scenario.timeStep as daphnis.core.scenario.TimeStepSpec.Fixed).dt}"
            val whole = run(scenario, name)
            for (step in Run.open(at(name)).steps().dropLast(1)) {
                val from = run(written(name), "$name-$step", origin(name, step))
                assertEquals(whole.stateDigest, from.stateDigest) { "$name from $step" }
                assertEquals(whole.time, from.time)
                assertEquals(whole.steps - step, from.steps)
            }
            run(written(name), "$name-a", origin(name, if (name.startsWith("t")) 4 else 7), steps = 4)
            // From the checkpoint of a run that was interrupted: there is no snapshot of its step.
            assertEquals(listOf(0L, 4L), Run.open(at("$name-a")).steps())
            assertEquals(whole.stateDigest, run(written(name), "$name-b", origin("$name-a")).stateDigest)
        }
    }

    @Test
    fun `without the clock of the other run the images would be elsewhere in the last bits`() {
        val whole = run(ring(), "a")
        val from = run(written("a"), "b", origin("a", 21))
        val placed = written("b").let { it.copy(placement = (it.placement as PlacementSpec.File).copy(clock = null)) }
        val without = run(placed.atHome(at("b")), "c")
        assertEquals(whole.stateDigest, from.stateDigest)
        assertNotEquals(whole.stateDigest, without.stateDigest)
        assertEquals(whole.time, without.time, 1e-12)
    }

    @Test
    fun `interrupted and resumed, and run again from its own directory, it is the same run`() {
        run(ring(), "a")
        val whole = run(written("a"), "b", origin("a", 14))
        Run.start(written("a"), "test", at("c"), from = origin("a", 14)).toStep(8)
        val resumed = Run.resume(at("c")).use { it.execute() }
        assertEquals(whole.stateDigest, resumed.stateDigest)
        assertEquals("step 14 of ${at("a")}, time ${14 * 0.037}", resumed.from)
        assertEquals(results(at("b")), results(at("c")))
        assertEquals(whole.stateDigest, run(written("b").atHome(at("b")), "d").stateDigest)
    }

    @Test
    fun `it keeps ids, masses and bodies, begins with step 0 at the time of the state, and counts boxes anew`() {
        run(ring(), "a")
        run(written("a"), "b", origin("a", 14))
        val there = Run.open(at("a")).atStep(14)
        val here = Run.open(at("b")).atStep(0)
        assertEquals(there.id.asList(), here.id.asList())
        assertEquals(there.mass.asList(), here.mass.asList())
        assertEquals(there.radius.asList(), here.radius.asList())
        assertEquals(there.time, here.time)
        assertEquals(there.shearOffset, here.shearOffset)
        assertTrue(there.image!!.any { axis -> axis.any { it != 0 } }) { "no sphere crossed a face" }
        assertTrue(here.image!!.all { axis -> axis.all { it == 0 } })
        assertEquals(1, written("b").bodies.size)
        assertEquals(120, written("b").firstBody(0))
        assertTrue(Files.readAllLines(at("b/series.csv"))[1].startsWith("0,${there.time},121,0,"))
    }

    @Test
    fun `other parameters go on from the same state`() {
        run(ring(), "a")
        val other = ring("timeStep.dt=0.02", "restitution.coefficient=0.9", "until=1.0")
        val summary = run(other, "b", origin("a", 14))
        assertEquals(14 * 0.037 + 25 * 0.02, summary.time, 1e-12)
        assertEquals(25, summary.steps)
        // A clock that does not lead to the time with this step is left out.
        val again = run(written("b").atHome(at("b")), "c")
        assertEquals(summary.stateDigest, again.stateDigest)
    }

    @Test
    fun `what does not fit the state is refused with the key and both values, and no directory is made`() {
        run(ring(), "a")
        run(tableScenario(), "t")
        fun wrong(scenario: Scenario, origin: RunOrigin, vararg words: String) {
            val e = assertThrows(InputException::class.java) { run(scenario, "wrong", origin) }
            for (word in words) assertTrue(word in e.message.orEmpty()) { "'$word' is not in ${e.message}" }
            assertTrue(!Files.exists(at("wrong"))) { e.message }
        }
        wrong(ring("box.lengths[1]=26"), origin("a", 14), "box.lengths[1]", "26.0", "25.0", "after step 14")
        wrong(ring("frame.angularSpeed=0.8"), origin("a", 14), "frame", "0.8", "0.7")
        wrong(ring("frame.radialFactor=0.9"), origin("a", 14), "frame", "has κ/Ω 0.9", "1.0")
        wrong(ring("units.lengthInMetres=2"), origin("a", 14), "units.lengthInMetres", "is 2.0", "1.0")
        wrong(ring("particles.count=100"), origin("a", 14), "particles.count", "is 100", "has 120")
        wrong(ring("bodies=[]", "forces=[]"), origin("a", 14), "bodies", "0 entries", "1 entry")
        wrong(ring("until=0.1"), origin("a", 14), "until", "0.1", "later than", "0.518")
        wrong(tableScenario(), origin("a", 14), "bodies")
        // Modes need a box that repeats.
        val open = arrayOf("boundary={\"type\":\"open\"}", "output.modesEvery=0")
        run(tableScenario(*open, "velocities.shearProfile=false"), "open")
        val framed = """frame={"type":"hill","angularSpeed":1}"""
        wrong(tableScenario(*open, framed, "until=9"), origin("open"), "frame", "is in none")
        wrong(tableScenario("particles.count=61"), origin("t"), "particles.count", "is 61", "has 60")
        wrong(tableScenario("boundary.shearRate=0.5"), origin("t", 4), "boundary", "off by", "placement.time")
        wrong(tableScenario("until=1.2"), origin("t"), "until", "later than", "1.2")
        val walls =
            tableScenario("boundary={\"type\":\"walls\"}", "output.modesEvery=0", "box.lengths=[6,9,9]", "until=9")
        wrong(walls, origin("t", 4), "placement", "outside the box")
        val unsheared = tableScenario("boundary={\"type\":\"periodic\"}", "until=9")
        wrong(unsheared, origin("t", 4), "boundary", "off by 0.0 at time 0.4", "1.96")
    }

    @Test
    fun `a guard that counts from the last collisions says that it begins anew`() {
        run(tableScenario(), "a")
        val guarded = tableScenario("guard={\"type\":\"contact-duration\",\"duration\":0.01}", "until=1.4")
        fun notices(scenario: Scenario, name: String) =
            Run.start(scenario, "test", at(name), from = origin("a")).use { run -> run.notices.toString() }
        assertTrue("guard.duration" in notices(guarded, "b"))
        assertTrue("guard.duration" !in notices(tableScenario("until=1.4"), "c"))
    }

    @Test
    fun `spheres that would overlap through a face are refused`() {
        // Open at first: two spheres at opposite sides of what becomes a periodic box.
        Files.writeString(at("two.csv"), "x,y,z,radius\n-3.6,0,0,0.5\n3.6,0,0,0.5\n")
        val open = ScenarioJson.parse(
            """{ "box": { "lengths": [8, 8, 8] }, "boundary": { "type": "open" },
              "placement": { "type": "file", "path": "two.csv" }, "restitution": { "type": "constant",
              "coefficient": 1 }, "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 0.2 }""",
            "open",
        )
        run(open.atHome(home), "a")
        val closed = ScenarioJson.parse(ScenarioJson.write(open), "closed", listOf("boundary.type=periodic", "until=1"))
        val e = assertThrows(InputException::class.java) { run(closed, "b", origin("a")) }
        assertTrue("overlap" in e.message.orEmpty()) { e.message }
    }

    @Test
    fun `smooth spheres of a run may become rough, with spins that are asked for, and rough ones smooth`() {
        run(ring(), "a")
        val spins = """spins={"type": "rest", "mean": [0, 0, 0.5]}"""
        run(ring(ROUGH, spins), "b", origin("a"), steps = 1)
        val first = Run.open(at("b")).let { it.atStep(0) }
        assertTrue(first.hasSpin && first.wz.all { it == 0.5 })
        run(ring(), "c", origin("b"), steps = 1)
        assertTrue(!Run.open(at("c")).atStep(0).hasSpin)
        // Spins of the state stand in place of those at another start.
        run(ring(ROUGH, spins), "d", origin("b"), steps = 1)
        assertEquals(Run.open(at("b")).last().wz.toList(), Run.open(at("d")).atStep(0).wz.toList())
    }

    private companion object {
        const val ROUGH = """roughness={"type": "coulomb", "friction": 0.4, "sticking": 0.3}"""
    }
}
