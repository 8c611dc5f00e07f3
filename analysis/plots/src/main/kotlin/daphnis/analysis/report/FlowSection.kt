package daphnis.analysis.report

import daphnis.analysis.flow.FlowField
import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table

/** Lines of the mean flow of a sheared box without Hill's frame. */
internal class FlowSection(private val study: Study) : Section {
    private val units = study.units
    private val field = FlowField(CELLS, CELLS)
    private var sums = DoubleArray(0)

    override val heading = "Mean flow"
    override val over = study.overAverages
    override val applies = !study.isRing && study.input.hasVelocities && study.last.boundary.meanFlow != null
    override val leftOut =
        if (study.isCompact) study.tooFew() else "the box is more than twenty times as long as wide"

    override fun add(state: State) {
        if (leftOut != null) return
        val more = field.of(state)
        if (sums.isEmpty()) sums = more else for (k in more.indices) sums[k] += more[k]
    }

    override fun write(page: ReportPage) {
        val f = field
        val vx = f.mean(sums, 0)
        val vy = f.mean(sums, 1)
        val figure = Chart.paths(lines(vx, vy), study.lengthAxis("x"), study.lengthAxis("y"))
        study.draw(
            page,
            figure,
            "flow-lines",
            "lines of the mean flow",
            "Lines of the mean flow through the middle of the box, averaged over z too; " +
                "where the flow is slow the scatter of few particles turns them.",
            HEIGHT,
        )
        val box = study.boxes.mean
        val cells = f.nx * f.ny
        Table(
            "flow",
            listOf(
                Column("x", units.length, DoubleArray(cells) { box.lowerX + (it / f.ny + 0.5) / f.nx * box.length(0) }),
                Column("y", units.length, DoubleArray(cells) { box.lowerY + (it % f.ny + 0.5) / f.ny * box.length(1) }),
                Column("vx", units.speed, vx),
                Column("vy", units.speed, vy),
            ),
        ).write(study.tables)
    }

    private fun lines(vx: DoubleArray, vy: DoubleArray): List<Curve> {
        val f = field
        val backX = DoubleArray(vx.size) { -vx[it] }
        val backY = DoubleArray(vy.size) { -vy[it] }
        val box = study.boxes.mean
        return (0 until f.ny).map { j ->
            // Forward and backward from the middle.
            val ahead = f.line(vx, vy, f.nx / 2.0, j + 0.5, 2 * f.nx)
            val behind = f.line(backX, backY, f.nx / 2.0, j + 0.5, 2 * f.nx)
            val line = DoubleArray(behind.size) { behind[(behind.size / 2 - 1 - it / 2) * 2 + it % 2] } + ahead
            Curve(
                "$j",
                DoubleArray(line.size / 2) { box.lowerX + line[2 * it] / f.nx * box.length(0) },
                DoubleArray(line.size / 2) { box.lowerY + line[2 * it + 1] / f.ny * box.length(1) },
            )
        }
    }

    private companion object {
        const val CELLS = 24
        const val HEIGHT = 420
    }
}
