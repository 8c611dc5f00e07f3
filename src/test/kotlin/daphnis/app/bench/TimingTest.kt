package daphnis.app.bench

import daphnis.core.format.FormatException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class TimingTest {
    @TempDir
    lateinit var folder: Path

    private fun timing(engine: String, threads: Int, vararg seconds: Double, scenario: String = "gas") =
        Timing(scenario, 1000, engine, threads, 10, 500, seconds.asList(), seconds.map { it / 8 }, "25.0.1")

    @Test
    fun `the fastest round and the median count`() {
        val t = timing("serial", 1, 4.0, 1.0, 3.0, 2.0)
        assertEquals(1.0, t.fastest)
        assertEquals(0.125, t.processorOfFastest)
        assertEquals(2.5, t.median)
        assertEquals(3.0, timing("serial", 1, 9.0, 3.0, 1.0).median)
        assertEquals(100.0, t.millisecondsPerStep)
        assertEquals(2000.0, t.microsecondsPerCollision)
    }

    @Test
    fun `speed is relative to serial, efficiency to the engine itself on one thread`() {
        val timings = listOf(timing("islands", 1, 2.0), timing("islands", 4, 0.8), timing("serial", 1, 1.6))
        val ranking = Ranking(timings)
        assertEquals(2.0, ranking.speed(timings[1]))
        assertEquals(0.625, ranking.efficiency(timings[1]))
        assertEquals("islands", Ranking(timings.take(2)).yardstick.engine)
        assertTrue(Ranking(listOf(timings[1])).efficiency(timings[1]).isNaN())
        // One thread goes before the order of the command line.
        assertEquals(1, Ranking(listOf(timings[1], timings[0])).yardstick.threads)
        assertTrue(timingTitle(listOf(timings[1])).endsWith("; speed relative to islands on 4 threads"))
        assertTrue(timingTitle(timings).endsWith("; speed relative to serial"))
        val rows = timingTable(timings).lines()
        assertEquals("| islands | 4 | 0.800 | 0.800 | 0.10 | 80.0 | 1600 | 2.00 | 0.63 |", rows[3])
    }

    @Test
    fun `a table of nothing that collides has no time per collision`() {
        val t = Timing("gas", 1, "serial", 1, 10, 0, listOf(1.0), listOf(Double.NaN), "")
        assertEquals("| serial | 1 | 1.00 | 1.00 |  | 100 |  | 1.00 | 1.00 |", timingTable(listOf(t)).lines()[2])
    }

    @Test
    fun `a file gives back what was written`() {
        val names = listOf("gas", "a, b", "\"quoted\", and more", "\"", "")
        val path = folder.resolve("bench.csv")
        val unknown = Timing("gas", 1000, "actors", 1, 10, 500, listOf(1.0, 2.0), listOf(Double.NaN, 0.0), "")
        val timings = names.flatMap {
            listOf(timing("serial", 1, 0.1, 1.0 / 3, scenario = it), timing("islands", 2, 7e-5, scenario = it))
        } + unknown
        TimingFile.write(path, timings)
        val read = TimingFile.read(path)
        assertEquals(timings.map { describe(it) }, read.map { describe(it) })
    }

    private fun describe(t: Timing) =
        listOf(t.scenario, t.spheres, t.engine, t.threads, t.steps, t.collisions, t.seconds, t.processorSeconds, t.java)

    @Test
    fun `a result from before there were processor times is read`() {
        val path = folder.resolve("bench.csv")
        Files.writeString(path, "$FIRST\n\"a, b\",7,serial,1,10,5,1,0.5\n")
        val t = TimingFile.read(path).single()
        assertEquals(listOf("a, b", 7, "serial", 1, 10L, 5L, listOf(0.5), listOf(Double.NaN), ""), describe(t))
    }

    @Test
    fun `a damaged file is refused with its line`() {
        val path = folder.resolve("bench.csv")
        val header = FIRST
        val full = "$FIRST,processor_seconds,java"
        Files.write(folder.resolve("bytes.csv"), byteArrayOf(0xC3.toByte(), 0x28, 10)).let {
            val e = assertThrows(FormatException::class.java) { TimingFile.read(it) }
            assertEquals("$it: cannot be read: is not UTF-8 text", e.message)
        }

        fun refused(text: String, part: String) {
            Files.writeString(path, text)
            val e = assertThrows(FormatException::class.java) { TimingFile.read(path) }
            assertTrue("$path" in e.message!! && part in e.message!!) { e.message }
        }
        refused("", "no timings")
        refused("$header\n", "has no timings")
        refused("$header\ngas,1,serial,1,10,5,1\n", "line 2: has 7 cells")
        refused("$header\ngas,1,serial,1,10,5,1,-2\n", "'-2'")
        refused("$header\ngas,1,serial,1,10,5,1,NaN\n", "'NaN'")
        refused("$header\ngas,1,serial,1,10,5,1,0.5\ngas,2,serial,1,10,5,2,0.5\n", "not of the same steps")
        refused("$full\ngas,1,serial,1,10,5,1,0.5\n", "line 2: has 8 cells")
        refused("$full\ngas,1,serial,1,10,5,1,0.5,-1,17\n", "'-1'")
        refused("$full\ngas,1,serial,1,10,5,1,0.5,NaN,17\n", "'NaN'")
        refused("$full\ngas,1,serial,1,10,5,1,0.5,,17\ngas,1,serial,1,10,5,2,0.5,,25\n", "not of the same Java")
        refused("$header\ngas,99999999999,serial,1,10,5,1,0.5\n", "'99999999999'")
        Files.delete(path)
        refused("$header\n\"gas,1,serial,1,10,5,1,0.5", "line 2")
    }

    private companion object {
        const val FIRST = "scenario,spheres,engine,threads,steps,collisions,round,seconds"
    }
}
