package daphnis.analysis.report

import daphnis.analysis.table.PowersOfTen
import daphnis.analysis.table.PowersOfTen.LARGE
import daphnis.analysis.table.PowersOfTen.SMALL
import daphnis.analysis.table.PowersOfTen.minus
import java.util.Locale
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/** Numbers as the report writes them, one way everywhere: `−0.0123`, `1.948 · 10⁻⁴`, `3.72 ± 0.12`, `1 sphere`. */
internal object ReportText {
    private const val MOST_DECIMALS = 8

    /** An error below this part of the number is that of its arithmetic: a sum over runs in which all is the same. */
    private const val ROUND_OFF = 1e-12

    /** [value] in [digits] significant digits; whole numbers in full. `–` for NaN. */
    fun plain(value: Double, digits: Int = 4): String {
        val size = abs(value)
        return when {
            value.isNaN() -> "–"
            value.isInfinite() -> if (value > 0) "∞" else "−∞"
            value == 0.0 -> "0"
            value == round(value) && size < LARGE -> minus(value.toLong().toString())
            size < SMALL || size >= LARGE -> PowersOfTen.text(value, digits - 1)
            else -> {
                val decimals = digits - 1 - floor(log10(size)).toInt()
                minus(String.format(Locale.ROOT, "%.${decimals.coerceAtLeast(0)}f", value))
            }
        }
    }

    /** A number in few digits, for running text; in whole ones below a million. */
    fun short(value: Double): String {
        val size = abs(value)
        val whole = size < 10 * LARGE && (value == round(value) || size >= LARGE)
        return if (whole) minus(round(value).toLong().toString()) else plain(value, 3)
    }

    /** From [first] to [last] in few digits, in one notation: `12 to 40`, `(0.72 to 1.91) · 10⁶`. */
    fun span(first: Double, last: Double): String {
        if (first == last) return short(first)
        val size = maxOf(abs(first), abs(last))
        if (size < 10 * LARGE || first == 0.0 || last == 0.0) return "${short(first)} to ${short(last)}"
        val power = floor(log10(size)).toInt()
        fun part(value: Double) = minus(String.format(Locale.ROOT, "%.2f", value / 10.0.pow(power)))
        return "(${part(first)} to ${part(last)})${PowersOfTen.times(power)}"
    }

    /** A number with as many digits as its [error] leaves meaningful; without one, or with round-off, as [plain]. */
    fun withError(value: Double, error: Double): String {
        if (value.isNaN()) return "–"
        if (!value.isFinite() || error <= ROUND_OFF * abs(value) || !error.isFinite()) return plain(value)
        val digits = 1 - floor(log10(error)).toInt()
        val size = abs(value)
        if (size >= SMALL && size < LARGE && digits <= MOST_DECIMALS) {
            val d = digits.coerceAtLeast(0)
            return minus(String.format(Locale.ROOT, "%.${d}f ± %.${d}f", value, error))
        }
        val exponent = floor(log10(maxOf(size, error))).toInt()
        val scale = 10.0.pow(exponent)
        val d = (exponent + digits).coerceIn(0, MOST_DECIMALS)
        return minus(String.format(Locale.ROOT, "(%.${d}f ± %.${d}f)", value / scale, error / scale)) +
            PowersOfTen.times(exponent)
    }

    /** `1 sphere`, `2 spheres`. */
    fun count(n: Int, what: String): String = if (n == 1) "1 $what" else "$n ${what}s"
}
