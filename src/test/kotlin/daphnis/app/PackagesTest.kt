package daphnis.app

import daphnis.app.pages.Page
import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import java.nio.file.Files
import kotlin.io.path.extension
import kotlin.io.path.readText
import kotlin.io.path.useLines

/** That the map of the sources is one of the sources as they are. */
@Tag("jdk-neutral")
class PackagesTest {
    private val packages: List<String> = SOURCES.flatMap { folder ->
        val files = Files.walk(Repository.root.resolve(folder)).use { all ->
            all.filter { it.extension == "kt" }.toList()
        }
        assertTrue(files.isNotEmpty()) { "no sources in $folder" }
        files.map { file ->
            file.useLines { lines -> lines.first { it.startsWith("package ") }.removePrefix("package ") }
        }
    }.distinct().sorted()

    @Test
    fun `every package has a sentence in the page for Dokka, and every sentence a package, in the order of names`() {
        val said = "\n${Repository.root.resolve("docs/internals/packages.md").readText()}".split("\n# Package ").drop(1)
            .map { it.substringBefore('\n') to it.substringAfter('\n').trim() }
        assertEquals(packages.joinToString("\n"), said.joinToString("\n") { it.first })
        val wrong = said.filter { (_, words) -> !words.endsWith(".") || words.length !in 10..400 }.map { it.first }
        assertEquals(emptyList<String>(), wrong) { "one to three sentences" }
    }

    @Test
    fun `the page on the architecture, and its drawing, name no package that is not there`() {
        fun isThere(name: String) = "daphnis.$name".removeSuffix(".*").let { whole ->
            packages.any { it == whole || name.endsWith(".*") && it.startsWith("$whole.") }
        }
        val page = Page(Repository.root.resolve("docs/architecture.md"))
        val named = page.inline.filter { NAME.matches(it) }
        assertTrue(named.size > 40) { "only $named" }
        assertEquals(emptyList<String>(), named.filterNot { isThere(it) })
        assertTrue(page.path.readText().split(Regex("\\s+")).size <= 1500)

        // Rooms in the drawing are named by the ends of their names.
        val drawn = TITLE.findAll(Repository.root.resolve("docs/images/architecture.svg").readText())
            .flatMap { it.groupValues[1].split(", ", " … ") }.toList()
        assertTrue(drawn.size > 20) { "only $drawn" }
        assertEquals(
            emptyList<String>(),
            drawn.filter { name -> packages.none { ".$it.".contains(".${name.removeSuffix(".*")}.") } },
        )
        assertTrue(!isThere("core.nowhere") && !isThere("nowhere.*"))
    }

    private companion object {
        val NAME = Regex("""(?:core|actors|cluster|analysis|app)(?:\.[a-z0-9]+)*\.(?:\*|[a-z0-9]+)""")
        val TITLE = Regex("""<text class="t"[^>]*>([^<]+)</text>""")
        val SOURCES = listOf(
            "core/src/main/kotlin",
            "actors/src/main/kotlin",
            "analysis/src/main/kotlin",
            "analysis/plots/src/main/kotlin",
            "bench/src/jmh/kotlin",
            "src/main/kotlin",
        )
    }
}
