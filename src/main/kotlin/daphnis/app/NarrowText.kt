package daphnis.app

import com.github.ajalt.mordant.terminal.Terminal
import daphnis.app.describe.wrapped
import daphnis.app.progress.columnsFor

/**
 * Columns that a text on the standard output may use: those of the terminal, elsewhere as many as the variable
 * `COLUMNS` says; null for any number.
 */
internal fun outputColumns(): Int? {
    val terminal = Terminal()
    return if (terminal.terminalInfo.outputInteractive) columnsFor(terminal) else columnsOf(System.getenv("COLUMNS"))
}

/** The number that a [variable] holds, if it is one of columns. */
internal fun columnsOf(variable: String?): Int? = variable?.trim()?.toIntOrNull()?.takeIf { it > 0 }

/**
 * [text] in lines of at most [columns], as far as single words allow it: paragraphs go on below, and of a table in
 * Markdown that is wider each row becomes a list.
 */
internal fun fitted(text: String, columns: Int): String {
    val out = ArrayList<String>()
    val table = ArrayList<String>()
    for (line in text.lines() + "") {
        if (line.startsWith("|")) {
            table += line
            continue
        }
        if (table.isNotEmpty()) out += if (isWide(table, columns)) list(table, columns) else table.toList()
        table.clear()
        out += wrapped(line, columns)
    }
    return out.dropLast(1).joinToString("\n")
}

/** Whether a line of a table in [lines] has no place in [columns]. */
internal fun isWide(lines: List<String>, columns: Int): Boolean =
    lines.any { it.startsWith("|") && it.length > columns }

/** The first cell of each row of a [table], and below it the others behind the names of their columns. */
private fun list(table: List<String>, columns: Int): List<String> {
    val rows = table.filterIndexed { k, _ -> k != RULE }.map { line ->
        line.removeSurrounding("|").split(" | ").map { it.trim() }
    }
    val names = rows[0]
    val width = names.drop(1).maxOfOrNull { it.length } ?: 0
    return rows.drop(1).flatMap { cells ->
        wrapped(cells[0], columns) + cells.indices.drop(1).filter { cells[it].isNotEmpty() }.flatMap {
            val line = "  ${names[it].padEnd(width)}  ${cells[it]}"
            if (line.length <= columns) listOf(line) else listOf("  ${names[it]}", "    ${cells[it]}")
        }
    }
}

/** The line of a table that separates its head. */
private const val RULE = 1
