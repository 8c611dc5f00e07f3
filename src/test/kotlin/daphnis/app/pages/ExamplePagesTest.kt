package daphnis.app.pages

import daphnis.app.assertDone
import daphnis.app.daphnis
import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.readText

/**
 * Each page of examples is done from top to bottom in a folder of its own, in the short form that comments in the page
 * say (CONTRIBUTING.md), and leaves the files that the page names.
 */
@Tag("jdk-neutral")
internal class ExamplePagesTest {
    @Tag("thorough")
    @ParameterizedTest
    @MethodSource("pages")
    fun `a page of examples does what it says`(page: Page, @TempDir folder: Path) {
        val commands = page.blocks.flatMap { block ->
            block.notes["file"]?.let { Files.writeString(folder.resolve(it), block.text) }
            val isRun = block.language == "sh" && "not run" !in block.notes
            val short = block.notes["short"]?.let { shellCommands(it).single().words }.orEmpty()
            if (isRun) shellCommands(block.text).mapNotNull { ExampleCommand.of(it, short, folder) } else emptyList()
        }
        for (command in commands) {
            val printed = assertDone(daphnis(*command.words.toTypedArray()))
            command.output?.let { Files.writeString(it, printed) }
        }
        val left = if (commands.isEmpty()) null else Left(folder)
        val missing = if (left == null) emptyList() else page.inline.filterNot { left.has(it) }
        assertEquals(emptyList<String>(), missing) { "$page names what its runs have not left" }
    }

    @Test
    fun `a short form replaces what the page says of the same`() {
        val line = "./daphnis run ring --set a=1 --set b=2 --until 9 --out=runs/r > x.txt"
        val short = listOf("--set", "a=3", "--set", "untilOrbits=2")
        val command = ExampleCommand.of(shellCommands(line).single(), short, Path.of("/f"))!!
        val seen = "run ring --set b=2 --out=/f/runs/r --set a=3 --set untilOrbits=2"
        assertEquals(seen, command.words.joinToString(" "))
        assertEquals(Path.of("/f/x.txt"), command.output)
    }

    @Test
    fun `what is named and not there is seen`(@TempDir folder: Path) {
        Files.createDirectories(folder.resolve("runs/a/tables"))
        Files.writeString(folder.resolve("runs/a/tables/numbers.csv"), "key,value\npressure_of_discs,1\n")
        val left = Left(folder)
        for (name in listOf("tables/numbers.csv", "numbers.csv", "pressure_of_discs", "toomre_q", "--set a=b")) {
            assertTrue(left.has(name)) { name }
        }
        for (name in listOf("tables/number.csv", "plots/numbers", "pressure_of_disks")) {
            assertTrue(!left.has(name)) {
                name
            }
        }
    }

    private companion object {
        @JvmStatic
        fun pages(): List<Page> = Page.examples
    }
}

/** What runs have left in a folder. */
internal class Left(folder: Path) {
    private val files = Files.walk(folder).use { all -> all.filter { it.isRegularFile() }.toList() }
    private val paths = files.map { "/${folder.relativize(it)}" }

    /** Words of tables, and of pages that have all keys, since a short run may be too short for some of them. */
    private val words: Set<String> by lazy {
        val tables = files.filter { "$it".endsWith(".csv") && Files.size(it) < LARGE }.map { it.readText() }
        val pages = listOf("docs/analysis.md", "docs/reference/columns.md", "docs/runs.md", "docs/scenario.md").map {
            Repository.read(it)
        }
        (tables + pages).flatMap { text -> KEY.findAll(text).map { it.value } }.toSet()
    }

    /** Words of the pages that are made of declarations. */
    private val reference: Set<String> by lazy {
        val pages = listOf("numbers", "tables").map { Repository.read("docs/reference/$it.md") }
        pages.flatMap { text -> KEY.findAll(text).map { it.value } }.toSet()
    }

    /** Whether [code] of a page is the name of a file that was left or of a known key, or neither kind of name. */
    fun has(code: String): Boolean = when {
        FILE.matches(code) -> paths.any { it.endsWith("/$code") }
        PLOT.matches(code) -> paths.any { "/$code." in it }
        KEY.matches(code) -> code in words || code in reference
        else -> true
    }

    private companion object {
        const val LARGE = 1_000_000L
        val FILE = Regex("""(?:[\w-]+/)*[\w-]+\.(?:csv|html|svg|png|gif|mp4|xyz|h5|pvd)""")
        val PLOT = Regex("""plots/[\w-]+""")
        val KEY = Regex("""[a-z][a-z0-9]*(?:_[a-z0-9]+)+""")
    }
}
