package daphnis.analysis.report

import daphnis.analysis.series.SeriesTable
import daphnis.analysis.table.UnitNames
import daphnis.core.run.SeriesColumns

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
    public companion object {
        private const val AT_END = "end_"
        private val PLACE = setOf(SeriesColumns.STEP, SeriesColumns.TIME)

        /**
         * The last row of [series], each column but step and time as `end_…`; empty when there is no row.
         *
         * @param units of the scenario of the run
         */
        @JvmStatic
        public fun atEnd(series: SeriesTable, units: UnitNames): List<ReportNumber> {
            if (series.size == 0) return emptyList()
            return SeriesColumns.columns.filter { it !in PLACE && it in series }.map {
                val name = "${it.name.replace('_', ' ')} at the end"
                ReportNumber(AT_END + it.name, name, units.of(it.dimension), series[it].last())
            }
        }
    }
}
