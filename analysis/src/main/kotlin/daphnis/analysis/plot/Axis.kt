package daphnis.analysis.plot

import java.math.BigDecimal
import java.math.RoundingMode
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow

/** A mark on an axis at [value], with what stands beside it. */
internal class Tick(val value: Double, val label: String)

/**
 * An axis from [low] to [high], which are widened where they are equal.
 *
 * @param logarithmic both ends are positive then
 */
internal class Axis(low: Double, high: Double, private val logarithmic: Boolean) {
    private val from: Double
    private val to: Double

    init {
        val equal = !(high > low)
        from = if (!equal) {
            low
        } else if (logarithmic) {
            low / 2
        } else {
            low - room(low)
        }
        to = if (!equal) {
            high
        } else if (logarithmic) {
            high * 2
        } else {
            high + room(high)
        }
    }

    private fun room(value: Double) = if (value == 0.0) 1.0 else abs(value) / 2

    /** 0 at the low end, 1 at the high one. */
    fun fraction(value: Double): Double = if (logarithmic) log10(value / from) / log10(to / from) else (value - from) / (to - from)

    /** About five marks at round numbers: steps of 1, 2 or 5 times a power of ten, or of a factor when logarithmic. */
    fun ticks(): List<Tick> = if (logarithmic) logarithmicTicks() else linearTicks()

    private fun linearTicks(): List<Tick> {
        val rough = (to - from) / TICKS
        val power = 10.0.pow(floor(log10(rough)))
        val step = STEPS.first { it * power >= rough * (1 - EPSILON) } * power
        val first = ceil(from / step - EPSILON).toLong()
        val last = floor(to / step + EPSILON).toLong()
        val largest = maxOf(abs(from), abs(to))
        return (first..last).map { Tick(it * step, label(it * step, step, largest)) }
    }

    private fun logarithmicTicks(): List<Tick> {
        val decades = log10(to / from)
        // Below two decades also 2 and 5 times the powers; above many, only every so many of them.
        val factors = if (decades < 2) listOf(1, 2, 5) else listOf(1)
        val stride = maxOf(1, ceil(decades / MOST_DECADES).toInt())
        val powers = floor(log10(from)).toInt()..ceil(log10(to)).toInt()
        val values = powers.filter { Math.floorMod(it, stride) == 0 }.flatMap { p -> factors.map { BigDecimal(it).scaleByPowerOfTen(p).toDouble() } }
        val ticks = values.filter { it >= from * (1 - EPSILON) && it <= to * (1 + EPSILON) }
        return if (ticks.size < 2) Axis(from, to, false).linearTicks() else ticks.map { Tick(it, label(it, it, it)) }
    }

    /** As many places as the [step] needs; with an exponent when the [largest] on the axis is very large or small. */
    private fun label(value: Double, step: Double, largest: Double): String {
        if (value == 0.0) return "0"
        val places = -floor(log10(step) + EPSILON).toInt()
        if (largest >= SMALLEST && largest < LARGEST) return BigDecimal(value).setScale(maxOf(0, places), RoundingMode.HALF_EVEN).toPlainString()
        val exponent = floor(log10(abs(value)) + EPSILON).toInt()
        val mantissa = BigDecimal(value).scaleByPowerOfTen(-exponent).setScale(maxOf(0, places + exponent), RoundingMode.HALF_EVEN)
        return "${mantissa.toPlainString()}e$exponent"
    }

    private companion object {
        const val TICKS = 6.0
        const val MOST_DECADES = 8.0
        const val EPSILON = 1e-9
        const val SMALLEST = 1e-3
        const val LARGEST = 1e5
        val STEPS = listOf(1.0, 2.0, 5.0, 10.0)
    }
}
