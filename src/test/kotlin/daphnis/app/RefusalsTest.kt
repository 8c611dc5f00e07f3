package daphnis.app

import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.core.context
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.terminal
import com.github.ajalt.mordant.rendering.AnsiLevel
import com.github.ajalt.mordant.terminal.Terminal
import daphnis.core.format.H5md
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** What makes no sense is refused with one line and exit code 2, and leaves what is there alone. */
class RefusalsTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name).toString()

    private fun small(name: String) = daphnis(
        "run", "cooling-gas", "--set", "particles.count=100", "--steps", "20",
        "--set", "output.snapshotEvery=10", "--out", at(name), "--quiet",
    )

    @Test
    fun `several values where a run takes one are refused with a hint at sweep`() {
        val list = "restitution.coefficient=0.5,0.9"
        assertRefused(
            daphnis("run", "shear-cell", "--set", list),
            "restitution.coefficient",
            "0.5,0.9",
            "`daphnis sweep`",
        )
        val other = daphnis("run", "shear-cell", "--set", "restitution.coefficient=two")
        assertTrue("sweep" !in other.err) { other.err }
    }

    @Test
    fun `an end in orbits that has passed is told in orbits too`() {
        val settings = listOf("frame={\"type\":\"hill\",\"angularSpeed\":0.001}", "box.lengths=[40,40,20]", "until=400")
        val set = settings.flatMap { listOf("--set", it) }.toTypedArray()
        assertDone(daphnis("run", "ring-patch", *set, "--out", at("ring"), "--quiet"))
        val refused = daphnis("resume", at("ring"), "--until", "31.41592653589793")
        assertRefused(refused, "--until: is time 31.41593 s (0.005 orbits); the run is at time 4")
        assertRefused(refused, " orbits), give a later end")
    }

    @Test
    fun `a resumed run cannot end before now, and is left as it was`() {
        assertDone(small("a"))
        val summary = Files.readString(home.resolve("a/summary.json"))
        assertRefused(
            daphnis("resume", at("a"), "--until", "0.1"),
            "--until",
            "is time 0.1; the run is at time 2, give a later end",
        )
        assertRefused(daphnis("resume", at("a"), "--until", "1.9999"), "--until", "later")
        assertEquals(summary, Files.readString(home.resolve("a/summary.json")))
        assertRefused(daphnis("resume", at("a"), "--until", "NaN"), "--until", "NaN")
        // Now itself is no error, and a script that asks for the same end twice is right both times.
        assertDone(daphnis("resume", at("a"), "--until", "2", "--quiet"))
    }

    @Test
    fun `what a flag can mend is said with the flag`() {
        assertDone(small("a"))
        val instead = "exists; give another directory with --out, or --force to replace the run in it"
        assertRefused(small("a"), "${at("a")}: $instead")
        Files.createDirectories(home.resolve("b"))
        Files.writeString(home.resolve("b/notes"), "mine")
        assertRefused(small("b"), "${at("b")}: is not empty; give another directory with --out")
        val forced = daphnis("run", "cooling-gas", "--steps", "1", "--out", at("b"), "--force")
        assertRefused(forced, "is not empty and holds no run; --force replaces runs only")
        assertRefused(daphnis("describe", "cooling-gas", "--set", "until"), "daphnis: --set: until: must have the form")
        assertRefused(daphnis("analyze", at("a"), "--from", "99", "--quiet"), "daphnis: --from: is 99; the last state")
        val alone = daphnis("analyze", at("a"), "--set", "box.lengths=[1,1,1]", "--quiet")
        assertRefused(alone, "daphnis: --set: is box.lengths=[1,1,1], a key of a scenario; give it with --scenario")
        val near = daphnis("analyze", at("a"), "--cluster-ratio", "0.5", "--quiet")
        assertRefused(near, "daphnis: --cluster-ratio: is 0.5; it must be in 1..100 sums of radii")
        val series = home.resolve("a/series.csv")
        Files.writeString(series, Files.readString(series).dropLast(80))
        val mend = "; bring it back, or accept what is there: analyze --accept-loss"
        assertRefused(daphnis("analyze", at("a"), "--quiet"), "daphnis: $series: ", mend)
        for (name in listOf("checkpoint", "checkpoint.previous")) Files.delete(home.resolve("a/$name"))
        assertRefused(
            daphnis("resume", at("a")),
            "but the run has already written output; " +
                "bring one back, or run it again from its start: resume --accept-loss",
        )
        for (file in Files.list(home.resolve("a/snapshots")).toList()) Files.delete(file)
        val none = "${at("a")}: has no snapshots; run with --set output.snapshotEvery=10, for example"
        for (more in listOf(listOf("analyze"), listOf("export", "--format", "xyz"))) {
            assertRefused(daphnis(more.first(), at("a"), *more.drop(1).toTypedArray()), none)
        }
    }

    @Test
    fun `orbits need a frame, also when a time is given`() {
        assertRefused(daphnis("describe", "cooling-gas", "--set", "untilOrbits=4"), "untilOrbits", "4.0", "frame")
        Files.writeString(
            home.resolve("both.json"),
            daphnis("scenarios", "cooling-gas").out.replace("\"until\":", "\"untilOrbits\": 3, \"until\":"),
        )
        assertRefused(daphnis("describe", at("both.json")), "both.json", "untilOrbits", "3.0", "frame")
        assertRefused(
            daphnis("describe", "ring-patch", "--set", "untilOrbits=4", "--set", "until=3"),
            "untilOrbits",
            "until",
        )
        assertRefused(
            daphnis("run", "ring-patch", "--set", "untilOrbits=4", "--until", "3", "--out", at("x")),
            "untilOrbits",
            "until",
        )
    }

    @Test
    fun `orbits on the command line go before the time in the file`() {
        val time = Files.writeString(
            home.resolve("t.json"),
            daphnis("scenarios", "ring-patch").out.replace(Regex("\"untilOrbits\": *[0-9.]+"), "\"until\": 1000"),
        )
        val steps = Regex("""steps +(\d+)""")
        fun steps(vararg more: String) = steps.find(assertDone(daphnis("describe", *more)))!!.groupValues[1]
        assertEquals(steps("ring-patch", "--set", "untilOrbits=2"), steps("$time", "--set", "untilOrbits=2"))
        assertFalse(steps("$time") == steps("$time", "--set", "untilOrbits=2"))
    }

    @Test
    fun `Hill's frame takes the faces that it can have`() {
        fun hill(boundary: String, more: String = "seed=1"): CommandResult {
            val settings = listOf("boundary=$boundary", "velocities.shearProfile=false", more).flatMap {
                listOf("--set", it)
            }
            return daphnis("describe", "ring-patch", *settings.toTypedArray())
        }
        assertRefused(hill("""{"type":"periodic"}"""), "boundary.type", "is periodic", "hill-sheet", "open")
        assertRefused(
            hill("""{"type":"lees-edwards","shearRate":0.1}"""),
            "boundary.type",
            "lees-edwards",
            "hill-sheet",
        )
        assertRefused(hill("""{"type":"sheared-periodic","velocityJump":0.1}"""), "boundary.type", "sheared-periodic")
        assertRefused(hill("""{"type":"walls","axes":"z"}"""), "boundary.type", "walls", "x and z")
        assertRefused(hill("""{"type":"walls","axes":"x"}"""), "boundary.type", "walls")
        assertDone(hill("""{"type":"walls","axes":"x"}""", "frame.verticalFactor=0"))
        assertDone(hill("""{"type":"walls"}"""))
        assertDone(hill("""{"type":"open"}"""))
        assertRefused(
            daphnis("describe", "cooling-gas", "--set", """boundary={"type":"hill-sheet"}"""),
            "boundary",
            "hill-sheet",
            "frame",
        )
    }

    @Test
    fun `a scale is refused where it would do nothing`() {
        assertDone(small("a"))
        for (format in listOf("vtp", "h5md", "cartandrad")) {
            assertRefused(daphnis("export", at("a"), "--format", format, "--scale", "2"), "--scale", "xyz", format)
        }
        assertDone(daphnis("export", at("a"), "--format", "xyz", "--scale", "2"))
        assertTrue("Scale=2.0" in Files.readString(home.resolve("a/export/trajectory.xyz")))
    }

    @Test
    fun `SI units are for H5MD and for scenarios that know their own`() {
        assertDone(small("a"))
        assertRefused(
            daphnis("export", at("a"), "--format", "h5md", "--units", "si"),
            "--units",
            "units.lengthInMetres",
        )
        assertRefused(daphnis("export", at("a"), "--format", "xyz", "--units", "si"), "--units", "h5md")
        val known = arrayOf("--set", "units.lengthInMetres=0.5", "--set", "units.speedInCmPerSecond=10")
        assertDone(
            daphnis(
                "run", "cooling-gas", "--set", "particles.count=100", "--steps", "1", *known,
                "--out", at("b"), "--quiet",
            ),
        )
        assertTrue("m s-1" in assertDone(daphnis("export", at("b"), "--format", "h5md", "--units", "si")))
        val own = H5md.read(home.resolve("b/snapshots/0000000001.h5")).single()
        val si = H5md.read(home.resolve("b/export/trajectory-si.h5")).last()
        assertEquals(0.5 * own.position[1][7], si.position[1][7])
        assertEquals(0.1, si.velocity[2][7] / own.velocity[2][7], 1e-15)
        assertEquals(5.0, si.time / own.time, 1e-14)
    }

    @Test
    fun `a path is named once`() {
        val none = at("none.csv")
        assertRefused(daphnis("bench", "--compare", none, none), "daphnis: $none: cannot be read: no such file")
        Files.writeString(home.resolve("file"), "mine")
        val bench = daphnis("bench", "cooling-gas", "--steps", "1", "--out", at("file"), "--quiet")
        assertEquals("daphnis: cannot write to ${at("file")}: a file is in the way", bench.err.trim())
        val inFile = daphnis("run", "cooling-gas", "--steps", "1", "--out", at("file/run"))
        assertRefused(inFile, "daphnis: ${at("file/run")}: cannot be made: ${at("file")}: a file is in the way")
        Files.createDirectories(home.resolve("folder.xyz"))
        assertRefused(daphnis("analyze", at("folder.xyz/x.xyz")), "${at("folder.xyz/x.xyz")}: ")
    }

    @Test
    fun `no threads are no number of threads, in the same words everywhere`() {
        val words = "daphnis: --threads: is 0; it must be in 1..256; leave it out for one per core"
        val commands = listOf(
            listOf("run", "cooling-gas"),
            listOf("run", "cooling-gas", "--nodes", "2"),
            listOf("node"),
            listOf("resume", "nowhere"),
            listOf("bench", "cooling-gas"),
        )
        for (command in commands) assertRefused(daphnis(*command.toTypedArray(), "--threads", "0"), words)
        for (command in commands) {
            val many = daphnis(*command.toTypedArray(), "--threads", "257")
            assertEquals("daphnis: --threads: is 257; it must be in 1..256", many.err.trim())
        }
        // A scenario says with 0 what it means without a number.
        assertDone(daphnis("describe", "cooling-gas", "--set", "engine.threads=0"))
    }

    @Test
    fun `help is help however one asks for it`() {
        val help = assertDone(daphnis("--help"))
        assertTrue("analyze" in help && "daphnis help COMMAND" in help) { help }
        assertEquals(help, assertDone(daphnis("help")))
        assertEquals(help, assertDone(daphnis()))
        assertEquals(assertDone(daphnis("run", "--help")), assertDone(daphnis("help", "run")))
    }

    @Test
    fun `what is wrong with the command line is said on a terminal with colours too, and where to read on`() {
        val command = daphnisCommand().context { terminal = Terminal(ansiLevel = AnsiLevel.TRUECOLOR) }
        for ((words, said) in listOf(
            listOf("run", "x", "--stesp", "5") to
                "no such option --stesp. Did you mean --steps? (see daphnis run --help)",
            listOf("rnu") to "no such subcommand rnu. Did you mean run? (see daphnis --help)",
        )) {
            val e = assertThrows(UsageError::class.java) { command.parse(words) }
            assertEquals(said, command.oneLine(e, words.toTypedArray()))
        }
        val missing = listOf("run", "x", "--steps")
        val e = assertThrows(UsageError::class.java) { command.parse(missing) }
        val said = command.oneLine(e, missing.toTypedArray())
        assertTrue("--steps requires a value: end after this many steps (see daphnis run --help)" in said) { said }
    }

    @Test
    fun `a mistyped word is answered with the one that was meant`() {
        assertRefused(daphnis("rnu"), "rnu", "Did you mean run?")
        assertRefused(daphnis("help", "rnu"), "rnu", "Did you mean run?")
        assertRefused(daphnis("desribe", "moonlet"), "Did you mean describe?")
        assertRefused(daphnis("run", "--enigne", "serial"), "--enigne", "Did you mean --engine?")
        assertRefused(daphnis("run", "--sed", "2"), "Did you mean --seed?")
        assertRefused(daphnis("bench", "--step", "2"), "Did you mean --steps?")
        assertFalse("mean" in daphnis("run", "--zzzzzzzz").err)
        assertRefused(daphnis("run", "coolign-gas"), "did you mean 'cooling-gas'?")
        assertRefused(daphnis("scenarios", "moonlit"), "did you mean 'moonlet'?")
        assertRefused(daphnis("run", "cooling-gas", "--engine", "isles"), "engine.name", "did you mean 'islands'?")
        assertFalse("mean" in daphnis("quark").err)
    }
}
