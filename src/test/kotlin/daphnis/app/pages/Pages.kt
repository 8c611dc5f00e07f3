package daphnis.app.pages

import daphnis.core.Repository
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.readText

/**
 * A fenced block of a page.
 *
 * @property language as it is labelled, empty for none
 * @property notes what comments directly above it say, by their first word, such as `short`
 */
internal class Block(val place: String, val language: String, val text: String, val notes: Map<String, String>)

/** A page of the documentation, as it is written. */
internal class Page(val path: Path) {
    val name: String = Repository.root.relativize(path).toString()

    val blocks: List<Block>

    /** Code within lines, one line each, in the order of the page. */
    val inline: List<String>

    /** Relative links and pictures of this page, in Markdown or HTML. */
    val links: List<String>

    init {
        val text = path.readText()
        blocks = FENCED.findAll(text).map { found ->
            val (comments, indent, language, inside) = found.destructured
            val line = text.substring(0, found.groups[2]!!.range.first).count { it == '\n' } + 1
            val notes = NOTE.findAll(comments).associate { it.groupValues[1] to it.groupValues[2].trim() }
            Block("$name:$line", language, inside.replace(Regex("(?m)^$indent"), ""), notes)
        }.toList()
        links = LINK.findAll(INLINE.replace(FENCED.replace(text, ""), "")).map { found ->
            found.groupValues.drop(1).first { it.isNotEmpty() }
        }.filterNot { ABSOLUTE.containsMatchIn(it) }.toList()
        inline = INLINE.findAll(FENCED.replace(text, "\n")).map {
            it.groupValues[1].replace(Regex("\\s+"), " ").trim()
        }.toList()
    }

    override fun toString() = name

    companion object {
        private val NOTE = Regex("""<!-- (short|not run|file): (.*?) -->""", RegexOption.DOT_MATCHES_ALL)
        private val FENCED = Regex(
            """((?:^ *<!-- (?:short|not run|file): (?:(?!-->).)*-->\n+)*)^( *)```(\w*)[^\n]*\n(.*?)^ *```$""",
            setOf(RegexOption.MULTILINE, RegexOption.DOT_MATCHES_ALL),
        )

        /** A link or a picture as `[…](link "title")`, `[…]: link`, `href="link"` or `src="link"`. */
        private val LINK = Regex("""\]\(<?([^)\s>]+)[^)]*\)|(?m)^\[[^\]]+\]: +(\S+)|\b(?:href|src|srcset)="([^"]+)"""")

        private val ABSOLUTE = Regex("""^(?:[a-z]+:|//)""")

        private val INLINE = Regex("""`([^`]+)`""")

        /** All pages, those of decisions and of changes too, which tell of what was. */
        val all: List<Page> =
            listOf("", "python", "docs", "docs/examples", "docs/reference", "docs/adr", "docs/releases").flatMap { pages(it) }

        /** Those which say what is. */
        val current: List<Page> = all.filter { !it.name.startsWith("docs/adr/") && it.name != "CHANGELOG.md" }

        val examples: List<Page> = pages("docs/examples")

        private fun pages(folder: String): List<Page> = Files.list(Repository.root.resolve(folder)).use { files ->
            files.filter { it.extension == "md" }.sorted().toList().map { Page(it) }
        }
    }
}
