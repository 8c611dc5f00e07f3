package daphnis.app

import daphnis.app.bench.TimingFile
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

@Tag("jdk-neutral")
class BenchCommandTest {
    @TempDir
    lateinit var folder: Path

    private val out get() = "${folder.resolve("out")}"

    private fun bench(vararg words: String) = daphnis("bench", *words)

    /** [words] for timing without more than a turn to warm up. */
    private fun cold(vararg words: String) = bench(*words, "--warm-up", "0")

    @Test
    fun `engines take turns, and leave a table, timings and plots`() {
        val said = assertDone(
            cold(
                "cooling-gas", "--steps", "3", "--rounds", "2", "--threads", "1,2", "--engines", "serial,thread-pool",
                "--out", out, "--quiet",
            ),
        )
        assertTrue("cooling-gas: 2000 spheres, 3 steps" in said) { said }
        val timings = TimingFile.read(folder.resolve("out/bench.csv"))
        assertEquals(
            listOf("serial" to 1, "thread-pool" to 1, "thread-pool" to 2),
            timings.map { it.engine to it.threads },
        )
        assertTrue(timings.all { it.seconds.size == 2 && it.steps == 3L && it.collisions > 0 })
        assertTrue(timings.all { t -> t.processorSeconds.size == 2 && t.processorSeconds.all { it >= 0 } })
        assertEquals(setOf(System.getProperty("java.version")), timings.map { it.java }.toSet())
        assertTrue("| thread-pool | 2 |" in Files.readString(folder.resolve("out/bench.md")))
        for (kind in listOf("time", "speed", "efficiency")) {
            assertTrue(Files.size(folder.resolve("out/cooling-gas-$kind.png")) > 1000)
            val svg = Files.readString(folder.resolve("out/cooling-gas-$kind.svg"))
            assertTrue("<svg" in svg) { kind }
            // Timed on one thread alone, it has a speed, and no efficiency against itself.
            val words = svg.replace(Regex("\\s"), "")
            assertEquals(kind != "efficiency", ">serial<" in words) { kind }
            // The one curve that is left has its name there too, and the dashed line is named in all three.
            assertTrue(">thread-pool<" in words) { kind }
            val dashed = if (kind == "efficiency") "nthreadsntimesasfastasone" else "serial"
            assertTrue(">greydashes:$dashed<" in words) { kind }
        }
        // No plots of an earlier result beside the tables of the next.
        val alone = arrayOf("cooling-gas", "--steps", "2", "--rounds", "1", "--engines", "serial", "--out", out)
        val last = assertDone(cold(*alone)).trim().lines().last()
        assertEquals("tables are in $out", last)
        assertEquals(setOf("bench.csv", "bench.md"), folder.resolve("out").toFile().list()!!.toSet())
    }

    @Test
    fun `a whole scenario ends where a run of it does`() {
        val set = arrayOf("--set", "until=0.55")
        assertDone(cold("elastic-gas", *set, "--rounds", "1", "--engines", "serial", "--out", out, "--quiet"))
        assertDone(daphnis("run", "elastic-gas", *set, "--out", "${folder.resolve("run")}", "--quiet"))
        val summary = Files.readString(folder.resolve("run/summary.json"))
        val timing = TimingFile.read(folder.resolve("out/bench.csv")).single()
        assertTrue("\"steps\": ${timing.steps}," in summary && "\"collisions\": ${timing.collisions}," in summary)
    }

    @Test
    fun `two results are compared, and slower ones change the exit code`() {
        fun file(name: String, scenario: String, vararg seconds: Double): Path {
            val rows = seconds.withIndex().joinToString("") { (k, s) -> "$scenario,1,serial,1,10,5,${k + 1},$s\n" }
            val header = "scenario,spheres,engine,threads,steps,collisions,round,seconds\n"
            return Files.writeString(folder.resolve(name), header + rows)
        }
        val old = file("old.csv", "gas", 1.0, 1.01, 1.02)
        val new = file("new.csv", "gas", 1.5, 1.52, 1.54)
        assertEquals("nothing became slower", assertDone(bench("--compare", "$old", "$old")).trim().lines().last())
        val slower = bench("--compare", "$old", "$new")
        assertEquals(1, slower.code)
        val row = "| gas | serial | 1 | 3, 3 | 1.01 | 1.52 | 1.50 | 1.47 to 1.54 | slower |"
        assertTrue(row in slower.out && "1 became slower" in slower.out) { slower.out }
        val unknown = assertDone(bench("--compare", "$old", "${file("one.csv", "gas", 1.5)}"))
        assertTrue("| 3, 1 | 1.01 | 1.50 | 1.49 |  | cannot tell |" in unknown) { unknown }
        assertTrue("nothing can be told; more --rounds" in unknown) { unknown }
        val known = (1..3).joinToString("") { "gas,1,serial,2,10,5,$it,2.0\n" }
        val oldToo = Files.writeString(folder.resolve("old-too.csv"), Files.readString(old) + known)
        val newToo = Files.writeString(
            folder.resolve("new-too.csv"),
            Files.readString(folder.resolve("one.csv")) + known,
        )
        val halfKnown = assertDone(bench("--compare", "$oldToo", "$newToo"))
        assertTrue("nothing is seen to have become slower; 1 cannot be told" in halfKnown) { halfKnown }
        val other = file("other.csv", "ring", 1.5)
        val nothing = bench("--compare", "$old", "$other")
        assertRefused(nothing, "$other", "in common")
        assertFalse("there" in nothing.err) { nothing.err }
        val longer = Files.writeString(folder.resolve("longer.csv"), Files.readString(new).replace(",10,5,", ",20,9,"))
        val said = "serial on 1 of gas was 1 sphere, 10 steps, 5 collisions there, 1 sphere, 20 steps, 9 collisions"
        assertRefused(bench("--compare", "$old", "$longer"), "in common", said)
    }

