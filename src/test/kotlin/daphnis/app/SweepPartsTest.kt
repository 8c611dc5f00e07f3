package daphnis.app

import daphnis.core.run.RunLock
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

@Tag("jdk-neutral")
class SweepPartsTest {
    @TempDir
    lateinit var folder: Path

    private val words = arrayOf(
        "cooling-gas", "--set", "particles.count=60", "--set", "until=2", "--set", "restitution.coefficient=0.5,0.9",
        "--seeds", "1..3", "--quiet",
    )

    private fun sweep(directory: String, vararg more: String) =
        daphnis("sweep", *words, "--out", "${folder.resolve(directory)}", *more)

    private fun collect(directory: String, vararg more: String) =
        daphnis("sweep", "--collect", "--out", "${folder.resolve(directory)}", *more)

    private fun assertSameTables(a: String, b: String) {
        for (name in listOf("sweep.csv", "runs.csv", "sweep.md", "plots/end_granular_temperature.svg")) {
            assertEquals(Files.readString(folder.resolve("$a/$name")), Files.readString(folder.resolve("$b/$name"))) {
                name
            }
        }
    }

    private fun runs(directory: String) = folder.resolve("$directory/runs").toFile().list().orEmpty().toSet()

    @Test
    fun `parts make the runs of the whole, and the tables are collected to the byte`() {
        assertDone(sweep("whole"))
        for (parts in listOf(1, 4, 8)) {
            val place = "in-$parts"
            for (k in parts downTo 1) {
                assertDone(sweep(place, "--part", "$k/$parts"))
                assertFalse(Files.exists(folder.resolve("$place/sweep.csv")))
            }
            assertDone(if (parts == 4) sweep(place, "--collect") else collect(place))
            assertEquals(runs("whole"), runs(place))
            assertSameTables("whole", place)
        }
        // The whole goes on with parts, and a part with the whole.
        assertDone(sweep("in-4"))
        assertDone(sweep("whole", "--part", "2/3"))
        assertSameTables("whole", "in-4")
    }

    @Test
    fun `what is not finished is named, and the tables are of the others`() {
        assertDone(sweep("some", "--part", "2/3"))
        val said = collect("some", "--quiet")
        assertEquals(EXIT_FAILED, said.code)
        assertTrue("coefficient=0.5,seed=1: is not finished" in said.err) { said.err }
        assertTrue("4 of 6 runs are missing" in said.err) { said.err }
        assertEquals(3, Files.readAllLines(folder.resolve("some/runs.csv")).size)
        assertEquals(setOf("coefficient=0.5,seed=2", "coefficient=0.9,seed=2"), runs("some"))
        val none = sweep("none", "--part", "7/7")
        assertDone(none)
        val nothing = collect("none")
        assertTrue("coefficient=0.9,seed=3: is not finished" in nothing.err) { nothing.err }
        assertTrue(nothing.code == EXIT_FAILED && "none of the 6 runs is finished" in nothing.err) { nothing.err }
        assertTrue(
            assertDone(
                daphnis(
                    "sweep",
                    *words.dropLast(1).toTypedArray(),
                    "--part",
                    "7/7",
                    "--out",
                    "${folder.resolve("none")}",
                ),
            ).contains("part 7 of 7: 0 of 0 runs"),
        )
    }

    @Test
    fun `the commands of a list make runs that are collected, whatever characters they have`() {
        val own = arrayOf(
            "cooling-gas", "--set", "particles.count=60", "--set", "until=2", "--set",
            """restitution={"type":"constant","coefficient":0.5},{"type":"constant","coefficient":0.7}""",
            "--set", "name=it's", "--seeds", "4,5", "--engine", "serial",
        )
        val place = "${folder.resolve("a b")}"
        val list = assertDone(daphnis("sweep", *own, "--out", place, "--list"))
        assertFalse(Files.exists(folder.resolve("a b")))
        val lines = list.trim().lines().map { it.split(' ', limit = 3) }
        assertEquals(listOf("1", "2", "3", "4"), lines.map { it[0] })
        for (line in lines) assertDone(daphnis(*words(line[2]).drop(1).toTypedArray(), "--quiet"))
        // Whoever makes runs by hand has to say what they belong to.
        val lost = collect("a b")
        assertTrue(lost.code == 2 && "holds no sweep" in lost.err) { lost.err }
        assertDone(daphnis("sweep", *own, "--out", place, "--collect", "--quiet"))
        assertDone(daphnis("sweep", *own, "--out", "${folder.resolve("whole")}", "--quiet"))
        assertEquals(lines.map { it[1] }.toSet(), runs("whole"))
        for (name in listOf("sweep.csv", "runs.csv", "sweep.md")) {
            assertEquals(Files.readString(folder.resolve("a b/$name")), Files.readString(folder.resolve("whole/$name")))
        }
    }

