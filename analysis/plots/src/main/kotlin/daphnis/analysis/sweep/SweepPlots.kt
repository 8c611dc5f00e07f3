package daphnis.analysis.sweep

import daphnis.analysis.plot.Chart
import daphnis.analysis.plot.Curve
import daphnis.analysis.plot.CurveChart
import daphnis.analysis.plot.PictureFiles
import daphnis.analysis.report.JsonWords
import daphnis.analysis.report.ReportNumber
import daphnis.analysis.table.UnitNames
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.io.IOException
import java.nio.file.Path
import kotlin.math.abs
import kotlin.math.pow

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

    /** Why [write] made no PNGs, as where this Java has no fonts; null when it did. */
    public var missing: String? = null
        private set

    /**
     * Draws `QUANTITY.svg` and `.png` into [directory], which is made, with `-against-KEY` in the name where there is
     * more than one axis. A quantity that no two points have, or that is the same for all runs, is left out.
     *
     * @return how many plots there are
     */
    @Throws(IOException::class)
    public fun write(directory: Path): Int {
        var drawn = 0
        val pictures = PictureFiles(directory)
        for ((name, plot) in plots()) {
            pictures.write(plot, name)
            drawn++
        }
        missing = pictures.missing
        return drawn
    }

    /** The plots with their names, each made when it is asked for. */
    internal fun plots(): Sequence<Pair<String, CurveChart>> = axes.asSequence().flatMap { axis ->
        sweep.quantities.asSequence().filter { varies(it) }.mapNotNull { quantity ->
            val curves = curves(axis, quantity).filter { c -> c.y.count { it.isFinite() } > 1 }
            if (curves.isEmpty()) null else name(axis, quantity) to plot(axis, quantity, curves)
        }
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

    private fun plot(axis: Int, quantity: ReportNumber, curves: List<Curve>): CurveChart {
        val x = curves.flatMap { it.x.asList() }
        val isWide = isNumeric(axis) && x.min() > 0 && x.max() > WIDE * x.min()
        val label = UnitNames.axis(quantity.name, quantity.unit)
        // A line through two points tells nothing that they do not, and between values that are no numbers is nothing.
        val isJoined = isNumeric(axis) && x.distinct().size > 2
        val named = if (isNumeric(axis)) null else NamedPlaces(sweep.labels[axis], values(axis).map { short(it) })
        val across = named?.label ?: sweep.labels[axis]
        val marks = named?.marks()
        return Chart.lines(aside(curves, isWide), across, label, logX = isWide, marks = marks, joined = isJoined)
    }

    /** [curves] less than the width of a point apart, so that bars of one do not hide those of another. */
    private fun aside(curves: List<Curve>, isWide: Boolean): List<Curve> {
        if (curves.size == 1) return curves
        val x = curves.flatMap { it.x.asList() }
        return curves.mapIndexed { k, curve ->
            val part = ASIDE * (k - (curves.size - 1) / 2.0)
            val moved = DoubleArray(curve.x.size) {
                if (isWide) curve.x[it] * (x.max() / x.min()).pow(part) else curve.x[it] + part * (x.max() - x.min())
            }
            Curve(curve.name, moved, curve.y, curve.error)
        }
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

    /** A value in a legend or at an axis; one that is an object is in words. */
    private fun short(value: String): String {
        val words = words(value)
        return if (words.length <= LONGEST) words else words.take(LONGEST - 1) + "…"
    }

    private fun words(value: String): String = try {
        if (value.startsWith("{")) JsonWords.text(Json.parseToJsonElement(value)) else value
    } catch (e: SerializationException) {
        value
    }

    private companion object {
        /** Ratio of the largest to the smallest value from which an axis is logarithmic. */
        const val WIDE = 20.0
        const val LONGEST = 40

        /** How far curves are beside each other, as a part of the axis. */
        const val ASIDE = 0.006

        /** Relative difference that is no difference. */
        const val ROUNDING = 1e-12
    }
}
