package daphnis.analysis.report

import daphnis.analysis.series.SeriesTable
import daphnis.analysis.table.UnitNames
import daphnis.core.run.SeriesColumns
import daphnis.core.table.Column
import kotlin.math.abs

/**
 * A number that tells of a run as a whole.
 *
 * @property key lower case, the same in every version; as in `tables/numbers.csv`
 * @property name what the report calls it
 * @property unit of [value], with powers as in `r^2`; empty for a pure number
 * @property value NaN when it has no meaning for this run
 * @property isSteady false for an average over a time in which the run drifts
 */
public class ReportNumber @JvmOverloads constructor(
    public val key: String,
    public val name: String,
    public val unit: String,
    public val value: Double,
    public val isSteady: Boolean = true,
) {
    /** False for an average over a time with too few rows to tell whether the run drifts. */
    public var isJudged: Boolean = true
        private set

    internal constructor(
        key: String,
        name: String,
        unit: String,
        value: Double,
        isSteady: Boolean,
        isJudged: Boolean,
    ) : this(key, name, unit, value, isSteady) {
        this.isJudged = isJudged
    }

    public companion object {
        private const val AT_END = "end_"
        private const val ROUND_OFF = 1e-12
        private val PLACE = setOf(SeriesColumns.STEP, SeriesColumns.TIME)

        /**
         * The last row of [series], each column but step and time as `end_…`; empty when there is no row. A momentum
         * that is nothing but round-off is 0.
         *
         * @param units of the scenario of the run
         */
        @JvmStatic
        public fun atEnd(series: SeriesTable, units: UnitNames): List<ReportNumber> {
            if (series.size == 0) return emptyList()
            return SeriesColumns.columns.filter { it !in PLACE && it in series }.map {
                val name = "${it.name.replace('_', ' ')} at the end"
                val value = if (it in SeriesColumns.MOMENTUM) momentum(series, it) else series[it].last()
                ReportNumber(AT_END + it.name, name, units.of(it.dimension), value)
            }
        }

        private fun momentum(series: SeriesTable, column: Column): Double {
            val momentum = series[column].last()
            if (SeriesColumns.KINETIC_ENERGY !in series || SeriesColumns.RMS_COMPONENT_SPEED !in series) return momentum
            // Of all spheres if they went one way: 2 E = 3 M v².
            val speed = series[SeriesColumns.RMS_COMPONENT_SPEED].last()
            val largest = 2 * series[SeriesColumns.KINETIC_ENERGY].last() / (3 * speed)
            return if (abs(momentum) <= ROUND_OFF * largest) 0.0 else momentum
        }
    }
}
