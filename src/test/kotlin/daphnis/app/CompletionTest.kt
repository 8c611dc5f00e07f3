package daphnis.app

import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** The script for bash, in a bash that is asked what it would offer. */
class CompletionTest {
    @TempDir
    lateinit var home: Path

    private val script by lazy { assertDone(daphnis("completion", "bash")) }

    /** What bash offers for the last of [words], after the others, in a directory with `mine.json`. */
    private fun offered(vararg words: String): List<String> = offeredBy(script, "_daphnis", *words)

    private fun offeredBy(script: String, function: String, vararg words: String): List<String> {
        Files.writeString(home.resolve("script"), script)
        Files.writeString(home.resolve("mine.json"), "{}")
        val line = words.joinToString(" ") { "'$it'" }
        val ask = "source ./script; COMP_WORDS=($line); COMP_CWORD=${words.size - 1}; $function; printf '%s\\n' " +
            "\"\${COMPREPLY[@]}\""
        val bash = ProcessBuilder("bash", "-c", ask).directory(home.toFile()).redirectErrorStream(true).start()
        val said = bash.inputReader().readText()
        assertTrue(bash.waitFor(1, TimeUnit.MINUTES))
        return said.lines().filter { it.isNotEmpty() }
    }

    @Test
    fun `zsh, which does not part words at equals signs, completes behind them too`() {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "no bash here")
        // What zsh has and bash has not, and bash's own in place of the arrays of ksh that zsh takes on for it.
        val zsh = assertDone(daphnis("completion", "zsh"))
        assertTrue(zsh.trimEnd().endsWith("complete -o filenames -F _daphnis_zsh daphnis")) { zsh.takeLast(200) }
        val script = "autoload() { :; }; compinit() { :; }; bashcompinit() { :; }\n" + zsh
        fun zshOffers(vararg words: String) = offeredBy(script, "_daphnis_zsh", *words)
        assertEquals(listOf("--engine=horizon"), zshOffers("daphnis", "run", "--engine=h"))
        assertEquals(listOf("horizon"), zshOffers("daphnis", "run", "--engine", "h"))
        assertEquals(listOf("cooling-gas"), zshOffers("daphnis", "run", "--engine=serial", "coo"))
    }

    /** The words that a bash at a prompt passes on when each of [lines] is typed, a tab in it. */
    private fun typed(vararg lines: String): List<String> {
        Files.writeString(home.resolve("script"), script)
        val told = "daphnis() { printf '<%s>' \"$@\"; echo; }; source ./script\n" + lines.joinToString("") { "$it\n" }
        val bash = ProcessBuilder("bash", "--norc", "--noprofile", "-i").directory(home.toFile())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
        bash.environment() += mapOf("INPUTRC" to "/dev/null", "PS1" to "", "TERM" to "dumb")
        val process = bash.start()
        process.outputStream.bufferedWriter().use { it.write(told) }
        val said = process.inputReader().readText()
        assertTrue(process.waitFor(1, TimeUnit.MINUTES))
        return said.lines().filter { it.startsWith("<") }.map { it.removePrefix("<run><").removeSuffix(">") }
    }

    @Test
    fun `at a prompt names are quoted once, whatever is in them and however they are begun`() {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "no bash here")
        Files.createDirectory(home.resolve("a directory"))
        val begun = mapOf(
            "my scene.json" to listOf("my", "my\\ s", "\"my s", "'my s"),
            "a:b.json" to listOf("a:", "a:b.", "a\\:"),
            "x=y.json" to listOf("x", "x="),
            "quo'te.json" to listOf("quo", "\"quo"),
            "\$Hx.json" to listOf("'\$H"),
            "par(en).json" to listOf("par"),
            "back\\slash.json" to listOf("back"),
            "a directory/" to listOf("a\\ d"),
        )
        for (name in begun.keys.filter { it.endsWith("json") }) Files.writeString(home.resolve(name), "{}")
        val expected = begun.flatMap { (name, words) -> words.map { name } }
        assertEquals(expected, typed(*begun.values.flatten().map { "daphnis run $it\t" }.toTypedArray()))
    }

    @Test
    fun `behind an equals sign values are completed, of options and of settings`() {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "no bash here")
        Files.writeString(home.resolve("only one.json"), "{}")
        val begun = mapOf(
            "--engine=th" to "--engine=thread-pool",
            "--from=on" to "--from=only one.json",
            "--from=\"only" to "--from=only one.json",
            "--set box.l" to "--set><box.lengths=",
            "--set frame.planet=sa" to "--set><frame.planet=saturn",
            "--set=engine.t" to "--set=engine.threads=",
            "--set forces[0].massR" to "--set><forces[0].massRatio=",
        )
        assertEquals(begun.values.toList(), typed(*begun.keys.map { "daphnis run $it\t" }.toTypedArray()))
        assertEquals(listOf("boundary.type=open"), offered("daphnis", "run", "--set", "boundary.type=o"))
        assertEquals(allEngines.names.map { "engine.name=$it" }, offered("daphnis", "sweep", "--set", "engine.name="))
        val keys = offered("daphnis", "describe", "--set", "")
        assertEquals(keys.distinct(), keys)
        assertTrue(keys.size > 150 && keys.all { it.endsWith("=") }) { "$keys" }
    }

    @Test
    fun `commands, options and the names of scenarios, engines and formats are those of the program`() {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "no bash here")
        assertEquals(listOf("resume"), offered("daphnis", "res"))
        assertEquals(listOf("resume"), offered("daphnis", "help", "res"))
        assertEquals(listOf("--threads"), offered("daphnis", "--debug", "run", "--th"))
        assertEquals(BuiltIn.names, offered("daphnis", "scenarios", ""))
        val scenarios = offered("daphnis", "run", "")
        assertTrue(scenarios.containsAll(BuiltIn.names + "mine.json")) { "$scenarios" }
        assertEquals(listOf("mine.json"), offered("daphnis", "run", "--engine", "serial", "min"))
        assertEquals(allEngines.names.toList(), offered("daphnis", "run", "--engine", ""))
        assertEquals(listOf("serial,islands"), offered("daphnis", "bench", "--engines", "serial,isl"))
        assertEquals(listOf("h5md"), offered("daphnis", "export", "mine", "--format", "h"))
        assertEquals(listOf("mine.json"), offered("daphnis", "analyze", "--scenario", "min"))
        assertEquals(listOf("bash"), offered("daphnis", "completion", "b"))
    }

    @Test
    fun `a directory is completed with a slash, and every shell has its script`() {
        assertTrue("\ncomplete -o filenames -F _daphnis_bash daphnis" in script)
        assertTrue("bashcompinit" in assertDone(daphnis("completion", "zsh")))
        val fish = assertDone(daphnis("completion", "fish"))
        for (name in BuiltIn.names + allEngines.names) assertTrue(name in fish) { name }
        assertRefused(daphnis("completion", "tcsh"), "tcsh", "fish")
    }

    @Test
    fun `help is a command, also about others`() {
        val help = assertDone(daphnis("help"))
        assertEquals(assertDone(daphnis("--help")), help)
        assertEquals(assertDone(daphnis("run", "--help")), assertDone(daphnis("help", "run")))
        assertTrue("completion" in help)
        assertRefused(daphnis("help", "rnu"), "rnu", "Did you mean run?")
        assertRefused(daphnis("rnu"), "Did you mean run?")
        assertRefused(daphnis("run", "--sede", "3"), "--seed")
    }
}
