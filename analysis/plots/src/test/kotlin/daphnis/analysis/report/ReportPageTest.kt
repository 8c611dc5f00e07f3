package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import java.nio.file.Path

class ReportPageTest {
    @Test
    fun `text is escaped`() {
        val page = ReportPage("a < b & \"c\"")
        page.section("x > y", "over <i>")
        page.paragraph("<b>")
        page.list(listOf("<u>"))
        val html = page.html("")
        assertTrue(
            "&lt;b&gt;" in html &&
                "a &lt; b &amp; &quot;c&quot;" in html &&
                "x &gt; y" in html &&
                "&lt;i&gt;" in html &&
                "&lt;u&gt;" in html,
        )
    }

    @Test
    fun `sections have anchors of their own, listed at the top`() {
        val page = ReportPage("run")
        for (heading in listOf("Mean flow", "Mean flow", "σ")) page.section(heading)
        val html = page.html("")
        for (id in listOf("mean-flow", "mean-flow-2", "section")) {
            assertEquals(1, html.split("<h2 id=\"$id\">").size - 1) { id }
            assertTrue("<a href=\"#$id\">" in html) { id }
        }
    }

    @Test
    fun `the page is titled by its scenario, follows the reader's colours, prints, and scrolls what is wide`() {
        val page = ReportPage("ring-patch")
        page.svg("<svg/>", "a chart", "caption")
        page.numbers(listOf(NumberRow("ν", 1.0, 0.1, "m^2/s")))
        val html = page.html("a patch")
        assertTrue("<title>ring-patch: daphnis report</title>" in html)
        assertTrue(
            "color-scheme:light dark" in html &&
                "@media screen and (prefers-color-scheme:dark)" in html &&
                "@media print" in html,
        )
        assertTrue("name=\"viewport\" content=\"width=device-width" in html)
        for (wide in listOf(
            "<img",
            "<table",
        )) {
            assertTrue(Regex("<div class=\"scroll\" tabindex=\"0\"[^>]*>$wide").containsMatchIn(html)) {
                wide
            }
        }
        assertTrue("alt=\"a chart\"" in html && "m²/s" in html && "1.00 ± 0.10" in html)
        assertFalse("<script" in html)
    }

    @Test
    fun `a number without an error says why, and not how long a time it would take, which is not known`() {
        val rows = NumberRows().also { it.average("a", "a number", BlockAverage(2.0, Double.NaN, 30, 0.22), "") }
        val said = ReportPage("run").also { it.numbers(rows.list()) }.html("")
        assertTrue("worth eight independent ones.<" in said && "times the time" !in said) { said }
    }

    @Test
    fun `commands take a directory as one word, and never the run's own name for a new run`() {
        assertEquals("runs/ring", RunSection.quoted(Path.of("runs/ring")))
        assertEquals("'my runs/it'\\''s'", RunSection.quoted(Path.of("my runs/it's")))
        assertEquals(Path.of("runs/ring-again"), RunSection.besides(Path.of("runs/ring")))
        assertEquals(Path.of("again"), RunSection.besides(Path.of(".")))
        assertEquals(Path.of("again"), RunSection.besides(Path.of("..")))
    }
}
