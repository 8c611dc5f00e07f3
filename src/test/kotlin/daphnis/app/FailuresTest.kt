package daphnis.app

import daphnis.app.printing.noticeInFlags
import daphnis.core.boundary.Open
import daphnis.core.format.H5md
import daphnis.core.format.Snapshot
import daphnis.core.input.InputException
import daphnis.core.run.RunException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.AccessDeniedException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.LinkOption
import java.nio.file.Path

/** Whatever goes wrong is one line and an exit code. */
class FailuresTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name).toString()

    private fun small(name: String, vararg more: String) =
        daphnis("run", "cooling-gas", *SMALL, "--out", at(name), "--quiet", *more)

    private fun said(e: Throwable): Pair<Int, String> {
        val old = System.err
        val err = ByteArrayOutputStream()
        System.setErr(PrintStream(err, true))
        try {
            return complain(e) to err.toString()
        } finally {
            System.setErr(old)
        }
    }

    @Test
    fun `every kind of failure is one line with its exit code`() {
        val cases = listOf(
            Triple(InputException("a\nb", "key", "is wrong"), 2, "a\\nb: key: is wrong"),
            Triple(RunException("step 3: failed"), 1, "step 3: failed"),
            Triple(InvalidPathException("x\u0000y", "Nul character not allowed"), 2, "x\\u0000y"),
            Triple(AccessDeniedException("/etc/a"), 1, "/etc/a: permission denied"),
            Triple(IOException("No space left on device"), 1, "No space left on device"),
            Triple(OutOfMemoryError("heap"), 1, "JAVA_OPTS=-Xmx"),
            Triple(StackOverflowError(), 1, "stack"),
            Triple(NoClassDefFoundError("java/awt/Font"), 1, "java/awt/Font"),
            Triple(
                NoClassDefFoundError("x").initCause(ClassNotFoundException("org.apache.pekko.actor.typed.ActorSystem")),
                1,
                "has no Pekko, which nodes and the engine pekko need",
            ),
            Triple(ExceptionInInitializerError(IllegalStateException("no fonts")), 1, "no fonts"),
            Triple(
                IllegalStateException("first\nsecond"),
                1,
                "IllegalStateException: first\\nsecond; this is a fault of daphnis, --debug",
            ),
            Triple(NullPointerException(), 1, "NullPointerException"),
        )
        for ((e, code, part) in cases) {
            val (exit, err) = said(e)
            assertEquals(code, exit) { err }
            assertTrue(part in err && err.startsWith("daphnis: ") && err.trim().lines().size == 1) { err }
        }
    }

    @Tag("thorough")
    @Test
    fun `a stack trace is shown when it is asked for, wherever the word stands`() {
        for (words in listOf(listOf("resume", at("x"), "--debug"), listOf("--debug", "resume", at("x")))) {
            val result = daphnis(*words.toTypedArray())
            assertEquals(2, result.code)
            assertTrue(
                "\tat daphnis" in result.err && "no such file or directory" in result.err.trim().lines().last(),
            ) {
                result.err
            }
        }
        assertRefused(daphnis("resume", at("x")), "no such file or directory")
        assertTrue("--debug" in assertDone(daphnis("--help")))
    }

    @Test
    fun `an empty name is refused, since it would mean the working directory`() {
        assertRefused(daphnis("run", "cooling-gas", "--out", ""), "--out", "empty")
        for (command in listOf("resume", "analyze")) assertRefused(daphnis(command, ""), "empty")
        assertRefused(daphnis("compare", "", at("x")), "empty")
        assertRefused(daphnis("export", "", "--format", "xyz"), "empty")
        assertRefused(daphnis("describe", ""), "empty")
        assertRefused(daphnis("run", ""), "empty")
    }

    @Test
    fun `damaged summaries and impacts are one line with the file`() {
        small("a")
        val checkpoints = listOf("checkpoint", "checkpoint.previous").map { home.resolve("a").resolve(it) }
        Files.writeString(home.resolve("a/impacts.csv"), "speed_from,speed_to,collisions\n1,2\n")
        assertRefused(daphnis("analyze", at("a"), "--quiet"), "impacts.csv", "--accept-loss")
        assertRefused(daphnis("analyze", at("a"), "--quiet", "--accept-loss"), "impacts.csv:2", "1,2")
        for (file in checkpoints) Files.delete(file)
        assertRefused(daphnis("analyze", at("a"), "--quiet"), "impacts.csv:2", "1,2")
        for (text in listOf("", "{", "null", "[]", "{\"stateDigest\": 3}", "\u0000")) {
            Files.writeString(home.resolve("a/summary.json"), text)
            assertRefused(daphnis("compare", at("a"), at("a")), "summary.json")
            assertRefused(daphnis("analyze", at("a"), "--quiet"), "summary.json")
        }
        Files.write(home.resolve("a/summary.json"), byteArrayOf(-1, -2))
        assertRefused(daphnis("compare", at("a"), at("a")), "summary.json", "UTF-8")
    }

    @Test
    fun `a plot that cannot be drawn is a line, and the run is done all the same`() {
        small("a")
        home.resolve("a/plots").toFile().deleteRecursively()
        Files.writeString(home.resolve("a/plots"), "in the way")
        val result = daphnis("resume", at("a"), "--until", "1.5", "--quiet")
        assertEquals(0, result.code) { result.err }
        assertTrue("no plot" in result.err && "complete" in result.err && result.err.trim().lines().size == 1) {
            result.err
        }
        val small = noPlot(OutOfMemoryError("Java heap space"))
        assertTrue("not enough memory (the JVM has" in small && "-Xmx" in small && "heap space" !in small) { small }
    }

    @Test
    fun `a file without times is told the flag that gives them`() {
        val frame = "2\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3:velo:R:3:radius:R:1\n" +
            "A 1 1 1 1 0 0 0.5\nA 4 4 4 0 1 0 0.5\n"
        val file = home.resolve("states.xyz")
        Files.writeString(file, frame + frame.replace("A 1 1 1", "A 2 1 1"))
        val result = daphnis("analyze", file.toString(), "--quiet")
        assertEquals(0, result.code) { result.err }
        assertTrue("no times" in result.err && "; give --time-step DT\n" in result.err) { result.err }
        assertEquals("the rate is 1; give --scenario", noticeInFlags("the rate is 1; give its scenario"))
        assertEquals("give its scenario, or not", noticeInFlags("give its scenario, or not"))
    }

    @Test
    fun `an option without a value is told what it is for`() {
        val result = daphnis("run", "cooling-gas", "--set")
        assertTrue(": replace any key of the scenario" in result.err) { result.err }
    }

    @Test
    fun `compare looks at masses too`() {
        small("a", "--set", "output.snapshotEvery=1")
        small("b", "--set", "output.snapshotEvery=1", "--set", "particles.mass=1.5")
        val result = daphnis("compare", at("a"), at("b"))
        assertEquals(1, result.code)
        assertTrue("differ at step 0: particle 0, mass =" in result.out) { result.out }
    }

    @Test
    fun `compare says of runs that ended at different steps which did where`() {
        small("a", "--set", "output.snapshotEvery=4")
        daphnis(
            "run", "cooling-gas", *SMALL, "--set", "output.snapshotEvery=4", "--steps", "12", "--out", at("b"),
            "--quiet",
        )
        val result = daphnis("compare", at("a"), at("b"))
        assertEquals(1, result.code) { result.err }
        val line = "differ: one ended after step 8, the other after step 12; 3 common snapshots are identical"
        assertEquals(line, result.out.trim())
        val reverse = daphnis("compare", at("b"), at("a")).out
        assertTrue("differ: one ended after step 12, the other after step 8" in reverse) { reverse }
    }

    @Tag("thorough")
    @Test
    fun `a damaged snapshot is named with the way out, which works`() {
        small("a", "--set", "output.snapshotEvery=4")
        small("b", "--set", "output.snapshotEvery=4")
        val damaged = home.resolve("a/snapshots/0000000004.h5")
        val bytes = Files.readAllBytes(damaged)
        Files.write(damaged, bytes.copyOf(bytes.size / 2))
        val out = arrayOf("0000000004.h5", "remove the file to continue without this snapshot")
        assertRefused(daphnis("compare", at("a"), at("b")), *out)
        assertRefused(daphnis("analyze", at("a"), "--from", "0", "--quiet"), *out)
        assertRefused(daphnis("export", at("a"), "--format", "xyz"), *out)
        Files.delete(damaged)
        assertTrue("identical: 2 common snapshots" in assertDone(daphnis("compare", at("a"), at("b"))))
        assertDone(daphnis("analyze", at("a"), "--from", "0", "--quiet"))
        assertTrue("2 snapshots to" in assertDone(daphnis("export", at("a"), "--format", "xyz")))
    }

    @Test
    fun `a directory that cannot be made or written is named, with exit code 1`() {
        small("a", "--set", "output.snapshotEvery=4")
        val file = Files.writeString(home.resolve("file"), "in the way").toString()
        for (command in listOf(arrayOf("analyze", at("a"), "--quiet"), arrayOf("export", at("a"), "--format", "vtp"))) {
            for (target in listOf(file, "$file/below")) {
                val result = daphnis(*command, "--out", target)
                assertEquals(1, result.code) { result.err }
                val isOneLine = result.err.trim().lines().size == 1
                assertTrue("cannot write to $target: " in result.err && isOneLine) { result.err }
            }
        }
        // A device that is full as soon as something is written.
        val full = Path.of("/dev/full")
        if (!Files.exists(full)) return
        val out = Files.createDirectories(home.resolve("out"))
        Files.createSymbolicLink(out.resolve("trajectory.xyz"), full)
        val result = daphnis("export", at("a"), "--format", "xyz", "--out", "$out")
        assertEquals(1, result.code) { result.err }
        assertTrue("cannot write to $out: " in result.err && "No space left" in result.err) { result.err }
        // A report takes the place of a link, and never follows it.
        Files.createSymbolicLink(out.resolve("report.html"), full)
        assertDone(daphnis("analyze", at("a"), "--quiet", "--out", "$out"))
        assertTrue(Files.isRegularFile(out.resolve("report.html"), LinkOption.NOFOLLOW_LINKS))
    }

    @Test
    fun `H5MD refuses other particles in one state than in another, and names what does not`() {
        small("a", "--set", "output.snapshotEvery=4")
        val file = home.resolve("a/snapshots/0000000008.h5")
        val state = H5md.read(file).single()
        fun but(a: DoubleArray) = a.copyOf(99)
        val fewer = Snapshot(
            8, state.time, state.lengths, state.periodic, 0.0, state.id.copyOf(99),
            Array(3) { but(state.position[it]) }, Array(3) { but(state.velocity[it]) },
            but(state.radius), but(state.mass),
        )
        H5md.write(listOf(fewer), file, "test")
        // They would say that this is a state of another run.
        for (name in listOf("checkpoint", "checkpoint.previous")) Files.deleteIfExists(home.resolve("a/$name"))
        assertRefused(
            daphnis("export", at("a"), "--format", "h5md"),
            "--format: is h5md, which needs the same particles in every state; those of steps 0 and 8 differ; " +
                "xyz, vtp and lammps do not",
        )
        assertDone(daphnis("export", at("a"), "--format", "xyz"))
    }

    private fun state(change: Int = -1): Snapshot {
        fun next(k: Int, value: Double) = if (k == change) Math.nextUp(value) else value
        fun columns(k: Int) = Array(3) { axis -> doubleArrayOf(1.0, if (axis == 2) next(k, 2.0) else 2.0) }
        return Snapshot(
            if (change == 0) 4 else 3,
            next(1, 1.5),
            doubleArrayOf(9.0, 9.0, next(2, 9.0)),
            BooleanArray(3) { it < 2 || change == 3 },
            next(4, 0.5),
            intArrayOf(0, if (change == 5) 2 else 1),
            columns(6),
            columns(7),
            doubleArrayOf(1.0, next(8, 1.0)),
            doubleArrayOf(1.0, next(9, 1.0)),
            if (change == 10) 2 else 1,
            image = if (change == 11) null else Array(3) { IntArray(2) { k -> if (change == 12) k else 0 } },
        )
    }

    @Test
    fun `two states differ in whatever they differ`() {
        assertNull(firstDifference(state(), state()))
        val words = "step 3;time;box along z;repeats along z;offset;particles;particle 1, z;particle 1, vz;" +
            "radius;mass;axes;crossed"
        for ((change, word) in words.split(';').withIndex()) {
            val said = firstDifference(state(), state(change)).orEmpty()
            assertTrue(word in said) { "$word: $said" }
        }
        assertTrue("boxes crossed along x = 0 against 1" in firstDifference(state(), state(12)).orEmpty())
    }

    @Test
    fun `two states differ in a spin, or in that there is any`() {
        val p = state().population()
        fun spun(w: Double) =
            Snapshot.of(p.withSpin(DoubleArray(2), DoubleArray(2) { w }, DoubleArray(2)), Open, 3, 1.5)
        val smooth = Snapshot.of(p, Open, 3, 1.5)
        assertNull(firstDifference(spun(1.0), spun(1.0)))
        assertEquals("particle 0, omegay = 1.0 against 2.0", firstDifference(spun(1.0), spun(2.0)))
        for ((a, b) in listOf(spun(1.0) to smooth, smooth to spun(1.0))) {
            assertTrue("angular velocities" in firstDifference(a, b).orEmpty())
        }
    }

    private class Failing(private val message: String) : OutputStream() {
        var written = 0

        override fun write(byte: Int) {
            if (++written > 3) throw IOException(message)
        }
    }

    @Test
    fun `a full device is remembered, a reader that has gone is not missed, and neither stops the work`() {
        for ((message, problem) in listOf(
            "No space left on device" to "No space left on device",
            "Broken pipe" to null,
        )) {
            val target = Failing(message)
            val output = StandardOutput(target)
            PrintStream(output, true).use { for (k in 0..9) it.println("line $k") }
            assertEquals(problem, output.problem)
            assertEquals(4, target.written) { "after the first failure nothing is tried" }
        }
        assertNull(StandardOutput(ByteArrayOutputStream()).also { PrintStream(it, true).println("fine") }.problem)
    }

    private companion object {
        val SMALL = arrayOf("--set", "particles.count=100", "--steps", "8", "--set", "output.transportEvery=1")
    }
}
