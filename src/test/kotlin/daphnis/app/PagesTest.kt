package daphnis.app

import daphnis.app.pages.Page
import daphnis.core.Repository
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.useLines

/** That readers find their way in the documentation. */
class PagesTest {
    private val docs: Path = Repository.root.resolve("docs")
    private val decisions: Path = docs.resolve("adr")

    private fun pages(folder: Path) = Files.list(folder).use { all -> all.filter { it.extension == "md" }.toList() }

    /** Headings of [level] outside code. */
    private fun headings(page: Path, level: Int): List<String> {
        var isCode = false
        return page.readLines().filter { line ->
            if (line.startsWith("```")) isCode = !isCode
            !isCode && line.startsWith("#".repeat(level) + " ")
        }.map { it.drop(level + 1) }
    }

    /** As those who show the pages make anchors of headings. */
    private fun anchor(heading: String): String =
        heading.lowercase().filter { it.isLetterOrDigit() || it in " -_" }.replace(' ', '-')

    /** Numbers of decisions that were overtaken. */
    private val history: List<Int> =
        headings(decisions.resolve("history.md"), 3).map { it.removePrefix("ADR ").toInt() }

    @Test
    fun `long pages begin with links to all their sections`() {
        val long = pages(docs).filter { it.readText().split(Regex("\\s+")).size > LONG }
        assertTrue(long.size >= 8)
        for (page in long) {
            val head = page.readText().substringBefore("\n## ")
            val missing = headings(page, 2).filter { "(#${anchor(it)})" !in head }
            assertEquals(emptyList<String>(), missing) { page.name }
        }
    }

    @Test
    fun `every link to a file finds it, and a section of a page in it`() {
        val broken = Page.all.flatMap { page -> page.links.mapNotNull { brokenLink(page, it) } }
        assertEquals("", broken.joinToString("\n"))
        val here = Page(docs.resolve("guide.md"))
        for (link in listOf("no.md", "examples/no", "physics.md#no", "#no", "images/no.png")) {
            assertEquals("guide.md: $link", brokenLink(here, link)?.removePrefix("docs/"))
        }
        assertTrue(Page.all.sumOf { it.links.size } > 300)
    }

    private fun brokenLink(page: Page, link: String): String? {
        val file = link.substringBefore('#')
        val target = if (file.isEmpty()) page.path else page.path.resolveSibling(file).normalize()
        val isThere = Files.exists(target) && target.startsWith(Repository.root)
        val isFound =
            isThere && (target.extension != "md" || '#' !in link || link.substringAfter('#') in anchors(target))
        return "${page.name}: $link".takeUnless { isFound }
    }

    private fun anchors(page: Path) = (1..4).flatMap { headings(page, it) }.map { anchor(it) }

    @Test
    fun `the index of decisions has each of them once, and says which were overtaken`() {
        val index = decisions.resolve("README.md").readLines()
        for (page in pages(decisions).filter { DECISION.containsMatchIn(it.name) }) {
            val lines = index.filter { "](${page.name})" in it }
            assertEquals(1, lines.size) { page.name }
            val heading = page.useLines { it.first() }.removePrefix("# ")
            assertTrue(lines.single().startsWith("- [$heading](")) { "$heading is otherwise in the index" }
            val head = page.readLines().take(4).joinToString("\n")
            val isOvertaken = "**Overtaken**" in head || "Replaced by" in head
            assertEquals(isOvertaken, "(overtaken" in lines.single()) { page.name }
        }
        val listed = Regex("""\[(\d+)]\(history\.md#adr-\1\)""").findAll(index.joinToString("\n"))
        assertEquals(history.sorted(), listed.map { it.groupValues[1].toInt() }.toList())
    }

    @Test
    fun `every decision that is cited by its number is there`() {
        val numbers = pages(decisions).mapNotNull { DECISION.find(it.name)?.value?.toInt() }
        assertEquals(emptyList<Int>(), numbers.filter { it in history }) { "decisions that are there and overtaken" }
        val known = (numbers + history).toSet()
        var cited = 0
        val sources = SOURCES.flatMap { folder ->
            Files.walk(Repository.root.resolve(folder)).use { all ->
                all.filter { it.extension in setOf("kt", "java", "py", "sh", "js") }.toList()
            }
        }
        val wrong = (sources + Page.all.map { it.path }).flatMap { file ->
            val named = CITED.findAll(file.readText()).flatMap { Regex("""\d+""").findAll(it.value) }
                .map { it.value.toInt() }.toList()
            cited += named.size
            named.filterNot { it in known }.map { "${file.name}: $it" }
        }
        assertEquals("", wrong.joinToString("\n"))
        assertTrue(cited > 200) { "only $cited" }
    }

    private companion object {
        /** Words from which on a page is long. */
        const val LONG = 1500

        /** Name of the file of a decision that holds. */
        val DECISION = Regex("""^\d{4}(?=-)""")

        /** One or several decisions, as `ADR 31`, `ADRs 5 and 7` or the name of a file. */
        val CITED = Regex("""\bADRs?\s+\d+(?:(?:,\s+|\s+and\s+)\d+(?![\d.]))*|\badr/\d{4}""")

        /** Where decisions are cited besides in pages. */
        val SOURCES =
            listOf("core/src", "actors/src", "analysis/src", "analysis/plots/src", "bench/src", "src", "python/src")
    }
}
