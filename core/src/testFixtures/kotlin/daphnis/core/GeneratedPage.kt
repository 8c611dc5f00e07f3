package daphnis.core

import org.junit.jupiter.api.Assertions.assertEquals
import java.nio.file.Files

/**
 * A page of `docs/reference`, which a test makes from what the program declares: it is compared with what is there, or
 * written anew with `-Ddaphnis.reference=write` (Gradle: `-Preference=write`).
 *
 * @property path in the repository, such as `docs/reference/commands.md`
 * @property title the heading of the page
 * @property source what the page is made from, in words behind "made from", such as "the help of the commands"
 */
class GeneratedPage(private val path: String, private val title: String, private val source: String) {
    /** Fails where the page is not [text] under its head; [test] is the class to name for writing it anew. */
    fun check(text: String, test: Class<*>, module: String) {
        val page = page(text)
        val file = Repository.root.resolve(path)
        if (System.getProperty("daphnis.reference") == "write") {
            Files.createDirectories(file.parent)
            Files.writeString(file, page)
        }
        val written = if (Files.exists(file)) Files.readString(file) else ""
        assertEquals(page, written) {
            "$path is not what $source say; write it anew: mvn -pl $module -am test -Dtest=${test.simpleName} " +
                "-Dsurefire.failIfNoSpecifiedTests=false -Ddaphnis.reference=write, or gradle test --tests " +
                "${test.name} -Preference=write"
        }
    }

    /** All of the page: its head, links to all sections of [text], and these. */
    private fun page(text: String): String {
        val sections = Regex("(?m)^## (.+)$").findAll(text).map { "[${it.groupValues[1]}](#${anchor(it.groupValues[1])})" }
        val links = if (sections.none()) "" else "On this page:\n${sections.joinToString(" ·\n")}\n\n"
        return "# $title\n\n<!-- Made by a test from $source; not to be edited. -->\n\n$links${text.trim()}\n"
    }

    private fun anchor(heading: String) =
        heading.lowercase().filter { it.isLetterOrDigit() || it in " -_" }.replace(' ', '-')

    companion object {
        /** A row of a table of Markdown; a vertical bar within a cell is escaped. */
        fun row(vararg cells: String): String = cells.joinToString(" | ", "| ", " |\n") { it.replace("|", "\\|") }

        /** The head of a table with columns [names], whose widths do not matter. */
        fun head(vararg names: String): String = row(*names) + names.joinToString("|", "|", "|\n") { "---" }
    }
}
