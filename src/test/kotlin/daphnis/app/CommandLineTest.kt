package daphnis.app

import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** The command line as a user meets it, in this process. */
class CommandLineTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name).toString()

    private fun small(name: String, vararg more: String) =
        daphnis("run", "cooling-gas", "--set", "particles.count=100", "--steps", "20", "--out", at(name), *more)

    @Test
    fun `a run leaves a plot in both formats and says its digest`() {
        val result = small("a")
        assertEquals(0, result.code) { result.err }
        assertTrue("state digest" in result.out)
        assertTrue(Files.size(home.resolve("a/plots/run.png")) > 10_000)
        val svg = Files.readString(home.resolve("a/plots/run.svg"))
        assertTrue("granular temperature" in svg && "cooling-gas" in svg && "time [units of time]" in svg)
    }

    @Test
    fun `the same seed gives the same digest, another seed another`() {
        small("a")
        small("b")
        small("c", "--seed", "2")
        assertEquals(0, daphnis("compare", at("a"), at("b")).code)
        val differs = daphnis("compare", at("a"), at("c"))
        assertEquals(1, differs.code)
        assertTrue("step 0: particle 0, x =" in differs.out) { differs.out }
    }

    @Tag("thorough")
    @Test
    fun `every engine gives the same digest and the same log of collisions, and the summary says which it was`() {
        val logs = HashSet<String>()
        val digests = HashSet<String>()
        for ((engine, threads) in listOf(
            "serial" to 1,
            "islands" to 1,
            "islands" to 3,
            "thread-pool" to 2,
            "horizon" to 1,
            "horizon" to 3,
            "actors" to 2,
            "pekko" to 2,
        )) {
            val name = "$engine-$threads"
            val result = small(name, "--engine", engine, "--threads", "$threads", "--set", "output.collisionLog=true")
            assertEquals(0, result.code) { result.err }
            digests += result.out.lines().first { it.startsWith("state digest") }
            logs += Files.readString(home.resolve(name).resolve("collisions.csv"))
            val summary = Files.readString(home.resolve(name).resolve("summary.json"))
            assertTrue(summary.contains("\"engine\": \"$engine\"") && summary.contains("\"threads\": $threads")) {
                summary
            }
        }
        assertEquals(1, digests.size)
        assertEquals(1, logs.size)
        assertTrue(logs.first().lines().size > 10)
        assertRefused(small("x", "--engine", "isles"), "engine.name", "islands", "pekko")
        assertRefused(small("y", "--engine", "serial", "--threads", "2"), "engine.threads")
        assertRefused(small("z", "--threads", "-1"), "--threads")
    }

    @Test
    fun `resume goes on to a later end, to the same bits as one run`() {
        small("a")
        assertEquals(0, daphnis("resume", at("a"), "--until", "4").code)
        daphnis("run", "cooling-gas", "--set", "particles.count=100", "--until", "4", "--out", at("b"), "--quiet")
        assertEquals(0, daphnis("compare", at("a"), at("b")).code)
        val (a, b) = listOf("a", "b").map { ScenarioJson.read(Path.of(at(it), "scenario.json")) }
        assertEquals(b.until, a.until)
        val again = assertDone(daphnis("resume", at("a")))
        assertTrue("100 spheres, from step 40, already at the end, time 4 " in again) { again }
    }

    @Test
    fun `every format is exported`() {
        small("a", "--set", "output.snapshotEvery=10")
        for ((format, file) in listOf(
            "xyz" to "trajectory.xyz",
            "vtp" to "trajectory.pvd",
            "h5md" to "trajectory.h5",
            "cartandrad" to "CartAndRad.20.bin",
            "lammps" to "trajectory.lammpstrj",
        )) {
            val result = daphnis("export", at("a"), "--format", format)
            assertEquals(0, result.code) { result.err }
            assertTrue(Files.size(home.resolve("a/export").resolve(file)) > 100) { format }
        }
        assertRefused(daphnis("export", at("a"), "--format", "xyz", "--scale", "-1"), "--scale")
        assertRefused(daphnis("export", at("a"), "--format", "pdf"), "pdf", "xyz")
    }

    @Test
    fun `scenarios are listed, printed and described`() {
        assertTrue("paper-figure-1" in daphnis("scenarios").out)
        val text = daphnis("scenarios", "shear-cell").out
        assertTrue(text.startsWith("//") && "lees-edwards" in text)
        val file = Files.writeString(home.resolve("mine.json"), text)
        val described = daphnis("describe", file.toString())
        assertEquals(0, described.code) { described.err }
        assertTrue("filling factor" in described.out && "2048" in described.out) { described.out }
    }

    @Test
    fun `wrong input is one line and exit code 2`() {
        assertRefused(daphnis("run", "nowhere.json"), "nowhere.json", "no such file")
        assertRefused(daphnis("describe", home.toString()), "is a directory")
        assertRefused(daphnis("describe", "cooling-gas", "--set", "engine.name=warp"), "engine.name", "warp", "serial")
        assertRefused(daphnis("scenarios", "paper"), "paper-figure-1")
        assertRefused(daphnis("run", "cooling-gas", "--set", "timestep.dt=1", "--out", at("x")), "timestep", "timeStep")
        assertRefused(daphnis("run", "cooling-gas", "--steps", "3", "--until", "4", "--out", at("x")), "--steps")
        assertRefused(daphnis("run", "cooling-gas", "--steps", "0", "--out", at("x")), "--steps")
        assertRefused(daphnis("run", "cooling-gas", "--engine", "warp", "--out", at("x")), "engine.name", "serial")
        assertRefused(daphnis("resume", at("x")), "no such file or directory")
        assertRefused(daphnis("resume", home.toString()), "no run directory")
        assertRefused(daphnis("compare", at("x"), at("y")), "no such file or directory")
        small("a")
        assertRefused(small("a"), "exists", "--force")
        assertEquals(0, small("a", "--force").code)
        assertRefused(daphnis("run", "--bogus"), "--bogus", "daphnis run --help")
        assertRefused(daphnis("run", "--seed", "abc"), "--seed", "abc")
        assertRefused(daphnis("export", at("a")), "missing option --format", "xyz", "h5md")
        assertRefused(daphnis("export", at("a"), "--format"), "--format", "xyz", "h5md")
        Files.writeString(home.resolve("empty.json"), " \n")
        assertRefused(daphnis("run", at("empty.json"), "--out", at("x")), "is empty", "JSON object", "scenarios NAME")
        assertRefused(daphnis("fly"), "fly")
        assertRefused(daphnis("resume"), "dir")
        assertRefused(
            daphnis("analyze", at("a"), "--from", "99", "--out", at("elsewhere")),
            "--from",
            "99",
            "last state",
            "time 2",
        )
        assertFalse(Files.exists(home.resolve("elsewhere")))
    }

    @Test
    fun `a collapse ends with exit code 1 and says what to do`() {
        Files.writeString(
            home.resolve("line.csv"),
            "x,y,z,vx,radius\n" + (0 until 40).joinToString("\n") { "${2.0001 * it - 40},0,0,${20 - it},1" },
        )
        Files.writeString(
            home.resolve("collapse.json"),
            """{ "box": { "lengths": [100, 10, 10] }, "boundary": { "type": "open" },
                "placement": { "type": "file", "path": "line.csv" },
                "restitution": { "type": "constant", "coefficient": 0.2 }, "guard": { "type": "none" },
                "timeStep": { "type": "fixed", "dt": 50 }, "until": 50 }""",
        )
        val result = daphnis("run", at("collapse.json"), "--out", at("x"))
        assertEquals(1, result.code) { result.err }
        assertTrue("inelastic collapse" in result.err && "guard" in result.err) { result.err }
    }

    @Test
    fun `one of a kind is named as one`() {
        val words = arrayOf("--set", "particles.count=2", "--steps", "1", "--set", "output.seriesEvery=5", "--quiet")
        val result = daphnis("run", "cooling-gas", *words, "--out", at("one"))
        assertTrue(assertDone(result).startsWith("1 step to time 0.1 ")) { result.out }
        assertEquals(
            "daphnis: no plot: the time series has 1 row; two are needed; the run is complete",
            result.err.trim(),
        )
    }

    @Test
    fun `help and version are no errors`() {
        assertEquals(0, daphnis("--help").code)
        assertEquals(0, daphnis("run", "--help").code)
        assertEquals(0, daphnis("--version").code)
    }

    @Test
    fun `help begins with what a new user needs, has every option under a heading, and keeps to 80 columns`() {
        val order =
            listOf("Arguments:", "Scenario and files:", "Time:", "While it runs:", "Speed:", "Several machines:")
        val run = assertDone(daphnis("run", "--help")).lines()
        assertEquals(order + "Options:", run.filter { it.endsWith(":") && !it.startsWith(" ") })
        for (command in listOf("run", "resume")) {
            val lines = assertDone(daphnis(command, "--help")).lines()
            val rest = lines.dropWhile { it != "Options:" }.filter { it.trim().startsWith("-") }
            assertEquals(1, rest.size) { "$command has options without a heading: $rest" }
        }
        for (command in listOf("run", "resume", "sweep", "analyze", "movie", "bench", "node", "describe", "export")) {
            val help = assertDone(daphnis(command, "--help"))
            assertTrue(help.lines().all { it.length <= 80 }) { help }
        }
    }
}
