package daphnis.core.run

import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.ScenarioParts
import daphnis.core.table.Dimension
import daphnis.core.table.UnitsOfDimensions
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.PI
import kotlin.math.abs

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

    private fun short(number: Double): String {
        if (number == 0.0) return "0"
        if (!number.isFinite()) return "$number"
        val rounded = BigDecimal(number).round(MathContext(DIGITS)).stripTrailingZeros()
        return if (abs(number) in LEAST..MOST) rounded.toPlainString() else "$rounded"
    }

    companion object {
        private const val DIGITS = 7

        /** Numbers outside are written with a power of ten. */
        private const val LEAST = 1e-6
        private const val MOST = 1e15

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
