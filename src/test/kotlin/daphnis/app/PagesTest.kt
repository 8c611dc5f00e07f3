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
        for (page in pages(decisions).filter { it.name != "README.md" }) {
            val lines = index.filter { "](${page.name})" in it }
            assertEquals(1, lines.size) { page.name }
            val head = page.readLines().take(4).joinToString("\n")
            val isOvertaken = "**Overtaken**" in head || "Replaced by" in head
            assertEquals(isOvertaken, "(overtaken" in lines.single()) { page.name }
        }
    }

    private companion object {
        /** Words from which on a page is long. */
        const val LONG = 1500
    }
}
