package daphnis.app

import daphnis.core.run.Summary
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

@Tag("jdk-neutral")
class SweepCommandTest {
    @TempDir
    lateinit var folder: Path

    private val small = arrayOf("cooling-gas", "--set", "particles.count=60", "--set", "until=2")

    private fun out(name: String) = "${folder.resolve(name)}"

    private fun sweep(vararg words: String) = daphnis("sweep", *words)

    private fun lines(file: String) = Files.readAllLines(folder.resolve(file))

    @Test
    fun `a sweep leaves runs like those of run, tables of their numbers and plots`() {
        val words = arrayOf(*small, "--set", "restitution.coefficient=0.5,0.9", "--seeds", "3,4")
        val said = assertDone(sweep(*words, "--out", out("a"), "--quiet"))
        val names = listOf("0.5" to 3, "0.5" to 4, "0.9" to 3, "0.9" to 4).map { (e, s) -> "coefficient=$e,seed=$s" }
        assertEquals(names.toSet(), folder.resolve("a/runs").toFile().list()!!.toSet())
        val set = small.drop(1).toTypedArray()
        assertDone(
            daphnis(
                "run", "cooling-gas", *set, "--set", "restitution.coefficient=0.9", "--seed", "4", "--out", out("one"),
                "--quiet",
            ),
        )
        val one = Summary.read(folder.resolve("one/summary.json"))
        val same = Summary.read(folder.resolve("a/runs/coefficient=0.9,seed=4/summary.json"))
        assertEquals(one.stateDigest, same.stateDigest)
        assertEquals(lines("one/scenario.json"), lines("a/runs/${names[3]}/scenario.json"))
        val runs = lines("a/runs.csv").map { it.substringAfter('"').substringAfter("\",").split(',') }
        val column = lines("a/runs.csv")[0].split(',').indexOfFirst { it.startsWith("end_granular_temperature") }
        // The name of a run has a comma, which is within quotation marks: one column less.
        val ends = runs.drop(1).map { it[column - 1].toDouble() }
        assertEquals(one.temperature, ends[3])
        val mean = lines("a/sweep.csv").single { it.startsWith("0.9,end_granular_temperature,") }.split(',')
        assertEquals((ends[2] + ends[3]) / 2, mean[3].toDouble(), 1e-15)
        assertEquals(Math.abs(ends[2] - ends[3]) / 2, mean[4].toDouble(), 1e-15)
        assertEquals("2", mean[5])
        assertTrue("±" in said && "n = 2 runs" in said) { said }
        assertTrue(said.trim() in Files.readString(folder.resolve("a/sweep.md")))
        assertTrue(Files.size(folder.resolve("a/plots/end_granular_temperature.png")) > 1000)
    }

    @Tag("thorough")
    @Test
    fun `the tables do not depend on the number of runs at a time, and the same command does nothing again`() {
        val words = arrayOf(*small, "--seeds", "1..3", "--set", "timeStep.dt=0.1,0.05")
        assertDone(sweep(*words, "--jobs", "1", "--out", out("a")))
        assertDone(sweep(*words, "--jobs", "3", "--out", out("b"), "--quiet"))
        assertEquals(lines("a/sweep.csv"), lines("b/sweep.csv"))
        val checkpoint = folder.resolve("a/runs/dt=0.1,seed=2/checkpoint")
        val before = Files.getLastModifiedTime(checkpoint)
        val again = sweep(*words, "--jobs", "2", "--out", out("a"))
        assertDone(again)
        assertEquals(before, Files.getLastModifiedTime(checkpoint))
        assertTrue("6 of 6 runs" in again.err) { again.err }
        assertEquals(lines("b/sweep.csv"), lines("a/sweep.csv"))
        val tables = listOf("sweep.csv", "runs.csv", "sweep.md").map { folder.resolve("a/$it") }
        assertReplacedWhole(tables) { assertDone(sweep(*words, "--out", out("a"), "--quiet")) }
    }

    @Tag("thorough")
    @Test
    fun `a file that is changed or removed while the sweep goes on changes none of its runs`() {
        val file = folder.resolve("own.json")
        Files.writeString(file, daphnis("scenarios", "cooling-gas").out)
        val wanted = arrayOf("--set", "restitution.coefficient=0.5,0.7,0.9", "--jobs", "1", "--quiet")
        assertDone(sweep("$file", *small.drop(1).toTypedArray(), *wanted, "--out", out("a")))
        val remover = Thread {
            while (!Files.exists(folder.resolve("b/runs"))) Thread.sleep(1)
            Files.delete(file)
        }
        remover.start()
        assertDone(sweep("$file", *small.drop(1).toTypedArray(), *wanted, "--out", out("b")))
        remover.join()
        assertEquals(lines("a/sweep.csv"), lines("b/sweep.csv"))
    }

