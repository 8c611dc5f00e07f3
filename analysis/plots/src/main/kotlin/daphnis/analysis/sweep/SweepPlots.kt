package daphnis.analysis.sweep

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.Figures
import daphnis.analysis.report.ReportNumber
import daphnis.analysis.table.UnitNames
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.scale.scaleXContinuous
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.abs

/**
 * Plots of the numbers of a [sweep] against the swept keys, with bars of one standard error. Needs no display.
 *
 * Each key that has numbers as values is an axis in turn; where none has, the first one is, with its values in their
 * order. Points that differ in other keys are curves of their own.
 */
public class SweepPlots(private val sweep: Sweep) {
    private val axes: List<Int> = sweep.keys.indices.filter { k -> several(k) && places(k).all { it.isFinite() } }
        .ifEmpty { sweep.keys.indices.filter { several(it) }.take(1) }

    private fun several(key: Int) = sweep.points.distinctBy { it.values[key] }.size > 1

    private fun places(key: Int) = sweep.points.map { it.values[key].toDoubleOrNull() ?: Double.NaN }

    /**
     * Draws `QUANTITY.svg` and `.png` into [directory], which is made, with `-against-KEY` in the name where there is
     * more than one axis. A quantity that no two points have, or that is the same for all runs, is left out.
     *
     * @return how many plots there are
     */
    @Throws(IOException::class)
    public fun write(directory: Path): Int {
        var drawn = 0
        for (axis in axes) {
            for (quantity in sweep.quantities.filter { varies(it) }) {
                val curves = curves(axis, quantity).filter { c -> c.y.count { it.isFinite() } > 1 }
                if (curves.isEmpty()) continue
                Files.createDirectories(directory)
                Figures.write(plot(axis, quantity, curves), directory, name(axis, quantity), Chart.WIDTH, Chart.HEIGHT)
                drawn++
            }
        }
        return drawn
    }

    /** Whether the numbers of runs differ by more than round-off. */
    private fun varies(quantity: ReportNumber): Boolean {
        val all = sweep.runs.mapNotNull { run -> run.numbers.find { it.key == quantity.key }?.value }
        val finite = all.filter { it.isFinite() }
        return finite.max() - finite.min() > ROUNDING * maxOf(abs(finite.max()), abs(finite.min()))
    }

    private fun name(axis: Int, quantity: ReportNumber): String {
        if (axes.size == 1) return quantity.key
        return "${quantity.key}-against-${sweep.keys[axis].replace(Regex("[^A-Za-z0-9._-]+"), "-")}"
    }

    private fun plot(axis: Int, quantity: ReportNumber, curves: List<Curve>): Plot {
        val x = curves.flatMap { it.x.asList() }
        val isWide = isNumeric(axis) && x.min() > 0 && x.max() > WIDE * x.min()
        val label = UnitNames.axis(quantity.name, quantity.unit)
        val plot = Chart.lines(curves, sweep.labels[axis], label, logX = isWide)
        if (isNumeric(axis)) return plot
        val values = values(axis)
        return plot + scaleXContinuous(breaks = values.indices.map { it.toDouble() }, labels = values.map { short(it) })
    }

    private fun isNumeric(axis: Int) = places(axis).all { it.isFinite() }

    private fun values(axis: Int) = sweep.points.map { it.values[axis] }.distinct()

    private fun curves(axis: Int, quantity: ReportNumber): List<Curve> {
        val others = sweep.keys.indices.filter { it != axis }
        val values = values(axis)
        return sweep.points.groupBy { point -> others.map { point.values[it] } }.map { (_, points) ->
            val place = { p: Sweep.Point ->
                if (isNumeric(axis)) p.values[axis].toDouble() else values.indexOf(p.values[axis]).toDouble()
            }
            val sorted = points.sortedBy(place)
            val means = sorted.map { it.mean(quantity.key) }
            val name = others.filter { several(it) }
                .joinToString(", ") { "${sweep.keys[it].substringAfterLast('.')} ${short(sorted[0].values[it])}" }
            Curve(
                name,
                DoubleArray(sorted.size) { place(sorted[it]) },
                DoubleArray(sorted.size) { means[it].mean },
                DoubleArray(sorted.size) { means[it].error },
            )
        }
    }

    private fun short(value: String) = if (value.length <= LONGEST) value else value.take(LONGEST - 1) + "…"

    private companion object {
        /** Ratio of the largest to the smallest value from which an axis is logarithmic. */
        const val WIDE = 20.0
        const val LONGEST = 24

        /** Relative difference that is no difference. */
        const val ROUNDING = 1e-12
    }
}
