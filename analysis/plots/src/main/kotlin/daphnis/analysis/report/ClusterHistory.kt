package daphnis.analysis.report

import daphnis.analysis.neighbour.ClusterSizes
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.analysis.table.UnitNames

/** How clusters grow: the numbers of [ClusterSizes] by state. */
internal class ClusterHistory(private val study: Study) {
    private val times = ArrayList<Double>()
    private val numbers = ArrayList<DoubleArray>()

    /** Members of the largest of all states, 0 without one. */
    val largest: Double get() = of("largest").maxOrNull() ?: 0.0

    fun add(time: Double, all: DoubleArray) {
        times += time / study.scale.time
        numbers += all
    }

    private fun of(name: String): DoubleArray {
        val k = ClusterSizes.NUMBERS.indexOf(name)
        return DoubleArray(numbers.size) { numbers[it][k] }
    }

    /** Draws them onto [page] where there are several, with [words] on the last state, and writes them as a table. */
    fun write(page: ReportPage, words: String) {
        val x = times.toDoubleArray()
        val names = ClusterSizes.NUMBERS.filter { it != "slope" }
        val columns = names.map { Column(it, "", of(it)) }
        Table("cluster-history", listOf(Column("time", study.scale.timeName, x)) + columns).write(study.tables)
        val inWords = "In the last state the largest has ${ReportText.count(
            of("largest").last().toInt(),
            "sphere",
        )}. $words"
        if (x.size < 2) return page.paragraph(inWords)
        val curves = listOf(
            Curve("largest", x, of("largest")),
            Curve("of a sphere, on average", x, of("mean_size_of_sphere")),
        )
        val figure = Chart.lines(
            curves,
            UnitNames.axis("time", study.scale.timeName),
            "members of a cluster",
            logY = Chart.isWide(curves.flatMap { it.y.asList() }),
        )
        val caption = "The largest cluster, and the size of the cluster of a sphere, Σ s²/Σ s. $inWords"
        study.draw(page, figure, "cluster-history", "sizes of clusters over time", caption)
    }
}
