package daphnis.analysis.report

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.series.SeriesTable
import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames
import daphnis.core.run.SeriesColumns
import daphnis.core.run.SeriesColumns.PARTICLES
import daphnis.core.run.SeriesColumns.TIME
import daphnis.core.scenario.SourceSpec

/** What came into a run and left it: from the rows of `series.csv`, by source. */
internal class SourcesSection(private val study: Study) : Section {
    private val units = study.units
    private val scale = study.scale
    private val sources: List<SourceSpec> = study.input.scenario?.sources.orEmpty()
    private val series: SeriesTable? =
        study.input.series?.takeIf { s -> s.size >= 2 && sources.indices.all { SeriesColumns.exchanged(it)[0] in s } }

    /** Rows from the time on from which averages are. */
    private val rows: List<Int> =
        series?.let { s -> (0 until s.size).filter { s[TIME][it] >= study.from } }.orEmpty()

    override val heading = "Sources and sinks"
    override val applies: Boolean = sources.isNotEmpty()
    override val over: String get() = "Figures show the whole run, numbers are from time ${study.time(
        study.from,
    )} on. " +
        "Sources are counted as in the scenario, from 0."
    override val leftOut: String? =
        if (series != null) null else "the run has written no time series of two rows; see output.seriesEvery"

    /** What a [column] of the source number [k] grows by from row to row. */
    private fun changes(k: Int, column: Int): DoubleArray {
        val all = series!![SeriesColumns.exchanged(k)[column]]
        return DoubleArray(rows.size - 1) { all[rows[it + 1]] - all[rows[it]] }
    }

    private fun ratio(above: DoubleArray, below: DoubleArray): BlockAverage =
        BlockAverage.of(arrayOf(above, below)) { means -> means[0] / means[1] }

    override fun numbers(): List<NumberRow> {
        val s = series?.takeIf { rows.size > 1 } ?: return emptyList()
        val table = NumberRows()
        val number = DoubleArray(rows.size) { s[PARTICLES][rows[it]] }
        table.average("particles", "number of ${study.bodies} N", BlockAverage.of(number), "")
        if (sources.any { it.takes && it.brings }) fluctuations(table, number)
        val time = DoubleArray(rows.size - 1) { s[TIME][rows[it + 1]] - s[TIME][rows[it]] }
        for ((k, source) in sources.withIndex()) add(table, k, source, time)
        return table.list()
    }

    /** Of what exchanges spheres with a reservoir; where they only come or go the number tells the trend. */
    private fun fluctuations(table: NumberRows, number: DoubleArray) {
        val squares = DoubleArray(number.size) { number[it] * number[it] }
        val spread = BlockAverage.of(arrayOf(number, squares)) { means -> (means[1] - means[0] * means[0]) / means[0] }
        val note = "n kT κ_T of a gas in a box that is all in contact"
        table.average("particle_fluctuations", "⟨δN²⟩/⟨N⟩", spread, "", note)
    }

    private fun add(table: NumberRows, k: Int, source: SourceSpec, time: DoubleArray) {
        val came = changes(k, CAME)
        val left = changes(k, LEFT)
        val refused = changes(k, REFUSED)
        val energy = changes(k, ENERGY)
        val net = DoubleArray(came.size) { came[it] - left[it] }
        table.average("source${k}_rate", "source $k: came less left", ratio(net, time), units.rate)
        val power = units.of("mass length^2/time^3")
        table.average("source${k}_power", "source $k: energy brought", ratio(energy, time), power)
        if (source.takes != source.brings && net.any { it != 0.0 }) {
            table.average("source${k}_energy", "source $k: energy of one", ratio(energy, net), units.energy, KINETIC)
        }
        if (refused.any { it > 0 }) {
            val tried = DoubleArray(came.size) { came[it] + refused[it] }
            table.average("source${k}_refused", "source $k: part that finds no place", ratio(refused, tried), "")
        }
    }

    override fun write(page: ReportPage) {
        val s = series!!
        val stride = maxOf(1, s.size / MOST_POINTS)
        val shown = (0 until s.size).filter { it % stride == 0 || it == s.size - 1 }
        val time = DoubleArray(shown.size) { s[TIME][shown[it]] / scale.time }
        fun column(name: String) = s[name].let { all -> DoubleArray(shown.size) { all[shown[it]] } }
        val number = Curve(study.bodies, time, column(PARTICLES.name))
        val label = UnitNames.axis("time", scale.timeName)
        draw(page, listOf(number), label, "particles", "Number of ${study.bodies} at a time.")
        val exchanged = sources.indices.flatMap { k ->
            listOf(CAME to "came", LEFT to "left", REFUSED to "refused").mapNotNull { (which, word) ->
                val counts = column(SeriesColumns.exchanged(k)[which])
                Curve("source $k: $word", time, counts).takeIf { counts.any { it > 0 } }
            }
        }
        val words = sources.withIndex().joinToString("; ") { (k, source) -> "$k: $source" }
        if (exchanged.isNotEmpty()) {
            val caption = "What came, left and found no place since the start of the run. Sources: $words."
            draw(page, exchanged, label, "exchanged", caption)
        }
        val columns = exchanged.map { Column(it.name.replace(": ", "_").replace(' ', '_'), "", it.y) }
        val all = listOf(Column("time", scale.timeName, time), Column("particles", "", number.y)) + columns
        Table("exchanged", all).write(study.tables)
    }

    private fun draw(page: ReportPage, curves: List<Curve>, label: String, name: String, caption: String) {
        val mark = (study.from / scale.time).takeIf { rows.size < (series?.size ?: 0) }
        val figure = Chart.lines(curves, label, "number of ${study.bodies}", vertical = mark)
        study.draw(page, figure, name, caption.substringBefore('.'), caption)
    }

    companion object {
        private const val CAME = 0
        private const val LEFT = 1
        private const val REFUSED = 2
        private const val ENERGY = 7
        private const val MOST_POINTS = 800

        private const val KINETIC = "kinetic and of rotation"

        /**
         * Whether spheres come or leave: then ids are given again, or those that are in all states are the slow ones, so
         * they say nothing of where spheres go.
         */
        fun areThere(study: Study): Boolean = study.input.scenario?.sources.orEmpty().isNotEmpty()
    }
}
