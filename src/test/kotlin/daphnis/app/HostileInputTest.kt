package daphnis.app

import io.jhdf.HdfFile
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.util.concurrent.TimeUnit
import javax.xml.parsers.DocumentBuilderFactory

/**
 * Words of the command line that no file can have as its name, and hostile files at each of the doors that files come
 * in by.
 */
class HostileInputTest {
    @TempDir
    lateinit var home: Path

    @Test
    fun `a NUL in a path is one line, whatever the path is for`() {
        val nul = "a\u0000b"
        assertRefused(daphnis("run", nul), "a\\u0000b", "NUL")
        assertRefused(daphnis("describe", nul), "a\\u0000b", "NUL")
        assertRefused(daphnis("run", "elastic-gas", "--steps", "1", "--out", nul), "--out", "a\\u0000b", "NUL")
        assertRefused(daphnis("resume", nul), "a\\u0000b", "NUL")
        assertRefused(daphnis("compare", nul, nul), "a\\u0000b", "NUL")
        assertRefused(daphnis("export", nul, "--format", "xyz"), "a\\u0000b", "NUL")
        assertRefused(daphnis("analyze", nul), "a\\u0000b", "NUL")
        val scenario = """{ "box": { "lengths": [10, 10, 10] }, "boundary": { "type": "periodic" },
            "placement": { "type": "file", "path": "a\u0000b.h5" },
            "restitution": { "type": "constant", "coefficient": 1 }, "timeStep": { "type": "fixed", "dt": 0.1 },
            "until": 0.1 }"""
        val file = Files.writeString(home.resolve("nul.json"), scenario)
        assertRefused(daphnis("describe", "$file"), "placement.path", "a\\u0000b.h5", "NUL")
    }

    /** What [result] printed, which holds nothing that a terminal obeys but line ends. */
    private fun plain(result: CommandResult): CommandResult {
        val obeyed = Regex("[\\p{Cc}\\p{Cf}\\p{Zl}\\p{Zp}&&[^\n]]")
        for (text in listOf(result.out, result.err)) {
            assertTrue(obeyed.find(text) == null) { "${obeyed.find(text)?.value?.map { it.code }} in: $text" }
            // A line that is forged begins with what only the program says.
            assertTrue(text.lines().none { it.startsWith("FORGED") }) { text }
        }
        return result
    }

    @Test
    fun `what a terminal obeys is written out wherever a name, a description or a path of others is printed`() {
        val evil = "x\u001b]0;pwn\u0007\u001b[2J\nFORGED\r\u007f\u009b5m\u2028FORGED\u2029\u202e\u2066\u200f"
        val json = evil.map { "\\u%04x".format(it.code) }.joinToString("")
        val text = """{ "name": "$json", "description": "d$json", "box": { "lengths": [10, 10, 10] },
            "boundary": { "type": "periodic" }, "particles": { "count": 20, "sizes": { "type": "equal", "radius": 0.5 } },
            "velocities": { "type": "gaussian", "sigma": 1 },
            "restitution": { "type": "constant", "coefficient": 0.9 }, "timeStep": { "type": "fixed", "dt": 0.05 },
            "until": 0.5, "output": { "seriesEvery": 1, "snapshotEvery": 5 } }"""
        val folder = Files.createDirectory(home.resolve("f${evil.replace("/", "")}"))
        val file = Files.writeString(folder.resolve("$evil.json"), text).toString()
        val run = folder.resolve("run").toString()
        val described = assertDone(plain(daphnis("describe", file)))
        assertTrue("x\\u001b]0;pwn\\u0007\\u001b[2J\\nFORGED\\u000d\\u007f\\u009b5m" in described) { described }
        assertTrue("run" in assertDone(plain(daphnis("run", file, "--out", run))))
        assertDone(plain(daphnis("compare", run, run)))
        assertDone(plain(daphnis("export", run, "--format", "xyz")))
        assertDone(plain(daphnis("analyze", run)))
        assertDone(plain(daphnis("movie", run, "--width", "240")))
        assertDone(
            plain(
                daphnis(
                    "bench", file, "--engines", "serial", "--threads", "1", "--rounds", "1", "--warm-up", "0",
                    "--out", "$run-bench",
                ),
            ),
        )
        assertDone(plain(daphnis("bench", "--compare", "$run-bench", "$run-bench")))
        val keys = arrayOf("--set", "name=\"${json}1\"", "--seeds", "1..2")
        assertDone(plain(daphnis("sweep", file, *keys, "--out", "$run-sweep")))
        assertRefused(plain(daphnis("describe", file, "--set", "$evil=1")))
        assertRefused(plain(daphnis("scenarios", evil)))
        assertRefused(plain(daphnis(evil)))
        assertRefused(plain(daphnis("run", "--$evil")))
        val traced = daphnis("describe", "$file$evil", "--debug")
        assertTrue("\tat daphnis" in traced.err)
        assertRefused(
            plain(
                CommandResult(
                    traced.code,
                    traced.out,
                    traced.err.lines().filter {
                        it.startsWith("daphnis:")
                    }.joinToString("\n"),
                ),
            ),
        )
        plain(CommandResult(traced.code, traced.out, traced.err.replace("\t", "")))
        val page = Files.readString(Path.of(run, "report.html"))
        assertFalse('\u001b' in page || '\u202e' in page)
        for (picture in Files.walk(Path.of(run, "plots")).use { all ->
            all.filter { "$it".endsWith(".svg") }.toList()
        }) {
            DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(picture.toFile().inputStream())
        }
    }

