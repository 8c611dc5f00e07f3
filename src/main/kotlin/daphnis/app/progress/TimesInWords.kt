package daphnis.app.progress

import daphnis.analysis.table.UnitNames
import daphnis.core.input.UnitsSpec
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.ScenarioParts
import daphnis.core.table.UnitsOfDimensions
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.PI

/**
 * Times of a run as a user reads them, like the axes of its plots: orbits in Hill's frame, else in the units of the
 * scenario, in few digits.
 *
 * @param omega angular speed of Hill's frame; null without one
 * @param units null for a run without a scenario
 */
internal class TimesInWords(omega: Double?, units: UnitsSpec?) {
    private val unit = if (omega == null) UnitNames(units).time else "orbits"

    /** One unit of these times. */
    val size: Double = if (omega == null) 1.0 else 2 * PI / omega

    /** Their unit; empty where it has no name, as in a scenario without lengths in metres. */
    val shortUnit: String = if (unit.startsWith(UnitsOfDimensions.UNNAMED)) "" else unit

    /** `2.4 orbits`. */
    fun text(time: Double): String = UnitNames.amount(number(time), unit)

    /** `2.4 to 40 orbits`. */
    fun span(from: Double, to: Double): String = "${number(from)} to ${text(to)}"

    private fun number(time: Double): String {
        val rounded = BigDecimal(time / size).round(MathContext(DIGITS)).stripTrailingZeros()
        val isPlain = rounded.precision() - rounded.scale() in LEAST_POWER..MOST_POWER
        if (rounded.signum() == 0) return "0"
        return if (isPlain) rounded.toPlainString() else "$rounded"
    }

    companion object {
        private const val DIGITS = 6

        /** Digits before the point of numbers that are written out. */
        private const val MOST_POWER = 12
        private const val LEAST_POWER = -4

        fun of(scenario: ScenarioParts): TimesInWords =
            TimesInWords(FrameSetup.angularSpeed(scenario, scenario.name), scenario.units)
    }
}
