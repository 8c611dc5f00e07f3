package daphnis.analysis.report

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ReportPageTest {
    @Test
    fun `a number has the digits that its error leaves`() {
        assertEquals("3.718 ± 0.012", ReportPage.withError(3.71833, 0.0123))
        assertEquals("26.8 ± 1.4", ReportPage.withError(26.81, 1.37))
        assertEquals("−0.50 ± 0.20", ReportPage.withError(-0.5, 0.2))
        assertEquals("(3.34 ± 0.12) · 10<sup>−4</sup>", ReportPage.withError(3.342e-4, 1.2e-5))
        assertEquals("–", ReportPage.withError(Double.NaN, 1.0))
        assertEquals("25093", ReportPage.plain(25093.0797))
        assertEquals("1.948 · 10<sup>−4</sup>", ReportPage.plain(1.948e-4))
    }

    @Test
    fun `text is escaped`() {
        val page = ReportPage("a < b & \"c\"")
        page.section("x > y")
        page.paragraph("<b>")
        val html = page.html("")
        assertTrue("&lt;b&gt;" in html && "a &lt; b &amp; &quot;c&quot;" in html && "x &gt; y" in html)
    }
}
