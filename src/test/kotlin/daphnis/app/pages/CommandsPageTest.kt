package daphnis.app.pages

import daphnis.app.assertDone
import daphnis.app.daphnis
import daphnis.core.GeneratedPage
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** `docs/reference/commands.md` is what `daphnis help` prints of each command. */
@Tag("jdk-neutral")
class CommandsPageTest {
    /** What a command is given, an option with its value or another command, and what is said of it. */
    private class Item(val names: String, var text: String)

    /** Items under a heading, with what is said of all of them. */
    private class Section(val heading: String) {
        var note = ""
        val items = ArrayList<Item>()
    }

    /** The paragraph below the first line, and the sections. */
    private fun help(command: String): Pair<String, List<Section>> {
        val sections = arrayListOf(Section(""))
        for (line in assertDone(daphnis("help", *listOfNotNull(command.ifEmpty { null }).toTypedArray())).lines()) {
            val indent = line.length - line.trimStart().length
            val section = sections.last()
            when {
                line.isBlank() || line.startsWith("Usage: ") -> Unit
                indent == 0 && line.endsWith(":") -> sections += Section(line.dropLast(1))
                indent == 0 -> Unit
                indent == 2 && (section.heading == COMMANDS || line[2] in "-<") -> {
                    val (names, text) = ITEM.matchEntire(line)!!.destructured
                    section.items += Item(names, text)
                }
                indent == 2 || section.items.isEmpty() -> section.note += " " + line.trim()
                else -> section.items.last().let { it.text += " " + line.trim() }
            }
        }
        return sections.first().note.trim() to sections.drop(1)
    }

    private fun row(item: Item): String {
        val name = item.names.substringBefore("=").substringBefore("[").ifEmpty { item.names }
        val value = item.names.removePrefix(name).filter { it !in "[]<>()" }.removePrefix("=")
        val text = item.text.trim().replace(Regex("<(\\S+)>"), "$1").replace("*", "\\*").replace("[", "\\[")
        return GeneratedPage.row("`${name.trim('<', '>').replace(", ", "`, `")}`", value, text)
    }

    private fun page(commands: List<Item>) = commands.joinToString("\n") { command ->
        val (about, sections) = help(command.names)
        val rows = sections.flatMap { section ->
            val items = section.items.filter { it.names != "-h, --help" }
            val heading = section.heading.takeIf { it != "Arguments" && it != "Options" && items.isNotEmpty() }
            listOfNotNull(heading?.let { GeneratedPage.row("*$it*", "", section.note.trim()) }) + items.map { row(it) }
        }
        "## ${command.names}\n\n${wrapped(about)}\n" +
            if (rows.isEmpty()) "" else "\n" + GeneratedPage.head("", "value", "meaning") + rows.joinToString("")
    }

    private fun wrapped(text: String) = text.replace(Regex("(.{1,110})(?: |$)"), "$1\n").trim()

    @Test
    fun `the page is what the commands say`() {
        val commands = help("").second.single { it.heading == COMMANDS }.items
        assertTrue(commands.size > 12)
        val text = "What `daphnis help` prints of each command. `--debug`, anywhere, shows the stack trace of what\n" +
            "goes wrong, and `--version` the version. The [guide](../guide.md) has examples.\n\n" + page(commands)
        GeneratedPage("docs/reference/commands.md", "Commands and options", "the help of the commands")
            .check(text, javaClass, "src")
    }

    private companion object {
        const val COMMANDS = "Commands"
        val ITEM = Regex("""  (\S.*?)(?:\s{2,}(\S.*))?""")
    }
}
