package daphnis.app.pages

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** The commands in the documentation are such as the program and the tools take. Most of them are not run here. */
@Tag("jdk-neutral")
class CommandsTest {
    private val check = CommandCheck()
    private val blocks = Page.current.flatMap { it.blocks }

    @Test
    fun `every command in a block is one`() {
        val shell = blocks.filter { it.language == "sh" }
        val commands = shell.flatMap { block -> shellCommands(block.text).map { block to it } }
        assertTrue(commands.count { (_, it) -> check.isDaphnis(it.words) } > 60) { "only ${commands.size} commands" }
        val wrong = commands.mapNotNull { (block, command) ->
            check.problem(command.words)?.let { "${block.place}: $it" }
        }
        assertEquals("", wrong.joinToString("\n"))
    }

    @Test
    fun `what shortens a block is of the options of a run`() {
        val wrong = blocks.mapNotNull { block ->
            val short = block.notes["short"] ?: return@mapNotNull null
            check.problem(listOf("daphnis", "run") + shellCommands(short).single().words)?.let { "${block.place}: $it" }
        }
        assertEquals("", wrong.joinToString("\n"))
    }

    @Test
    fun `blocks of commands say that they are`() {
        val command = Regex("""(?m)^\S*\$? ?(\./)?(daphnis|check) (?!─)""")
        val unlabelled = blocks.filter { it.language !in setOf("sh", "python") && command.containsMatchIn(it.text) }
        assertEquals(emptyList<String>(), unlabelled.map { it.place })
    }

    @Test
    fun `commands and options within lines are there`() {
        val wrong = Page.current.flatMap { page ->
            page.inline.mapNotNull { code -> check.inlineProblem(code)?.let { "${page.name}: `$code` $it" } }
        }
        assertEquals("", wrong.joinToString("\n"))
    }

    @Test
    fun `a slip in a command is seen`() {
        val slips = mapOf(
            "./daphnis rum ring-patch" to "no such subcommand rum",
            "./daphnis run ring-path" to "no built-in scenario",
            "./daphnis run ring-patch --untill 3" to "no such option --untill",
            "./daphnis run ring-patch --steps many" to "invalid value for --steps",
            "./daphnis run ring-patch --engine=horizons" to "--engine is horizons",
            "./daphnis run mine.json --set particles.optical=1" to "particles.optical",
            "./daphnis run ring-patch --set 'box.lengths=[1,2'" to "box.lengths",
            "./daphnis sweep ring-patch --set particles.opticalDepht=1,2" to "opticalDepht",
            "./daphnis run elastic-gas --set particles.fillingFactor=0.1" to "needs exactly one of count",
            "./daphnis sweep ring-patch --set particles.opticalDepth=1" to "nothing to sweep",
            "./daphnis export runs/a --format xyzz" to "xyzz",
            "./daphnis run a b" to "unexpected extra argument",
            "./check --al" to "--al is no option of check",
            "tools/drill --all" to "tools/drill is not there",
            "mvn -pl core -Dtest=StopTest" to "StopTest",
            "java -cp x.jar daphnis.bench.GoalKt" to "daphnis.bench.GoalKt",
        )
        for ((line, part) in slips) {
            val seen = check.problem(shellCommands(line).single().words).orEmpty()
            assertTrue(part in seen) { "$line: '$seen'" }
        }
        assertTrue("growth.rat: unknown" in check.inlineProblem("--set growth.rat=1").orEmpty())
        assertTrue("--quite" in check.inlineProblem("daphnis run --quite").orEmpty())
        assertTrue("--quite" in check.inlineProblem("--quite N").orEmpty())
    }
}
