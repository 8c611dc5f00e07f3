package daphnis.app

import daphnis.app.bench.TimingFile
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class BenchCommandTest {
    @TempDir
    lateinit var folder: Path

    private val out get() = "${folder.resolve("out")}"

    private fun bench(vararg words: String) = daphnis("bench", *words)

    @Test
    fun `engines take turns, and leave a table, timings and plots`() {
        val said = assertDone(
            bench(
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
        assertTrue("| thread-pool | 2 |" in Files.readString(folder.resolve("out/bench.md")))
        for (kind in listOf("time", "speed", "efficiency")) {
            assertTrue(Files.size(folder.resolve("out/cooling-gas-$kind.png")) > 1000)
            val svg = Files.readString(folder.resolve("out/cooling-gas-$kind.svg"))
            assertTrue("<svg" in svg) { kind }
            // Timed on one thread alone, it has a speed, and no efficiency against itself.
            assertEquals(kind != "efficiency", ">serial<" in svg.replace(Regex("\\s"), "")) { kind }
        }
        // No plots of an earlier result beside the tables of the next.
        val alone = arrayOf("cooling-gas", "--steps", "2", "--rounds", "1", "--engines", "serial", "--out", out)
        val last = assertDone(bench(*alone)).trim().lines().last()
        assertEquals("tables are in $out", last)
        assertEquals(setOf("bench.csv", "bench.md"), folder.resolve("out").toFile().list()!!.toSet())
    }

    @Test
    fun `a whole scenario ends where a run of it does`() {
        val set = arrayOf("--set", "until=0.55")
        assertDone(bench("elastic-gas", *set, "--rounds", "1", "--engines", "serial", "--out", out, "--quiet"))
        assertDone(daphnis("run", "elastic-gas", *set, "--out", "${folder.resolve("run")}", "--quiet"))
        val summary = Files.readString(folder.resolve("run/summary.json"))
        val timing = TimingFile.read(folder.resolve("out/bench.csv")).single()
        assertTrue("\"steps\": ${timing.steps}," in summary && "\"collisions\": ${timing.collisions}," in summary)
    }

    @Test
    fun `two results are compared, and slower ones change the exit code`() {
        val header = "scenario,spheres,engine,threads,steps,collisions,round,seconds\n"
        val old = Files.writeString(folder.resolve("old.csv"), header + "gas,1,serial,1,10,5,1,1.0\n")
        val new = Files.writeString(folder.resolve("new.csv"), header + "gas,1,serial,1,10,5,1,1.5\n")
        assertTrue("nothing became slower" in assertDone(bench("--compare", "$old", "$old")))
        val slower = bench("--compare", "$old", "$new")
        assertEquals(1, slower.code)
        assertTrue("| gas | serial | 1 | 1.00 | 1.50 | 1.50 | slower |" in slower.out) { slower.out }
        val other = Files.writeString(folder.resolve("other.csv"), header + "ring,1,serial,1,10,5,1,1.5\n")
        assertRefused(bench("--compare", "$old", "$other"), "$other", "in common")
    }

    @Test
    fun `what is wrong is told in one line`() {
        assertRefused(bench("cooling-gas", "--rounds", "0"), "--rounds", "is 0")
        assertRefused(bench("cooling-gas", "--steps", "0"), "--steps", "is 0")
        assertRefused(bench("cooling-gas", "--threads", "1,x"), "--threads", "'x'")
        assertRefused(bench("cooling-gas", "--threads", "0"), "--threads", "'0'")
        assertRefused(bench("cooling-gas", "--engines", "seriel"), "--engines", "'seriel'", "serial")
        assertRefused(bench("no-such"), "no-such")
        assertRefused(bench("--compare", "a"), "--compare", "two results")
        assertRefused(bench("--compare", "$folder", "$folder"), "bench.csv", "cannot be read")
        Files.writeString(folder.resolve("mine"), "")
        assertRefused(bench("cooling-gas", "--steps", "1", "--out", "$folder"), "--out", "not empty")
    }
}