    @Test
    fun `one seed has no error, and a value may hold commas`() {
        val boxes = "box.lengths=[20,20,20],[10,10,10]"
        val said = assertDone(sweep(*small, "--set", boxes, "--out", out("a"), "--quiet"))
        assertFalse("±" in said) { said }
        assertTrue(Regex("\\| +\\[20,20,20] \\| +\\[10,10,10] \\|").containsMatchIn(said)) { said }
        val cell = lines("a/sweep.csv").single { it.startsWith("\"[10,10,10]\",filling_factor,") }
        assertTrue(cell.endsWith(",,1,")) { cell }
        assertTrue(Files.exists(folder.resolve("a/runs/lengths=20-20-20/summary.json")))
    }

    @Test
    fun `a link without a target is told as such, as by run`() {
        Files.createSymbolicLink(Path.of(out("link")), Path.of("nowhere"))
        val result = sweep("cooling-gas", "--seeds", "1..2", "--out", out("link"))
        assertEquals("daphnis: --out: ${out("link")} is a link without a target", result.err.trim())
    }

    @Test
    fun `runs that fail are said, and the others go on`() {
        val result = sweep(
            *small.take(1).toTypedArray(),
            "--set",
            "until=1",
            "--set",
            "particles.count=50",
            "--set",
            "box.lengths=[3.4,3.4,3.4],[10,10,10]",
            "--out",
            out("a"),
            "--quiet",
        )
        assertEquals(1, result.code) { result.err }
        assertTrue("failed: lengths=3.4-3.4-3.4: cooling-gas: particles.count: is 50" in result.out) { result.out }
        assertEquals("daphnis: 1 of 2 runs failed, see ${out("a")}/runs.csv", result.err.trim())
        val few = ",1,seed 1 not known to be steady: too few rows in the time averaged"
        val room = "\"[10,10,10]\",granular_temperature,"
        assertTrue(lines("a/sweep.csv").any { it.startsWith(room) && it.endsWith(few) })
        val failed = lines("a/sweep.csv").first { it.startsWith("\"[3.4,") }
        assertTrue(",,0," in failed && "seed 1 failed: cooling-gas" in failed) { failed }
    }

    @Test
    fun `a plot that a killed sweep had no time for is drawn by the next, and the run is not made again`() {
        val words = arrayOf(*small, "--seeds", "1,2", "--out", out("a"), "--quiet")
        assertDone(sweep(*words))
        val run = folder.resolve("a/runs/seed=1")
        val plots = listOf("run.svg", "run.png").map { run.resolve("plots/$it") }
        val (before, summary) = plots.map { Files.size(it) } to Files.readString(run.resolve("summary.json"))
        // In the middle of the plot, and before it.
        for (missing in listOf(plots.drop(1), plots)) {
            missing.forEach(Files::delete)
            assertDone(sweep(*words))
            assertEquals(before, plots.map { Files.size(it) })
            assertEquals(summary, Files.readString(run.resolve("summary.json")))
        }
    }

    @Test
    fun `a table that was damaged is said on the error stream with its run and the mend, and the sweep has failed`() {
        val words = arrayOf(*small, "--seeds", "1,2", "--out", out("a"), "--quiet")
        assertDone(sweep(*words))
        val run = folder.resolve("a/runs/seed=1")
        val series = run.resolve("series.csv")
        val whole = Files.readString(series)
        for (damaged in listOf(whole.dropLast(whole.length / 3), whole.replaceFirst('1', '2'), null)) {
            if (damaged == null) Files.delete(series) else Files.writeString(series, damaged)
            val result = sweep(*words)
            assertEquals(1, result.code) { result.out + result.err }
            val line = result.err.trim().lines().first()
            assertTrue(line.startsWith("daphnis: seed=1: ") && "series.csv" in line) { result.err }
            assertTrue("without the directory it is done again" in line) { result.err }
            assertTrue("1 of 2 runs failed" in result.err) { result.err }
        }
        run.toFile().deleteRecursively()
        assertDone(sweep(*words))
        assertEquals(whole, Files.readString(series))
    }

