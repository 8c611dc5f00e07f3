package daphnis.analysis.report

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ReportTextTest {
    @Test
    fun `a number has the digits that its error leaves`() {
        assertEquals("3.718 ± 0.012", ReportText.withError(3.71833, 0.0123))
        assertEquals("26.8 ± 1.4", ReportText.withError(26.81, 1.37))
        assertEquals("−0.50 ± 0.20", ReportText.withError(-0.5, 0.2))
        assertEquals("(3.34 ± 0.12) · 10⁻⁴", ReportText.withError(3.342e-4, 1.2e-5))
        assertEquals("–", ReportText.withError(Double.NaN, 1.0))
        assertEquals("2.500", ReportText.withError(2.5, Double.NaN))
        assertEquals("1.000", ReportText.withError(1.0000000000000013, 2e-16)) { "round-off is no error" }
        assertEquals("(1.00000000 ± 0.00000000)", ReportText.withError(1.0, 1e-10).substringBefore(" ·"))
        assertEquals("25093", ReportText.plain(25093.0797))
    }

    @Test
    fun `powers of ten are written one way, in tables and in running text`() {
        assertEquals("1.948 · 10⁻⁴", ReportText.plain(1.948e-4))
        assertEquals("3.00 · 10⁻⁴", ReportText.short(3e-4))
        assertEquals("−1.20 · 10¹²", ReportText.short(-1.2e12))
        assertEquals("1.000 · 10⁻³", ReportText.plain(0.00099996))
        assertEquals("1.00 · 10⁵", ReportText.plain(1e5, 3))
        for (exponent in -20..20) {
            val text = ReportText.short(1.234 * Math.pow(10.0, exponent.toDouble()))
            assertEquals(false, 'e' in text || 'E' in text) { text }
        }
    }

    @Test
    fun `whole numbers stay whole, and nothing is written as minus zero`() {
        assertEquals("12", ReportText.plain(12.0))
        assertEquals("107592", ReportText.short(107592.3))
        assertEquals("0", ReportText.short(-0.0))
        assertEquals("0", ReportText.plain(-0.0))
        assertEquals("0.500", ReportText.short(0.5))
        assertEquals("1235", ReportText.short(1234.6))
        assertEquals("∞", ReportText.short(Double.POSITIVE_INFINITY))
    }

    @Test
    fun `one is singular`() {
        assertEquals("1 sphere", ReportText.count(1, "sphere"))
        assertEquals("0 spheres", ReportText.count(0, "sphere"))
        assertEquals("2 spheres", ReportText.count(2, "sphere"))
    }

    @Test
    fun `both ends of a span are in one notation`() {
        assertEquals("(0.72 to 1.91) · 10⁶", ReportText.span(717279.0, 1.9127e6))
        assertEquals("0 to 1.91 · 10⁶", ReportText.span(0.0, 1.9127e6))
        assertEquals("3.75 to 10", ReportText.span(3.75, 10.0))
        assertEquals("10", ReportText.span(10.0, 10.0))
    }
}