    /** As a shell takes [command] apart. */
    private fun words(command: String): List<String> {
        val shell = ProcessBuilder("sh", "-c", "for w in $command; do printf '%s\\0' \"\$w\"; done").start()
        return String(shell.inputStream.readAllBytes()).split('\u0000').dropLast(1)
    }

    @Test
    fun `a run that another process makes is said, and the rest of the part is done`() {
        val taken = Files.createDirectories(folder.resolve("a/runs/coefficient=0.5,seed=1"))
        Files.delete(taken)
        Files.delete(taken.parent)
        assertDone(sweep("a", "--part", "5/6"))
        Files.createDirectories(taken)
        val said = RunLock.take(taken).use {
            daphnis("sweep", *words.dropLast(1).toTypedArray(), "--out", "${folder.resolve("a")}", "--part", "1/2")
        }
        assertEquals(EXIT_FAILED, said.code)
        assertTrue("coefficient=0.5,seed=1: " in said.err && "is running in this directory; wait" in said.err) {
            said.err
        }
        assertTrue("coefficient=0.5,seed=1: busy; " in said.err && "1 busy\n" in said.err) { said.err }
        assertFalse(" failed" in said.err) { said.err }
        assertTrue("1 of 3 runs busy, the same command tries them again" in said.err) { said.err }
        val early = collect("a").err
        assertTrue("seed=1: is not finished; the last try failed: " in early && "is running in" in early) { early }
        assertTrue("coefficient=0.5,seed=2: is not finished\n" in early) { early }
        assertDone(sweep("a", "--part", "1/2"))
        assertEquals(0, folder.resolve("a/failures").toFile().list()!!.size)
        assertDone(sweep("a", "--part", "2/2"))
        assertDone(collect("a", "--quiet"))
        // Where no note can be made, there is none.
        Files.delete(folder.resolve("a/failures"))
        Files.writeString(folder.resolve("a/failures"), "mine")
        assertDone(sweep("a", "--part", "1/2"))
    }

    @Test
    fun `what does not go together is refused in one line, and nothing is written`() {
        val other = folder.resolve("other").also { Files.createDirectories(it) }
        Files.writeString(other.resolve("notes.txt"), "mine")
        assertDone(sweep("old", "--part", "1/6"))
        for ((said, why) in listOf(
            sweep("new", "--nodes", "2") to
                "--nodes, --cluster: are of one run; processes share a sweep out with --part",
            sweep("new", "--part", "0/3") to "parts are numbered from 1 to 3",
            sweep("new", "--part", "auto") to "no job of an array",
            sweep("new", "--part", "1/3", "--collect") to "--part: is given together with --collect; each is for a",
            sweep("new", "--list", "--collect") to "--collect: is given together with --list; each is for a",
            sweep("new", "--collect") to "holds no sweep",
            collect("new") to "holds no sweep",
            daphnis("sweep") to "scenario: is missing",
            sweep("new", "--set", "name=a\nb", "--list") to "is no text of one line",
            daphnis("sweep", "--collect") to "--out: is missing",
            collect("old", "--seeds", "1..3") to "to which --set and --seeds belong",
            sweep("other", "--part", "1/3") to "is not empty and holds no sweep",
            daphnis(
                "sweep",
                *words.dropLast(2).toTypedArray(),
                "1..4",
                "--part",
                "1/2",
                "--out",
                "${folder.resolve("old")}",
            ) to
                "--seeds was 1..3 and is 1..4",
        )) {
            assertTrue(said.code == 2 && why in said.err && said.err.trim().lines().size == 1) {
                "${said.code}: ${said.err}"
            }
        }
        assertFalse(Files.exists(folder.resolve("new")))
        assertEquals(1, runs("old").size)
    }
}
