package daphnis.core.input

import java.math.BigDecimal
import java.math.MathContext
import java.util.Locale

/**
 * Formats numbers of a scenario with units of a convenient size; "length units" and so on where the scenario does not
 * know its units.
 *
 * @param cmPerSecond the unit of speed in cm/s; null where nobody said what it is
 */
public class Quantities(units: UnitsSpec, private val cmPerSecond: Double?) {
    private val si = units.si

    /** A length. */
    public fun length(value: Double): String {
        val metres = (si ?: return plain(value, "length units")).metres * value
        return when {
            metres == 0.0 -> "0 m"
            Math.abs(metres) < CENTIMETRES_BELOW -> number(metres * 100) + " cm"
            Math.abs(metres) < KILOMETRES_FROM -> number(metres) + " m"
            else -> number(metres / 1000) + " km"
        }
    }

    /** A time. */
    public fun time(value: Double): String {
        val seconds = (si ?: return plain(value, "time units")).seconds * value
        return when {
            seconds < 2 * MINUTE -> number(seconds) + " s"
            seconds < 2 * HOUR -> number(seconds / MINUTE) + " min"
            seconds < 4 * DAY -> number(seconds / HOUR) + " h"
            seconds < 2 * YEAR -> number(seconds / DAY) + " days"
            else -> number(seconds / YEAR) + " years"
        }
    }

    /** A speed. */
    public fun speed(value: Double): String =
        if (cmPerSecond != null) number(value * cmPerSecond) + " cm/s" else plain(value, "units of speed")

    /** An angular speed. */
    public fun angularSpeed(value: Double): String = if (si == null) {
        plain(value, "radians per unit of time")
    } else {
        number(value / si.seconds) + " rad/s"
    }

    /** A mass. */
    public fun mass(value: Double): String = if (si == null) {
        plain(value, "mass units")
    } else {
        number(value * si.kilograms) + " kg"
    }

    /** Mass per volume. */
    public fun density(value: Double): String = if (si == null) {
        plain(value, "mass/length^3")
    } else {
        number(value * si.kilograms / (si.metres * si.metres * si.metres)) +
            " kg/m3"
    }

    /** Mass per area. */
    public fun surfaceDensity(value: Double): String = if (si == null) {
        plain(value, "mass/length^2")
    } else {
        number(value * si.kilograms / (si.metres * si.metres)) + " kg/m2"
    }

    /** An acceleration. */
    public fun acceleration(value: Double): String = if (si == null) {
        plain(value, "length/time^2")
    } else {
        number(value * si.metres / (si.seconds * si.seconds)) + " m/s2"
    }

    /** An energy: mass · (length/time)². */
    public fun energy(value: Double): String = if (si == null) {
        plain(value, "units of energy")
    } else {
        number(value * si.kilograms * si.metres * si.metres / (si.seconds * si.seconds)) + " J"
    }

    /** Of a square of a speed, per unit of time. */
    public fun heating(value: Double): String = if (si == null) {
        plain(value, "units of speed^2 per unit of time")
    } else {
        number(value * si.metres * si.metres / (si.seconds * si.seconds * si.seconds)) + " m2/s3"
    }

    /** How often something is. */
    public fun rate(value: Double): String =
        if (si == null) "${number(value)} per unit of time" else number(value / si.seconds) + " per s"

    /** One unit of time; it follows from length and speed, so a scenario does not state it. */
    public fun unitOfTime(): String? = si?.let { "${number(it.seconds)} s" }

    /** A time as a scenario has it, in its units, and in a convenient one where that is another. */
    public fun timeInUnits(value: Double): String {
        val seconds = (si ?: return time(value)).seconds
        val unit = if (seconds == 1.0) "s" else "units of ${number(seconds)} s"
        val plain = "${number(value)} $unit"
        return if (plain == time(value)) plain else "$plain, ${time(value)}"
    }

    /** `2 length units`, but `1 length unit`. */
    private fun plain(value: Double, unit: String): String {
        val number = number(value)
        return "$number ${if (number == "1") unit.replace("units", "unit").replace("radians", "radian") else unit}"
    }

    public companion object {
        /** Four significant digits without a tail of zeros, written out unless very large or very small. */
        @JvmStatic
        public fun number(value: Double): String {
            if (!value.isFinite()) return value.toString()
            val rounded = BigDecimal(value).round(MathContext(DIGITS))
            if (rounded.signum() == 0) return "0"
            val size = Math.abs(value)
            if (size >= PLAIN_FROM && size < PLAIN_BELOW) return rounded.stripTrailingZeros().toPlainString()
            return String.format(Locale.ROOT, "%.3e", value).replace(Regex("\\.?0*e\\+?(-?)0*"), "e$1")
        }

        /** A number of bytes with a decimal prefix. */
        @JvmStatic
        public fun bytes(count: Double): String = when {
            count < 1e3 -> String.format(Locale.ROOT, "%.0f B", count)
            count < 1e6 -> String.format(Locale.ROOT, "%.0f kB", count / 1e3)
            count < 1e9 -> String.format(Locale.ROOT, "%.0f MB", count / 1e6)
            else -> String.format(Locale.ROOT, "%.1f GB", count / 1e9)
        }

        private const val DIGITS = 4
        private const val PLAIN_FROM = 1e-4
        private const val PLAIN_BELOW = 1e7
        private const val CENTIMETRES_BELOW = 0.1
        private const val KILOMETRES_FROM = 1000.0
        private const val MINUTE = 60.0
        private const val HOUR = 3600.0
        private const val DAY = 86_400.0
        private const val YEAR = 3.15576e7
    }
}