    /** Exit code and all output of a process of its own, whose locale is C. */
    private fun inLocaleC(vararg words: String): Pair<Int, String> {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val command =
            listOf(
                java,
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                "daphnis.app.MainKt",
            ) +
                words
        val builder = ProcessBuilder(command).directory(home.toFile()).redirectErrorStream(true)
        for (name in listOf("LC_ALL", "LANG", "LC_CTYPE")) builder.environment()[name] = "C"
        val process = builder.start()
        val said = process.inputStream.use { String(it.readAllBytes()) }
        assertTrue(process.waitFor(60, TimeUnit.SECONDS))
        return process.exitValue() to said
    }

    @Tag("thorough")
    @Test
    fun `in a locale of ASCII a name beyond it becomes a directory, and a path beyond it is one line`() {
        val given = daphnis("scenarios", "elastic-gas").out
        val gas = given.replace("\"name\": \"elastic-gas\"", "\"name\": \"Größe 日本\"")
        assertTrue("Größe" in gas)
        Files.writeString(home.resolve("named.json"), gas)
        val (code, said) = inLocaleC("run", "named.json", "--steps", "1", "--set", "particles.count=50", "--quiet")
        assertEquals(0, code) { said }
        assertTrue(
            Files.exists(home.resolve("runs")) &&
                Files.list(home.resolve("runs")).use {
                    it.count()
                } == 1L,
        ) { said }

        val placed = """{ "box": { "lengths": [10, 10, 10] }, "boundary": { "type": "periodic" },
            "placement": { "type": "file", "path": "größe.h5" },
            "restitution": { "type": "constant", "coefficient": 1 }, "timeStep": { "type": "fixed", "dt": 0.1 },
            "until": 0.1 }"""
        Files.writeString(home.resolve("placed.json"), placed)
        val (refused, line) = inLocaleC("describe", "placed.json")
        assertEquals(2, refused) { line }
        assertEquals(1, line.trimEnd().lines().size) { line }
        assertTrue("placement.path" in line) { line }
    }

    @Test
    fun `a hostile file is refused alike where it is analysed, placed from and exported`() {
        assertDone(
            daphnis(
                "run", "elastic-gas", "--set", "particles.count=20", "--steps", "1", "--quiet", "--out",
                "${home.resolve("run")}",
            ),
        )
        val file = home.resolve("huge.h5")
        // A file whose one dataset says another number of particles than the others.
        HdfFile.write(file).use { h5 ->
            val all = h5.putGroup("particles").putGroup("all")
            all.putGroup("box").putAttribute("boundary", Array(3) { "periodic" })
            val position = all.putGroup("position")
            position.putDataset("step", LongArray(1))
            position.putDataset("time", DoubleArray(1))
            position.putDataset("value", Array(1) { Array(3) { DoubleArray(3) } })
            all.putDataset("id", IntArray(2) { it })
            h5.putGroup("parameters").putDataset("shear_offset", DoubleArray(1))
        }
        val problem = "particles/all/id has the shape [2]; it must be [3]"
        assertRefused(daphnis("analyze", "$file"), problem)
        val placed = """{ "box": { "lengths": [10, 10, 10] }, "boundary": { "type": "periodic" },
            "placement": { "type": "file", "path": "huge.h5" },
            "restitution": { "type": "constant", "coefficient": 1 }, "timeStep": { "type": "fixed", "dt": 0.1 },
            "until": 0.1 }"""
        assertRefused(
            daphnis("describe", Files.writeString(home.resolve("placed.json"), placed).toString()),
            "placement.path",
            problem,
        )
        Files.copy(file, home.resolve("run/snapshots/0000000001.h5"), StandardCopyOption.REPLACE_EXISTING)
        for (format in listOf("xyz", "h5md")) {
            assertRefused(daphnis("export", "${home.resolve("run")}", "--format", format), problem)
        }
    }

    @Test
    fun `a file whose times do not ascend, or one of whose frames is empty, is not analysed`() {
        fun frames(vararg times: String) = times.joinToString("") { "2\nTime=$it\nX 0 0 0\nX 3 3 3\n" }
        val back = Files.writeString(home.resolve("back.xyz"), frames("1", "0"))
        assertRefused(daphnis("analyze", "$back"), "back.xyz", "frame 1 is of time 0.0, after 1.0", "ascend")
        val empty = Files.writeString(home.resolve("empty.xyz"), frames("0") + "0\nTime=1\n")
        assertRefused(daphnis("analyze", "$empty"), "empty.xyz", "no particle in frame 1")
    }

    @Test
    fun `a place far outside the box is refused, be the box the file's or the scenario's`() {
        val own = "2\nLattice=\"10 0 0 0 10 0 0 0 10\"\nX 0 0 0\nX 3 3 2e9\n"
        assertRefused(
            daphnis("analyze", "${Files.writeString(home.resolve("far.xyz"), own)}"),
            "z of particle 1",
            "1000000",
        )
        val open = Files.writeString(home.resolve("open.xyz"), "2\n\nX 0 0 0\nX 3 3 2e9\n")
        val scenario = arrayOf("--scenario", "elastic-gas", "--quiet", "--out", "${home.resolve("an")}")
        assertRefused(daphnis("analyze", "$open", *scenario), "z of particle 1", "of the scenario's boxes")
    }
}
