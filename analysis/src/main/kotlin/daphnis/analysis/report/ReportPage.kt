package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import java.util.Base64
import java.util.Locale

/** A row of the table of numbers; [error] NaN for none, either because there is none or, [isUncertain], because too few independent states tell it. */
internal class NumberRow(
    val what: String,
    val value: Double,
    val error: Double,
    val unit: String,
    val reference: Reference? = null,
    val note: String = "",
    val isUncertain: Boolean = false,
) {
    companion object {
        /** The average [a] in [unit]. */
        fun of(what: String, a: BlockAverage, unit: String, reference: Reference? = null, note: String = "") =
            NumberRow(what, a.mean, a.error, unit, reference, note, !a.isLevelled && !a.mean.isNaN())
    }
}

/** One HTML page with everything inside: pictures as data, style in the head, no script. */
internal class ReportPage(private val title: String) {
    private val body = StringBuilder()
    private val contents = ArrayList<Pair<String, String>>()

    fun section(heading: String) {
        val id = heading.lowercase().replace(Regex("[^a-z0-9]+"), "-").trim('-')
        contents += id to heading
        body.append("<h2 id=\"$id\">${escape(heading)}</h2>\n")
    }

    fun paragraph(text: String) {
        body.append("<p>${escape(text)}</p>\n")
    }

    fun svg(svg: String, alt: String, caption: String) = image("image/svg+xml", svg.toByteArray(Charsets.UTF_8), alt, caption)

    fun png(png: ByteArray, alt: String, caption: String) = image("image/png", png, alt, caption)

    private fun image(type: String, bytes: ByteArray, alt: String, caption: String) {
        val data = Base64.getEncoder().encodeToString(bytes)
        body.append("<figure><img alt=\"${escape(alt)}\" src=\"data:$type;base64,$data\"><figcaption>${escape(caption)}</figcaption></figure>\n")
    }

    fun parameters(rows: List<Pair<String, String>>) {
        body.append("<div class=\"scroll\"><table class=\"parameters\">\n")
        for ((name, value) in rows) body.append("<tr><th scope=\"row\">${escape(name)}</th><td>${escape(value)}</td></tr>\n")
        body.append("</table></div>\n")
    }

    fun numbers(rows: List<NumberRow>) {
        val compared = rows.any { it.reference != null }
        body.append("<div class=\"scroll\"><table class=\"numbers\"><thead><tr><th>quantity</th><th>value</th><th>unit</th>")
        if (compared) body.append("<th>reference</th><th>difference</th><th>source</th>")
        body.append("</tr></thead><tbody>\n")
        for (row in rows) {
            body.append("<tr><td>${escape(row.what)}${if (row.note.isEmpty()) "" else " <small>${escape(row.note)}</small>"}</td>")
            body.append("<td class=\"n\">${withError(row.value, row.error)}${if (row.isUncertain) "<sup>?</sup>" else ""}</td><td>${unit(row.unit)}</td>")
            if (compared) {
                val reference = row.reference
                if (reference == null) {
                    body.append("<td></td><td></td><td></td>")
                } else {
                    val difference = String.format(
                        Locale.ROOT,
                        "%+.1f %%",
                        100 * (row.value / reference.value - 1),
                    ).replace("-", "−").replace("−0.0", "0.0").replace("+0.0", "0.0")
                    body.append("<td class=\"n\">${plain(reference.value)}</td><td class=\"n\">$difference</td><td>${escape(reference.source)}</td>")
                }
            }
            body.append("</tr>\n")
        }
        body.append("</tbody></table></div>\n")
        if (rows.any { it.isUncertain }) body.append("<p><small><sup>?</sup> ${escape(UNCERTAIN)}</small></p>\n")
    }

    fun commands(lines: List<String>) {
        body.append("<pre>${escape(lines.joinToString("\n"))}</pre>\n")
    }