    @Test
    fun `a comparison with another Java says so`() {
        fun file(java: String) = Files.writeString(
            folder.resolve("$java.csv"),
            "scenario,spheres,engine,threads,steps,collisions,round,seconds,processor_seconds,java\n" +
                (1..3).joinToString("") { "gas,1,serial,1,10,5,$it,1.0,1.5,$java\n" },
        )
        val (old, new) = listOf("17.0.15", "25").map(::file)
        val said = "the first was timed with Java 17.0.15, the second with Java 25"
        assertTrue(said in assertDone(bench("--compare", "$old", "$new")).lines())
        assertFalse("timed with" in assertDone(bench("--compare", "$old", "$old")))
    }

    @Test
    fun `a comparison times nothing, and refuses what is for timing`() {
        for ((option, value) in listOf(
            "--engines" to "serial",
            "--threads" to "1",
            "--steps" to "3",
            "--rounds" to "3",
            "--warm-up" to "3",
            "--set" to "until=1",
            "--out" to "x",
        )) {
            assertRefused(
                bench("--compare", "a", "b", option, value),
                "daphnis: $option: has no meaning with --compare",
            )
        }
    }

    @Test
    fun `before anything is timed it is said what, and then how long it takes`() {
        val words = arrayOf("cooling-gas", "--steps", "2", "--rounds", "2", "--out", out)
        val said = cold(*words, "--engines", "serial,horizon", "--threads", "2").err.lines()
        assertEquals("daphnis: serial works on one thread, whatever --threads says", said[0])
        assertEquals("daphnis: cooling-gas: 2000 spheres, 2 steps", said[1])
        assertEquals("daphnis: engines: serial on 1 thread; horizon on 2 threads", said[2])
        assertTrue("1 x 2 x 2" in said[3]) { said[3] }
        assertTrue(said[4].startsWith("daphnis: warming up: serial on 1: ")) { said[4] }
        assertTrue(Regex("daphnis: about \\d+ s left").matches(said[6])) { said[6] }
        assertEquals("", cold(*words, "--engines", "serial,horizon", "--threads", "1", "--quiet").err)
    }

    @Test
    fun `each engine works for as long as asked before rounds count`() {
        val words = arrayOf("cooling-gas", "--steps", "1", "--rounds", "1", "--threads", "1", "--out", out)
        val said = bench(*words, "--engines", "serial,horizon", "--warm-up", "0.3").err.lines()
        val warm = said.filter { "warming up: " in it }.associate {
            val found = Regex("daphnis: warming up: (\\S+) on 1: (\\d+) turns, the first .* s, the last .* s").find(it)
            found!!.groupValues[1] to found.groupValues[2].toInt()
        }
        // A step takes milliseconds.
        assertEquals(setOf("serial", "horizon"), warm.keys)
        assertTrue(warm.values.all { it > 3 }) { "$warm" }
        assertTrue("0.3 s of turns, one at least, for each to warm up" in said[2]) { said[2] }
        assertEquals(1, TimingFile.read(folder.resolve("out/bench.csv")).first().seconds.size)
    }

    @Test
    fun `without one thread there is no ideal, and speed says what it is relative to`() {
        fun speeds(threads: String): String {
            val words = arrayOf("--steps", "2", "--rounds", "1", "--engines", "horizon", "--out", out, "--quiet")
            assertDone(cold("cooling-gas", *words, "--threads", threads))
            return Files.readString(folder.resolve("out/cooling-gas-speed.svg")).replace(Regex("\\s+"), " ")
        }
        val without = speeds("2,3")
        assertTrue("speed relative to" in without && "horizon on 2 threads" in without) { without }
        assertFalse("ideal" in without)
        assertTrue("ideal" in speeds("3,1"))
    }

    @Tag("thorough")
    @Test
    fun `the paper's systems as they are stand beside its authors' program`() {
        fun words(vararg more: String) = arrayOf(
            "paper-figure-3", "--engines", "serial", "--rounds", "1", "--out", out, "--quiet", *more,
        )
        val table = folder.resolve("out/paper-table-1.md")
        assertTrue("| paper-figure-3 | serial | " in assertDone(cold(*words())))
        assertTrue("| 20.2 |" in Files.readString(table))
        // Neither other steps nor other spheres are what the authors timed.
        assertFalse("authors" in assertDone(cold(*words("--steps", "1"))))
        assertFalse(Files.exists(table))
        assertFalse("authors" in assertDone(cold(*words("--set", "until=0.3"))))
    }

    @Test
    fun `what is wrong is told in one line`() {
        assertRefused(bench("cooling-gas", "--rounds", "0"), "--rounds", "is 0")
        assertRefused(bench("cooling-gas", "--steps", "0"), "--steps", "is 0")
        for (bad in listOf("-1", "NaN", "3601", "Infinity")) {
            assertRefused(bench("cooling-gas", "--warm-up", bad), "--warm-up", "0 or more seconds, 3600 at most")
        }
        assertRefused(bench("cooling-gas", "--threads", "1,x"), "--threads", "'x'")
        assertRefused(bench("cooling-gas", "--threads", "0"), "--threads", "is 0")
        assertRefused(bench("cooling-gas", "--engines", "seriel"), "--engines", "'seriel'", "serial")
        assertRefused(bench("no-such"), "no-such")
        assertRefused(bench("--compare", "a"), "--compare", "two results")
        assertRefused(bench("--compare", "$folder", "$folder"), "bench.csv", "cannot be read")
        Files.writeString(folder.resolve("mine"), "")
        assertRefused(bench("cooling-gas", "--steps", "1", "--out", "$folder"), "--out", "not empty")
    }
}
