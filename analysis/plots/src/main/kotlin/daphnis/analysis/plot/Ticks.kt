package daphnis.analysis.plot

import daphnis.analysis.table.PowersOfTen
import java.util.Locale
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/** Where an axis is marked and what stands there, in the report's way of writing numbers. */
internal class Ticks(val places: List<Double>, val labels: List<String>) {
    companion object {
        const val WANTED = 8
        private const val FEWEST = 3
        private const val FEW = 5
        private const val NEARLY = 1e-9
        private val LOG_STEPS = listOf(listOf(1), listOf(1, 3), listOf(1, 2, 5), (1..9).toList())

        /** About [wanted] round places from [low] to [high]. */
        fun linear(low: Double, high: Double, wanted: Int = WANTED): Ticks {
            if (!(low < high)) return Ticks(listOf(low), listOf(label(low, 0, 3)))
            val step = roundStep((high - low) / wanted)
            val places = (ceil(low / step - NEARLY).toLong()..floor(high / step + NEARLY).toLong()).map { it * step }
            val largest = maxOf(abs(low), abs(high))
            val stepPower = floor(log10(step) + NEARLY).toInt()
            if (largest >= PowersOfTen.SMALL && largest < PowersOfTen.LARGE) {
                return Ticks(places, places.map { label(it, 0, maxOf(0, -stepPower)) })
            }
            val power = floor(log10(largest)).toInt()
            return Ticks(places, places.map { label(it, power, maxOf(0, power - stepPower)) })
        }

        /** Round places from 0 to the first that is not below [high], which is positive. */
        fun linearFromZero(high: Double): Ticks {
            val step = roundStep(high / WANTED)
            return linear(0.0, ceil(high / step - NEARLY) * step)
        }

        /**
         * Powers of ten from [low] to [high], both positive; with a few steps between when they are near each other,
         * and where these are fewer than two, places as on a linear axis.
         */
        fun logarithmic(low: Double, high: Double): Ticks {
            // A lag of one orbit may be 1.0000000000000002 of them.
            val from = low * (1 - NEARLY)
            val to = high * (1 + NEARLY)
            val first = floor(log10(from)).toInt()
            val last = ceil(log10(to)).toInt()
            val stride = ceil((last - first) / WANTED.toDouble()).toInt().coerceAtLeast(1)
            val tries = LOG_STEPS.map { steps ->
                (first..last step stride).flatMap { k -> steps.map { it to k } }
                    .filter { (m, k) -> m * 10.0.pow(k) in from..to }
            }
            val marks = tries.firstOrNull { it.size >= FEWEST } ?: tries.last()
            if (marks.size < 2 && low < high) return linear(low, high, FEW)
            return Ticks(marks.map { (m, k) -> m * 10.0.pow(k) }, marks.map { (m, k) -> logLabel(m, k) })
        }

        private fun roundStep(wanted: Double): Double {
            val power = 10.0.pow(floor(log10(wanted)))
            return power * listOf(1.0, 2.0, 5.0, 10.0).first { it * power >= wanted * (1 - NEARLY) }
        }

        private fun label(value: Double, power: Int, decimals: Int): String {
            if (value == 0.0) return "0"
            val text = PowersOfTen.minus(String.format(Locale.ROOT, "%.${decimals}f", value / 10.0.pow(power)))
            return if (power == 0) text else text + PowersOfTen.times(power)
        }

        private fun logLabel(mantissa: Int, power: Int): String {
            val value = mantissa * 10.0.pow(power)
            return when {
                value >= PowersOfTen.SMALL && value < PowersOfTen.LARGE ->
                    String.format(Locale.ROOT, "%.${maxOf(0, -power)}f", round(value * 1e3) / 1e3)
                mantissa == 1 -> PowersOfTen.power(power)
                else -> "$mantissa${PowersOfTen.times(power)}"
            }
        }
    }
}
