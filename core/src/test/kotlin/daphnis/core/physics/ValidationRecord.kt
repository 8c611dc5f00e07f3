package daphnis.core.physics

import daphnis.core.GeneratedPage
import daphnis.core.Repository
import kotlinx.serialization.Serializable
import kotlinx.serialization.encodeToString
import kotlinx.serialization.json.Json

/**
 * A number that was measured, beside what it should be.
 *
 * @property bound how far from its [target] it may be; empty where nothing is asked of it
 * @property ok `ok`, `no`, or empty where nothing is asked
 * @property source of the target, where it is not that of the group
 * @property by what gives it, where it is not the command of the group: a test or a command
 */
@Serializable
internal data class ValidationRow(
    val quantity: String,
    val target: String,
    val measured: String,
    val bound: String,
    val ok: String,
    val source: String = "",
    val by: String = "",
)

/**
 * Numbers of one system.
 *
 * @property note what was run, and symbols
 * @property source of the targets
 * @property command lines of a shell that give the numbers again
 */
@Serializable
internal data class ValidationGroup(
    val group: String,
    val note: String = "",
    val source: String = "",
    val command: List<String> = emptyList(),
    val rows: List<ValidationRow>,
)

/** All numbers that were measured: `docs/reference/validation.json`, and the page that is made of it. */
internal class ValidationRecord(val groups: List<ValidationGroup>) {
    /** This with what tests have [seen], lines as [assertPhysics] writes them; the last of a quantity counts. */
    fun with(seen: List<String>): ValidationRecord {
        val rows = seen.map { parse(it) }.associateBy { it.quantity }
        val replaced = groups.map { group -> group.copy(rows = group.rows.map { old -> rows[old.quantity].over(old) }) }
        val known = groups.flatMap { group -> group.rows.map { it.quantity } }.toSet()
        val further = rows.values.filter { it.quantity !in known }
        if (further.isEmpty()) return ValidationRecord(replaced)
        return ValidationRecord(replaced + ValidationGroup(FURTHER, command = listOf(ALL), rows = further))
    }

    private fun ValidationRow?.over(old: ValidationRow) =
        this?.let { old.copy(target = it.target, measured = it.measured, bound = it.bound, ok = it.ok) } ?: old

    /** A line for each row, so that a change of one is seen as such. */
    fun json(): String = groups.joinToString(",\n", "[\n", "\n]\n") { group ->
        val head = listOf("group" to group.group, "note" to group.note, "source" to group.source)
            .filter { it.second.isNotEmpty() }.map { (name, text) -> "\"$name\": ${Json.encodeToString(text)}" }
        val command = group.command.takeIf { it.isNotEmpty() }?.let { lines ->
            "\"command\": [\n${lines.joinToString(",\n") { "   " + Json.encodeToString(it) }}\n  ]"
        }
        val rows = "\"rows\": [\n${group.rows.joinToString(",\n") { "   " + Json.encodeToString(it) }}\n  ]"
        " {" + (head + listOfNotNull(command) + rows).joinToString(",\n  ") + "}"
    }

    /** The sections of the page. */
    fun page(): String {
        val all = groups.flatMap { it.rows }
        val bad = groups.flatMap { group -> group.rows.filter { it.ok == "no" }.map { group.group to it } }
        val list = bad.joinToString("") { (group, row) ->
            wrapped("- $group: ${row.quantity.replace("|", "\\|")}, ${row.measured} and not ${row.target}.", "  ") +
                "\n"
        }
        val head = "${all.size} numbers, ${all.count { it.ok == "ok" }} within their bound and ${bad.size} not; " +
            "of the others nothing is asked.\n\n$list"
        return head + groups.joinToString("") { "\n" + section(it) }
    }

    private fun section(group: ValidationGroup): String {
        val columns = listOf<Pair<String, (ValidationRow) -> String>>(
            "quantity" to { it.quantity },
            "target" to { it.target },
            "measured" to { it.measured },
            "bound" to { it.bound },
            "ok" to { if (it.ok == "no") "**no**" else it.ok },
            "source" to { it.source },
            "by" to { it.by },
        ).filter { (name, cell) -> group.rows.any { cell(it).isNotEmpty() } || name == "quantity" }
        val text = StringBuilder("## ${group.group}\n\n")
        if (group.note.isNotEmpty()) text.append(wrapped(group.note)).append("\n\n")
        if (group.source.isNotEmpty()) text.append(wrapped("Targets: ${group.source}.")).append("\n\n")
        if (group.command.isNotEmpty()) text.append("```sh\n${group.command.joinToString("\n")}\n```\n\n")
        text.append(GeneratedPage.head(*columns.map { it.first }.toTypedArray()))
        for (row in group.rows) text.append(GeneratedPage.row(*columns.map { it.second(row) }.toTypedArray()))
        return text.toString()
    }

    /** In lines of at most 120 characters; those behind the first begin with [indent]. */
    private fun wrapped(text: String, indent: String = ""): String {
        val lines = ArrayList<String>()
        for (word in text.split(' ')) {
            val more = lines.lastOrNull()?.let { "$it $word" }
            when {
                more == null -> lines += word
                more.length > WIDTH -> lines += indent + word
                else -> lines[lines.lastIndex] = more
            }
        }
        return lines.joinToString("\n")
    }

    companion object {
        const val PATH = "docs/reference/validation.json"
        const val FURTHER = "Further numbers"
        private const val ALL = "./check --physics"
        private const val WIDTH = 120

        fun read(): ValidationRecord = ValidationRecord(Json.decodeFromString(Repository.read(PATH)))

        private fun parse(line: String): ValidationRow {
            val (quantity, target, measured, bound, ok) = line.trim().removePrefix("| ").removeSuffix(" |").split(" | ")
            return ValidationRow(quantity, target, measured, bound, if (ok == "ok") "ok" else "no")
        }
    }
}
