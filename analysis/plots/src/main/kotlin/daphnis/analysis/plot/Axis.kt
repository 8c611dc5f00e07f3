package daphnis.analysis.plot

import kotlin.math.abs
import kotlin.math.log10

/**
 * An axis from [low] to [high], which are widened where they are equal but for rounding.
 *
 * @param logarithmic both ends are positive then
 */
internal class Axis(low: Double, high: Double, private val logarithmic: Boolean) {
    /** The low end, below [to]. */
    val from: Double
    val to: Double

    init {
        val room = if (high - low > ROUNDING * maxOf(abs(low), abs(high))) {
            0.0
        } else if (low == 0.0) {
            1.0
        } else {
            abs(low) / 2
        }
        from = low - room
        to = if (logarithmic && room > 0) high * 2 else high + room
    }

    /** 0 at the low end, 1 at the high one. */
    fun fraction(value: Double): Double = if (logarithmic) {
        log10(value / from) / log10(to / from)
    } else {
        (value - from) /
            (to - from)
    }

    /** Marks at round places, about [wanted] unless it is logarithmic. */
    fun ticks(wanted: Int = Ticks.WANTED): Ticks =
        if (logarithmic) Ticks.logarithmic(from, to) else Ticks.linear(from, to, wanted)

    private companion object {
        /** Spread over the largest value that a quantity shows which is conserved. */
        const val ROUNDING = 1e-9
    }
}
