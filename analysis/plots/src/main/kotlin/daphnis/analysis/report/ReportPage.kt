package daphnis.analysis.report

import daphnis.analysis.table.UnitNames
import daphnis.core.input.oneLine
import java.util.Base64
import java.util.Locale
import kotlin.math.abs

/**
 * One HTML page with everything inside: pictures as data, style in the head, no script. Sections are numbered in their
 * order and have an anchor each.
 */
internal class ReportPage(private val title: String) {
    private val body = StringBuilder()
    private val contents = ArrayList<Pair<String, String>>()

    /** Begins a section; [over] says what it shows and over which states. */
    fun section(heading: String, over: String = "") {
        val word = heading.lowercase().replace(Regex("[^a-z0-9]+"), "-").trim('-').ifEmpty { "section" }
        val taken = contents.map { it.first }
        val id = generateSequence(1) { it + 1 }.map { if (it == 1) word else "$word-$it" }.first { it !in taken }
        contents += id to heading
        body.append("<h2 id=\"$id\">${escape(heading)}</h2>\n")
        if (over.isNotEmpty()) body.append("<p class=\"over\">${escape(over)}</p>\n")
    }

    fun paragraph(text: String) {
        body.append("<p>${escape(text)}</p>\n")
    }

    fun list(items: List<String>) {
        body.append(items.joinToString("", "<ul>\n", "</ul>\n") { "<li>${escape(it)}</li>\n" })
    }

    /** A chart: on a narrow screen it stays large enough to be read, and scrolls. */
    fun svg(svg: String, alt: String, caption: String) =
        image("image/svg+xml", CHART, svg.toByteArray(Charsets.UTF_8), alt, caption)

    /** A picture: as wide as the screen at most. */
    fun png(png: ByteArray, alt: String, caption: String) = image("image/png", "picture", png, alt, caption)

    private fun image(type: String, kind: String, bytes: ByteArray, alt: String, caption: String) {
        val data = Base64.getEncoder().encodeToString(bytes)
        val image = "<img alt=\"${escape(alt)}\" src=\"data:$type;base64,$data\">"
        val hint = if (kind == CHART) HINT else ""
        val content = "$hint${scrolling(alt, image)}<figcaption>${escape(caption)}</figcaption>"
        body.append("<figure class=\"$kind\">$content</figure>\n")
    }

    /** What may be wider than the screen; by keyboard too. */
    private fun scrolling(what: String, content: String) =
        "<div class=\"scroll\" tabindex=\"0\" role=\"group\" aria-label=\"${escape(what)}\">$content</div>"

    fun parameters(rows: List<Pair<String, String>>) {
        val lines = rows.joinToString("") { (name, value) ->
            "<tr><th scope=\"row\">${escape(name)}</th><td>${escape(value)}</td></tr>\n"
        }
        body.append(scrolling("parameters", "<table class=\"parameters\">\n$lines</table>")).append('\n')
    }

    fun numbers(rows: List<NumberRow>) {
        val compared = rows.any { it.reference != null }
        val headings =
            listOf("quantity", "value", "unit") +
                if (compared) listOf("reference", "difference", "source") else emptyList()
        val head = headings.joinToString("") { "<th scope=\"col\">$it</th>" }
        val lines = rows.joinToString("") { row -> "<tr>${cells(row)}${if (compared) comparison(row) else ""}</tr>\n" }
        val kind = if (compared) "numbers compared" else "numbers"
        val table = "<table class=\"$kind\"><thead><tr>$head</tr></thead><tbody>\n$lines</tbody></table>"
        // With references there are more columns than a narrow screen has room for.
        if (compared) body.append(HINT)
        body.append(scrolling("numbers", table)).append('\n')
        if (compared) body.append("<p><small>${escape(COMPARED)}</small></p>\n")
        for (why in Unknown.entries) {
            val without = rows.filter { it.unknown == why }
            if (without.isEmpty()) continue
            body.append("<p><small><sup>${why.mark}</sup> ${escape(why.sentence)}</small></p>\n")
        }
    }

    private fun cells(row: NumberRow): String {
        val note = if (row.note.isEmpty()) "" else " <small>${escape(row.note)}</small>"
        val value = ReportText.withError(row.value, row.error) + row.unknown?.let { "<sup>${it.mark}</sup>" }.orEmpty()
        val unit = escape(UnitNames.raised(row.unit))
        val meaning = row.key?.let { ReportKeys.of(it) }?.let { " title=\"${escape(it.words())}\"" }.orEmpty()
        return "<td$meaning>${escape(row.name)}$note</td><td class=\"n\">$value</td><td class=\"u\">$unit</td>"
    }

    private fun comparison(row: NumberRow): String {
        val reference = row.reference ?: return "<td></td><td></td><td></td>"
        val value = ReportText.withError(reference.value, reference.bound).replace(" ±", ", good to")
        return "<td class=\"n\">$value</td><td class=\"n\">${difference(row, reference)}</td>" +
            "<td>${escape(reference.source)}</td>"
    }

    /** Nothing of a number without an error: what it differs by may be chance. */
    private fun difference(row: NumberRow, reference: Reference): String {
        if (row.error.isNaN()) return ""
        val difference = row.value - reference.value
        val percent = String.format(Locale.ROOT, "%+.1f %%", 100 * difference / abs(reference.value))
        val errors = if (row.error > 0) String.format(Locale.ROOT, "%+.1f σ, ", difference / row.error) else ""
        val verdict = if (reference.agrees(row.value, row.error)) "within bounds" else "beyond"
        return "${signed(percent)} (${signed(errors)}$verdict)"
    }

    private fun signed(text: String) = text.replace("-", "−").replace("−0.0", "0.0").replace("+0.0", "0.0")

    fun commands(lines: List<String>) {
        body.append("<pre>${escape(lines.joinToString("\n"))}</pre>\n")
    }

    fun html(subtitle: String): String {
        val entries = contents.joinToString("") { (id, heading) -> "<li><a href=\"#$id\">${escape(heading)}</a></li>" }
        return """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark"><title>${escape(title)}: daphnis report</title>
<style>${PageStyle.CSS}</style></head>
<body><header><h1>${escape(title)}</h1><p class="lead">${escape(subtitle)}</p>
<nav aria-label="sections"><ol>$entries</ol></nav></header>
<main>
$body</main></body></html>
"""
    }

    companion object {
        private const val CHART = "chart"

        /** Seen on screens that are narrower than a chart. */
        private const val HINT = "<p class=\"hint\" aria-hidden=\"true\">scroll sideways →</p>"

        private const val COMPARED =
            "References are for runs that agree in all parameters, each to the bound that stands behind it. " +
                "σ is the ± of this run alone; a difference is within or beyond what the bound and three of these " +
                "allow. A number without ± has none."

        /** [text] as it stands in HTML, with its lines; control characters are shown. */
        fun escape(text: String): String = text.split('\n').joinToString("\n", transform = ::oneLine)
            .replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")
    }
}
