package daphnis.app.cite

import daphnis.app.assertDone
import daphnis.app.assertRefused
import daphnis.app.daphnis
import daphnis.core.run.Summary
import daphnis.core.run.Version
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** `cite` and `reproduce`: what a paper says of a run, and whether it is so. */
class CiteTest {
    @TempDir
    lateinit var home: Path

    private fun at(name: String) = home.resolve(name).toString()

    private fun run(name: String, vararg more: String) = assertDone(
        daphnis("run", "cooling-gas", "--set", "particles.count=100", *more, "--out", at(name), "--quiet"),
    )

    @Test
    fun `a run is cited, and done again with another engine from what was written`() {
        run("gas", "--steps", "20", "--set", "engine.name=serial", "--set", "engine.threads=1")
        val said = assertDone(daphnis("cite", at("gas"), "--record", at("gas.json")))
        val digest = Summary.read(home.resolve("gas/summary.json")).stateDigest
        for (part in listOf(
            "scenario      cooling-gas",
            digest,
            "step 20",
            Version.text,
            "@software{daphnis,\n  author",
        )) {
            assertTrue(part in said) { said }
        }
        for (what in listOf("gas.json", "gas")) {
            val again = daphnis("reproduce", at(what), "--engine", "islands", "--out", at("of $what"), "--quiet")
            assertTrue("\nreproduced: the digest is that" in assertDone(again)) { again.out }
        }
        assertEquals("islands", Summary.read(home.resolve("of gas/summary.json")).engine)
    }

    @Test
    fun `another end is told with exit code 1`() {
        run("gas", "--steps", "5")
        assertDone(daphnis("cite", at("gas"), "--record", at("gas.json")))
        val text = Files.readString(home.resolve("gas.json"))
        Files.writeString(
            home.resolve("other.json"),
            text.replace("\"seed\": 1", "\"seed\": 2").replace(Version.text, "x"),
        )
        val other = daphnis("reproduce", at("other.json"), "--out", at("other"), "--quiet")
        assertEquals(1, other.code) { other.err }
        assertTrue("not reproduced: the run ended after step 5" in other.out) { other.out }
        assertTrue("(daphnis x, here ${Version.text})" in other.out) { other.out }
    }

    @Test
    fun `the number of steps counts, and nothing is replaced`() {
        run("gas", "--steps", "5")
        assertDone(daphnis("cite", at("gas"), "--record", at("gas.json")))
        assertRefused(daphnis("cite", at("gas"), "--record", at("gas.json")), "--record", "is there already")
        assertRefused(daphnis("reproduce", at("gas.json"), "--out", at("gas")), "--out", "holds a run already")
        val text = Files.readString(home.resolve("gas.json"))
        Files.writeString(home.resolve("steps.json"), text.replace("\"steps\": 5", "\"steps\": 6"))
        assertEquals(1, daphnis("reproduce", at("steps.json"), "--out", at("again"), "--quiet").code)
        Files.writeString(home.resolve("digest.json"), text.replace(Regex("\"[0-9a-f]{64}\""), "\"f00\""))
        assertRefused(daphnis("reproduce", at("digest.json")), "digest.json", "its stateDigest is not a digest")
    }

    @Test
    fun `what cannot be cited or done again is refused`() {
        assertRefused(daphnis("cite", at("nothing")), "nothing")
        assertRefused(daphnis("reproduce", at("nothing")), "nothing", "cannot be read")
        Files.writeString(home.resolve("bad.json"), "{\"daphnis\": 1}")
        assertRefused(daphnis("reproduce", at("bad.json")), "bad.json", "is not what `daphnis cite --record` writes")
        run("gas", "--steps", "5")
        assertDone(daphnis("run", "--from", at("gas"), "--steps", "2", "--out", at("from"), "--quiet"))
        assertRefused(daphnis("cite", at("from"), "--record", at("from.json")), "begins from a state in a file")
        assertDone(daphnis("cite", at("from")))
        assertDone(daphnis("reproduce", at("from"), "--out", at("from again"), "--quiet"))
        assertRefused(daphnis("cite", at("gas"), "--record", at("no/such.json")), "--record", "there is no directory")
        assertFalse(Files.exists(home.resolve("no")))
        val summary = home.resolve("gas/summary.json")
        val text = Files.readString(summary)
        Files.writeString(summary, text.replace("\"steps\": 5", "\"steps\": 6"))
        for (command in listOf(
            "cite",
            "reproduce",
        )) {
            assertRefused(daphnis(command, at("gas")), "is not what the run wrote")
        }
        Files.delete(summary)
        assertRefused(daphnis("cite", at("gas")), "has not finished", "resume ${at("gas")}")
        assertRefused(daphnis("reproduce", at("gas")), "has not finished")
        val same = assertDone(daphnis("compare", at("gas"), at("gas")))
        assertTrue("gas/summary.json is missing, which" in same) { same }
    }
}