    @Tag("thorough")
    @Test
    fun `a run that was resumed to another end is not taken for the sweep's, and is done again when it is removed`() {
        val words = arrayOf(*small, "--seeds", "1,2", "--out", out("a"), "--quiet")
        assertDone(sweep(*words))
        val before = lines("a/sweep.csv")
        val run = folder.resolve("a/runs/seed=1")
        assertDone(daphnis("resume", "$run", "--until", "9", "--quiet"))
        val result = sweep(*words)
        assertEquals(1, result.code) { result.err }
        assertTrue("resumed to until=9.0, and the runs of this sweep end at until=" in result.out) { result.out }
        run.toFile().deleteRecursively()
        assertDone(sweep(*words))
        assertEquals(before, lines("a/sweep.csv"))
    }

    @Tag("thorough")
    @Test
    fun `a run that was replaced by hand by another is left out, and one that is the same is taken`() {
        val words = arrayOf(*small, "--set", "restitution.coefficient=0.5,0.9", "--out", out("a"), "--quiet")
        val set = small.drop(1).toTypedArray()
        assertDone(sweep(*words))
        val run = out("a/runs/coefficient=0.5")
        fun by(vararg other: String): CommandResult {
            assertDone(daphnis("run", "cooling-gas", *set, *other, "--out", run, "--force", "--quiet"))
            return sweep(*words)
        }
        val own = "restitution.coefficient=0.5"
        assertDone(by("--set", own, "--engine", "serial"))
        for ((other, why) in listOf(
            listOf("--set", own, "--seed", "7") to "seed: is 1; the run was made with 7",
            listOf("--set", "restitution.coefficient=0.6") to
                "restitution.coefficient: is 0.5; the run was made with 0.6",
        )) {
            val result = by(*other.toTypedArray())
            assertEquals(1, result.code) { result.err }
            assertTrue("failed: coefficient=0.5: $run holds another run than that of this sweep: $why" in result.out) {
                result.out
            }
            assertTrue(lines("a/sweep.csv").filter { it.startsWith("0.5,") }.all { ",,0," in it })
        }
    }

    @Tag("thorough")
    @Test
    fun `runs in orbits, from a file and with what a scenario leaves open are known again`() {
        val ring = arrayOf("ring-patch", "--set", "untilOrbits=0.02", "--set", "box.lengths=[20,20,20]")
        val every = arrayOf("--set", "output.snapshotInterval=0.01", "--set", "output.intervalUnit=orbit")
        repeat(2) { assertDone(sweep(*ring, *every, "--seeds", "1,2", "--out", out("rings"), "--quiet")) }
        val file = folder.resolve("two.csv")
        Files.writeString(file, "x,y,z,vx,vy,vz,radius,mass\n-2,0,0,1,0,0,0.5,1\n2,0,0,-1,0,0,0.5,1\n")
        val own = folder.resolve("own.json")
        Files.writeString(
            own,
            """{"box": {"lengths": [10, 10, 10]}, "boundary": {"type": "periodic"}, "until": 3,
                "placement": {"type": "file", "path": "two.csv"},
                "guard": {"type": "floor-speed", "relative": 0.1},
                "restitution": {"type": "constant", "coefficient": 0.9}}""",
        )
        val words = arrayOf("$own", "--set", "restitution.coefficient=0.5,0.9", "--out", out("a"), "--quiet")
        repeat(2) { assertDone(sweep(*words)) }
        Files.writeString(file, Files.readString(file).replace("-1,", "-2,"))
        val result = sweep(*words)
        assertEquals(1, result.code) { result.err }
        assertTrue("placement.path: $file differs from" in result.out) { result.out }
    }

    @Test
    fun `runs whose snapshots were removed have the ends of the series, and that is said once`() {
        val words = arrayOf(*small, "--seeds", "1,2", "--out", out("a"), "--quiet")
        assertDone(sweep(*words))
        for (seed in 1..2) folder.resolve("a/runs/seed=$seed/snapshots").toFile().deleteRecursively()
        val result = sweep(*words)
        val said = assertDone(result)
        assertTrue("temperature at the end" in said && "filling factor" !in said) { said }
        assertTrue("2 runs: no numbers of the report: has no snapshots" in said) { said }
        assertEquals("", result.err)
        assertFalse(Files.exists(folder.resolve("a/plots")))
    }

    @Tag("thorough")
    @Test
    fun `runs that are not steady are counted below the table`() {
        val words = arrayOf("cooling-gas", "--set", "until=20", "--set", "particles.count=300", "--seeds", "1,2")
        val said = assertDone(sweep(*words, "--out", out("a"), "--quiet"))
        assertTrue("!: not steady over the time averaged, in 2 of 2 runs" in said) { said }
        assertTrue(lines("a/runs.csv").drop(1).all { it.endsWith(",not steady over the time averaged") })
    }

