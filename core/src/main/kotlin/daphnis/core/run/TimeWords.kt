package daphnis.core.run

import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.ScenarioParts
import daphnis.core.table.Dimension
import daphnis.core.table.UnitsOfDimensions
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.PI

/**
 * Times of a run in messages: with their unit where it has a name, and in orbits too where there are any.
 *
 * @param omega angular speed of Hill's frame in the run's units; null without one
 * @param unit null where it has no name
 */
internal class TimeWords(private val omega: Double?, private val unit: String?) {
    /** `time 4781.86 s (0.1 orbits)`. Few digits: who wants a state that is there takes its step. */
    fun text(time: Double): String {
        val plain = "time ${short(time)}${unit?.let { " $it" }.orEmpty()}"
        return if (omega == null) plain else "$plain (${short(time * omega / (2 * PI))} orbits)"
    }

    private fun short(number: Double): String = if (number.isFinite()) {
        BigDecimal(number).round(MathContext(DIGITS)).stripTrailingZeros().toPlainString()
    } else {
        "$number"
    }

    companion object {
        private const val DIGITS = 7

        /** Where nothing is known of units, as in a [Program]. */
        val PLAIN = TimeWords(null, null)

        /** Those of [scenario], which is called [source] in messages; null for a run without one. */
        fun of(scenario: ScenarioParts?, source: String): TimeWords {
            if (scenario == null) return PLAIN
            val unit = UnitsOfDimensions(scenario.units).nameOrNull(Dimension.TIME)
            return TimeWords(FrameSetup.angularSpeed(scenario, source), unit)
        }
    }
}
