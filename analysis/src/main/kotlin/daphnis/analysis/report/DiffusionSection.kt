package daphnis.analysis.report

import daphnis.analysis.diffusion.Coordinate
import daphnis.analysis.diffusion.Diffusion
import daphnis.analysis.diffusion.MeanSquareDisplacement
import daphnis.analysis.diffusion.Trajectories
import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.Figures
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.format.Frame
import java.nio.file.Path
import kotlin.math.PI

/** The section on self-diffusion, from the states from a time on; empty where too few states, or no axis to diffuse along, leave nothing to say. */
internal class DiffusionSection(private val input: AnalysisInput, from: Double, private val meanRadius: Double) {
    private val units = input.units
    private val omega = input.omega
    private val chosen = chosen(from)
    private val last = input.frame(input.size - 1)
    private val coordinates = coordinates(last, input.state(input.size - 1).boundary)
    private val isExpected = chosen.size >= MeanSquareDisplacement.FEWEST_TIMES && coordinates.isNotEmpty()
    private val displacement = if (isExpected && last.image != null) follow() else null

    /** D along each coordinate that counts, and their mean. */
    fun rows(): List<NumberRow> {
        val d = displacement ?: return emptyList()
        if (omega != null) return listOfNotNull(row("self-diffusion of guiding centres D_X", d.diffusion(0), "r² Ω", meanRadius * meanRadius * omega))
        val all = coordinates.indices.toList().toIntArray()
        val mean = d.diffusion(*all) ?: return emptyList()
        val along = all.map { row("self-diffusion D_${coordinates[it].name}", d.diffusion(it, from = mean.from), units.viscosity, 1.0) }
        return (if (all.size == 1) along else listOf(row("self-diffusion D", mean, units.viscosity, 1.0)) + along).filterNotNull()
    }

    private fun row(what: String, d: Diffusion?, unit: String, scale: Double): NumberRow? {
        if (d == null) return null
        val orbit = if (omega != null) 2 * PI / omega else 1.0
        val time = if (omega != null) "orbits" else units.time
        val lags = "slope over lags from ${ReportText.short(d.from / orbit)} to ${ReportText.short(d.to / orbit)} $time"
        return NumberRow(what, d.value / scale, d.error / scale, unit, note = lags)
    }

    fun write(page: ReportPage, plots: Path, tables: Path) {
        if (!isExpected) return
        if (displacement == null && input.directory == null) return
        page.section("Diffusion")
        if (displacement == null) {
            page.paragraph("The snapshots do not say how often particles crossed the box, as those of older versions; there is no displacement without it.")
            return
        }
        val d = displacement
        val orbit = if (omega != null) 2 * PI / omega else 1.0
        val time = if (omega != null) "orbits" else units.time
        val lag = DoubleArray(d.lag.size) { d.lag[it] / orbit }
        val curves = coordinates.mapIndexed { c, coordinate -> Curve(coordinate.name, lag, d.mean(c), d.error(c)) }
        val figure = Chart.lines(curves, "lag [$time]", "mean square displacement [${units.length}²]", logX = true, logY = true)
        page.svg(
            Figures.write(figure, plots, "mean-square-displacement", Chart.WIDTH, Chart.HEIGHT),
            "mean square displacements",
            "Mean square displacements over all origins, without images and against the centre of mass. ${caption(d)} Bars are one standard error.",
        )
        Table(
            "mean-square-displacement",
            listOf(Column("lag", time, lag)) +
                curves.flatMap { listOf(Column("msd_${it.name}", "${units.length}^2", it.y), Column("msd_${it.name}_error", "${units.length}^2", it.error!!)) },
        ).write(tables)
    }

    private fun caption(d: MeanSquareDisplacement): String {
        val found = d.diffusion(*(if (omega != null) intArrayOf(0) else coordinates.indices.toList().toIntArray()))
        val said = if (found == null) "They do not become linear in time within these lags: no coefficient." else "D is half the slope where they are linear."
        return if (omega != null) "X is the guiding centre; x swings about it once an orbit. $said" else said
    }

    private fun follow(): MeanSquareDisplacement? {
        // Particles only ever leave, so those that are there at the end were there throughout.
        val there = last.id.filter { it < (input.scenario?.firstBody ?: Int.MAX_VALUE) }
        val every = (there.size + MOST_PARTICLES - 1) / MOST_PARTICLES
        val ids = there.filterIndexed { k, _ -> k % maxOf(1, every) == 0 }.toIntArray()
        if (ids.size < 2) return null
        val trajectories = Trajectories(coordinates, ids)
        for (k in chosen) {
            val frame = input.frame(k)
            if (frame.image == null) return null
            trajectories.add(frame)
        }
        return MeanSquareDisplacement(trajectories)
    }

    private fun chosen(from: Double): List<Int> {
        val late = input.times.indices.filter { input.times[it] >= from }
        val every = (late.size + MOST_STATES - 1) / MOST_STATES
        return late.filterIndexed { k, _ -> k % maxOf(1, every) == 0 }
    }

    private fun coordinates(frame: Frame, boundary: BoundaryConditions): List<Coordinate> = if (omega != null) {
        listOf(Coordinate.GuidingCentre(omega), Coordinate.Position(0))
    } else {
        (0..2).filter { frame.periodic[it] && it != boundary.meanFlow?.flowAxis }.map { Coordinate.Position(it) }
    }

    private companion object {
        /** Bounds on memory: 61 MB, and on time: seconds. */
        const val MOST_PARTICLES = 20_000
        const val MOST_STATES = 128
    }
}