    @Test
    fun `another sweep in the directory, and something else in it, are refused`() {
        val words = arrayOf(*small, "--out", out("a"), "--quiet")
        assertDone(sweep(*words, "--seeds", "1,2"))
        assertRefused(sweep(*words, "--seeds", "1,2,3"), out("a"), "--seeds was 1,2 and is 1..3")
        assertRefused(
            sweep(*words, "--seeds", "1,2", "--set", "timeStep.dt=0.2"),
            "timeStep.dt was not given and is 0.2",
        )
        assertRefused(sweep("elastic-gas", *words.drop(1).toTypedArray(), "--seeds", "1,2"), "of the scenario was")
        Files.writeString(folder.resolve("mine"), "")
        assertRefused(sweep(*small, "--seeds", "1,2", "--out", "$folder"), "not empty and holds no sweep")
        assertRefused(sweep(*small, "--seeds", "1,2", "--out", out("mine")), "no directory")
    }

    @Test
    fun `what is wrong is told in one line, before anything is run`() {
        val none = out("none")
        fun refused(vararg words: String, parts: List<String>) =
            assertRefused(sweep(*words, "--out", none), *parts.toTypedArray())
        refused("cooling-gas", parts = listOf("--set", "nothing to sweep"))
        refused("cooling-gas", "--set", "until=1", parts = listOf("--set", "nothing to sweep"))
        refused("cooling-gas", "--set", "until=1..4", parts = listOf("until", "1..4 is one value", "until=1,2,4"))
        refused("cooling-gas", "--set", "name=a,b", parts = listOf("name", "would all be the same"))
        refused("cooling-gas", "--set", "seed=1,2", parts = listOf("seed", "--seeds"))
        refused("cooling-gas", "--set", "until=1,2", "--set", "until=3", parts = listOf("until", "twice"))
        refused("cooling-gas", "--set", "until", parts = listOf("path=value"))
        refused("cooling-gas", "--set", "until=1,,2", parts = listOf("until", "empty value"))
        refused("cooling-gas", "--set", "untl=1,2", parts = listOf("untl", "until"))
        refused("cooling-gas", "--set", "until=1,x", parts = listOf("until"))
        refused("coolin-gas", "--seeds", "1,2", parts = listOf("did you mean 'cooling-gas'"))
        refused("cooling-gas", "--seeds", "one", parts = listOf("--seeds", "'one'", "1..8"))
        refused("cooling-gas", "--seeds", "1..9000", "--set", "until=1,2", parts = listOf("more than 10000"))
        refused("cooling-gas", "--seeds", "1,2", "--jobs", "0", parts = listOf("--jobs", "is 0"))
        refused("cooling-gas", "--seeds", "1,2", "--from", "NaN", parts = listOf("--from", "NaN"))
        refused("cooling-gas", "--seeds", "1,2", "--engine", "seriel", parts = listOf("did you mean 'serial'"))
        refused("cooling-gas", "--seed", "1,2", parts = listOf("--seeds"))
        assertFalse(Files.exists(folder.resolve("none")))
    }

    @Test
    fun `a value with which a run could not start is told before anything is run`() {
        fun wrong(vararg words: String, line: String) {
            val result = sweep("cooling-gas", *words, "--out", out("none"))
            assertRefused(result)
            assertEquals("daphnis: cooling-gas: $line", result.err.trim())
        }
        val depth = arrayOf("--set", "particles.count=null", "--set", "particles.opticalDepth=0.1,-5")
        wrong(*depth, line = "particles.opticalDepth: is -5.0; must be > 0")
        wrong(
            "--set",
            "particles.count=5,x",
            line = "particles.count: is \"x\"; it must be a whole number below 2147483648",
        )
        wrong("--set", "restitution.coefficient=0.5,1.5", line = "restitution.coefficient: is 1.5; must be in [0, 1]")
        wrong("--set", "timeStep.dt=0.1,0", "--seeds", "1,2", line = "timeStep.dt: is 0.0; must be > 0")
        val edge = "box.lengths[0]: is 0.9; must exceed the diameter of the largest sphere, 1.0, or it would touch " +
            "its own image; this is with particles.count=1, box.lengths=[0.9,9,9]"
        wrong("--set", "particles.count=1,2", "--set", "box.lengths=[9,9,9],[0.9,9,9]", line = edge)
        wrong("--set", "engine.threads=1,-1", line = "engine.threads: is -1; must be in 1..256, or 0 for one per core")
        assertFalse(Files.exists(folder.resolve("none")))
    }
}
