package daphnis.core.run

import daphnis.core.format.H5md
import daphnis.core.input.InputException
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class StartTimeTest {
    @TempDir
    lateinit var home: Path

    /** Two spheres that meet through the sliding y face, only where the images are at the time given. */
    private fun scenario(time: String, until: Double, dt: Double = 0.1, y: Double = 3.4): Scenario {
        Files.writeString(home.resolve("start.csv"), "x,y,z,vx,vy,vz,radius\n0,$y,0,2,0.8,0,0.5\n-2,-3.4,0,0,0,0,0.5\n")
        return ScenarioJson.parse(
            """{ "box": { "lengths": [8, 8, 8] }, "boundary": { "type": "lees-edwards", "shearRate": 0.25 },
              "placement": { "type": "file", "path": "start.csv"$time },
              "restitution": { "type": "constant", "coefficient": 1 },
              "timeStep": { "type": "fixed", "dt": $dt }, "until": $until,
              "output": { "snapshotEvery": 5, "checkpointEvery": 3 } }""",
            "test",
        ).atHome(home)
    }

    private fun run(scenario: Scenario, name: String) = Run.start(scenario, "test", home.resolve(name)).use {
        it.execute()
    }

    @Test
    fun `a state placed at a time has its images where they are then, and its times count from there`() {
        // Images slide by 2 in a unit of time: in line again after 4, off by a quarter of the box after 5.
        val now = run(scenario("", 1.0, dt = 0.125), "now")
        val inLine = run(scenario(", \"time\": 4", 5.0, dt = 0.125), "in-line")
        val slid = run(scenario(", \"time\": 5", 6.0), "slid")
        assertEquals(now.stateDigest, inLine.stateDigest)
        assertEquals(listOf(0L, 0L, 1L), listOf(now.collisions, inLine.collisions, slid.collisions))
        assertEquals(6.0, slid.time)
        assertEquals(10L, slid.steps)
        val series = Files.readAllLines(home.resolve("slid/series.csv"))
        assertEquals(listOf("0", "5.0"), series[1].split(',').take(2))
        val snapshot = H5md.read(RunDirectory(home.resolve("slid")).snapshot(0)).single()
        assertEquals(5.0, snapshot.time)
        assertEquals(2.0, snapshot.shearOffset)
    }

    @Tag("thorough")
    @Test
    fun `interrupted and resumed it ends in the same bits, also when the time is no round number`() {
        // Found by trying: an origin that is counted back from the checkpoint is an ulp off here.
        for (time in listOf(0.3, 17.77, 1234.567)) {
            val scenario = scenario(", \"time\": $time", time + 4.05, dt = 0.0937)
            val whole = run(scenario, "whole$time")
            for (steps in listOf(0L, 1L, 7L, 16L)) {
                val name = "broken$time-$steps"
                Run.start(scenario, "test", home.resolve(name)).use { run ->
                    run.execute(cancelled = {
                        run.simulation.step >=
                            steps
                    })
                }
                val resumed = Run.resume(home.resolve(name)).use { it.execute() }
                assertEquals(whole.stateDigest, resumed.stateDigest)
                assertEquals(
                    Files.readString(home.resolve("whole$time/series.csv")),
                    Files.readString(home.resolve("$name/series.csv")),
                ) {
                    name
                }
            }
        }
    }

    @Test
    fun `the run directory's scenario starts at the same time again`() {
        val first = run(scenario(", \"time\": 5", 6.0), "first")
        val again = Run.start(
            ScenarioJson.read(home.resolve("first/scenario.json")).atHome(home.resolve("first")),
            "again",
            home.resolve("b"),
        ).use {
            it.execute()
        }
        assertEquals(first.stateDigest, again.stateDigest)
        assertEquals(6.0, again.time)
    }

    @Test
    fun `an end before the start, an overlap at that time, a time that is none`() {
        fun wrong(scenario: () -> Scenario, vararg words: String) {
            val e = assertThrows(InputException::class.java) { run(scenario(), "wrong") }
            for (word in words) assertTrue(word in e.message.orEmpty()) { e.message }
        }
        wrong({ scenario(", \"time\": 5", 5.0) }, "until", "5.0", "later than placement.time")
        // Through the face they overlap at time 5, when images are off by 2, and not at time 0.
        wrong({ scenario(", \"time\": 5", 6.0, y = 3.9) }, "placement.path", "overlap")
        run(scenario("", 1.0, y = 3.9), "apart")
        wrong({ scenario(", \"time\": \"3\"", 4.0) }, "placement.time", "finite number")
        Run.start(scenario(", \"time\": 5", 6.0), "test", home.resolve("a")).use { run ->
            run.execute(cancelled = {
                run.simulation.step >=
                    2
            })
        }
        assertThrows(InputException::class.java) { Run.resume(home.resolve("a"), until = 4.5) }
        assertEquals(-1.0, run(scenario(", \"time\": -2", -1.0), "before").time)
    }
}