    fun html(subtitle: String): String {
        val nav = contents.joinToString(" · ") { (id, heading) -> "<a href=\"#$id\">${escape(heading)}</a>" }
        return """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>${escape(title)}</title>
<style>
:root{color-scheme:light}
*{box-sizing:border-box}
body{margin:0 auto;max-width:62rem;padding:1.5rem 1.25rem 4rem;font:16px/1.55 system-ui,-apple-system,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif;color:#1c2430;background:#fff}
h1{font-size:1.9rem;line-height:1.2;margin:.2rem 0 .3rem}
h2{font-size:1.25rem;margin:2.4rem 0 .6rem;padding-top:.8rem;border-top:1px solid #d9dee5}
.lead{color:#4a5564;margin:0 0 1rem}
nav{font-size:.92rem;line-height:1.9}
a{color:#1f4e79}
figure{margin:1.1rem 0}
img{display:block;max-width:100%;height:auto;margin:0 auto}
figcaption{font-size:.9rem;color:#4a5564;margin-top:.4rem}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-size:.94rem}
th,td{text-align:left;padding:.28rem .9rem .28rem 0;vertical-align:top;border-bottom:1px solid #eceff3}
thead th{border-bottom:1px solid #9aa5b1;font-weight:600}
.parameters th{font-weight:500;color:#4a5564;white-space:nowrap}
.parameters td{overflow-wrap:anywhere}
.n{font-variant-numeric:tabular-nums;white-space:nowrap}
small{color:#4a5564}
pre{background:#f4f6f8;padding:.8rem 1rem;overflow-x:auto;font-size:.9rem;border-radius:4px}
@media print{nav{display:none}h2{break-after:avoid}figure{break-inside:avoid}}
</style></head>
<body><header><h1>${escape(title)}</h1><p class="lead">${escape(subtitle)}</p><nav>$nav</nav></header>
<main>
$body</main></body></html>
"""
    }

    companion object {
        fun escape(text: String): String = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")

        /** Powers raised: `m^2/s` reads m²/s. */
        private fun unit(text: String): String = escape(text).replace("^2", "²").replace("^3", "³").replace("^-1", "⁻¹")

        /** A number with as many digits as its error leaves meaningful. */
        fun withError(value: Double, error: Double): String {
            if (value.isNaN()) return "–"
            if (error.isNaN() || error == 0.0 || !error.isFinite()) return plain(value)
            val digits = 1 - Math.floor(Math.log10(error)).toInt()
            val size = Math.abs(value)
            if (size >= SMALL && size < LARGE && digits <= 8) {
                val d = digits.coerceAtLeast(0)
                return minus(String.format(Locale.ROOT, "%.${d}f ± %.${d}f", value, error))
            }
            val exponent = Math.floor(Math.log10(maxOf(size, error))).toInt()
            val scale = Math.pow(10.0, exponent.toDouble())
            val d = (exponent + digits).coerceIn(0, 8)
            return minus(String.format(Locale.ROOT, "(%.${d}f ± %.${d}f)", value / scale, error / scale)) + " · 10<sup>${minus(exponent.toString())}</sup>"
        }

        fun plain(value: Double): String {
            if (value.isNaN()) return "–"
            val size = Math.abs(value)
            if (value == Math.rint(value) && size < LARGE) return minus(value.toLong().toString())
            if (size >= SMALL &&
                size < LARGE
            ) {
                return minus(String.format(Locale.ROOT, "%.4g", value).let { if ('e' in it) String.format(Locale.ROOT, "%.0f", value) else it })
            }
            if (value == 0.0) return "0"
            val exponent = Math.floor(Math.log10(size)).toInt()
            return minus(String.format(Locale.ROOT, "%.3f", value / Math.pow(10.0, exponent.toDouble()))) + " · 10<sup>${minus(exponent.toString())}</sup>"
        }

        private fun minus(text: String) = text.replace("-", "−")

        private const val UNCERTAIN = "No error can be given: the states that are averaged are worth fewer than eight independent ones."
        private const val SMALL = 1e-3
        private const val LARGE = 1e5
    }
}
