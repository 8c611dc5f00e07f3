package daphnis.core

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Files
import kotlin.io.path.extension
import kotlin.io.path.name
import kotlin.io.path.readText

/**
 * The code in the docs is that of tests: every block in Kotlin or Java is an example which a test compiles and runs,
 * and every example is in the docs. An example stands between `// example: name` and `// end`. The docs may put
 * comments into a column, which the formatter of sources does not. What belongs in a build script is left out.
 */
class GuideExamplesTest {
    private val pages = listOf("docs", "docs/examples", "docs/internals").flatMap { folder ->
        Files.list(Repository.root.resolve(folder)).use { files -> files.filter { it.extension == "md" }.toList() }
    }.plusElement(Repository.root.resolve("README.md"))
        .associate { "${Repository.root.relativize(it)}" to COLUMN.replace(it.readText(), " //") }

    /** The examples of all tests, by name. */
    private val examples: Map<String, String> = listOf("core", "actors", "analysis", ".").flatMap { module ->
        Files.walk(Repository.root.resolve("$module/src/test")).use { files ->
            files.filter { it.extension in CODE && it.name != "GuideExamplesTest.kt" }.toList()
        }
    }.flatMap { EXAMPLE.findAll(it.readText()) }.associate { it.groupValues[1] to it.groupValues[2].trimIndent() }

    @Test
    fun `every block of code in the docs is an example of a test`() {
        val blocks = pages.flatMap { (page, text) -> BLOCK.findAll(text).map { page to it.groupValues[1] } }
            .filterNot { (_, code) -> code.startsWith("dependencies {") }
        assertTrue(blocks.size > 15) { "only ${blocks.size} blocks of code" }
        val strange = blocks.filter { (_, code) -> code.trim() !in examples.values.map { it.trim() } }
        assertEquals(emptyList<String>(), strange.map { (page, code) -> "$page: ${code.trim().lines().first()}" })
    }

    @Test
    fun `every example of a test is in the docs`() {
        val text = pages.values.joinToString("\n")
        assertEquals(emptyList<String>(), examples.filterValues { it !in text }.keys.toList())
    }

    private companion object {
        val COLUMN = Regex(""" {2,}//""")
        val CODE = setOf("kt", "java")
        val EXAMPLE = Regex("""// example: (\w+)\n(.*?)\n\s*// end\n""", RegexOption.DOT_MATCHES_ALL)
        val BLOCK = Regex("""```(?:kotlin|java)\n(.*?)\n```""", RegexOption.DOT_MATCHES_ALL)
    }
}
