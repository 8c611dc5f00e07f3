package daphnis.analysis.table

import java.util.Locale
import kotlin.math.abs

/** Powers of ten as characters: `1.948 · 10⁻⁴`, the same in tables, in text and at axes. */
public object PowersOfTen {
    /** From here on, and below [SMALL], numbers are written with a power. */
    public const val LARGE: Double = 1e5

    /** Smallest size, zero aside, that is written without a power. */
    public const val SMALL: Double = 1e-3
    private const val SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹"

    /** [value] with one digit before the point and [decimals] behind it. */
    @JvmStatic
    public fun text(value: Double, decimals: Int): String {
        // Rounding may lift the last digit into the next power, 9.9996 to 10.000: the formatter of the language knows.
        val text = String.format(Locale.ROOT, "%.${decimals}e", value)
        return minus(text.substringBefore('e')) + times(text.substringAfter('e').toInt())
    }

    /** ` · 10⁻⁴`. */
    @JvmStatic
    public fun times(exponent: Int): String = " · " + power(exponent)

    /** `10⁻⁴`. */
    @JvmStatic
    public fun power(exponent: Int): String {
        val digits = abs(exponent).toString().map { SUPERSCRIPTS[it - '0'] }.joinToString("")
        return "10" + (if (exponent < 0) "⁻" else "") + digits
    }

    /** The sign of subtraction in place of the hyphen. */
    @JvmStatic
    public fun minus(text: String): String = text.replace("-", "−")
}
