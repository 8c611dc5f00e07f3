package daphnis.analysis.report

import daphnis.analysis.insitu.Averages
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames

/**
 * A pure number over bins, with its error, that is 1 for particles without correlation.
 *
 * @property name of its table and its figure
 * @property words what it is, and its [symbol]
 * @property argument what it is over, and the [short] name and the [unit] of that
 */
internal class AveragedCurve(
    private val name: String,
    private val words: String,
    private val symbol: String,
    private val argument: String,
    private val short: String,
    private val unit: String,
) {
    /**
     * Draws number k of [averages] over [x], entry k, with a dashed line upright at [mark], if any, and writes both as
     * a table. A curve of [theory] over the same x stands beside it.
     */
    fun write(
        study: Study,
        page: ReportPage,
        x: DoubleArray,
        averages: Averages,
        caption: String,
        mark: Double? = null,
        theory: Curve? = null,
    ) {
        val all = x.indices.map { averages.average(it) }
        val y = DoubleArray(x.size) { all[it].mean }
        val error = DoubleArray(x.size) { study.judgement.error(all[it]) }
        val label = "$words $symbol"
        val axis = UnitNames.axis(argument, unit)
        // Beside a peak such as that of a whole patch nothing else would be seen.
        val log = Chart.hasPeak(y.asList())
        val curve = listOfNotNull(Curve(label, x, y, error), theory)
        val figure = Chart.lines(curve, axis, label, logY = log, horizontal = 1.0, vertical = mark)
        study.draw(page, figure, name, words, "$caption ${study.judgement.bars()}")
        val columns = listOf(Column(short, unit, x), Column(symbol, "", y), Column("${symbol}_error", "", error))
        Table(name, columns + listOfNotNull(theory?.let { Column("${symbol}_theory", "", it.y) })).write(study.tables)
    }
}
