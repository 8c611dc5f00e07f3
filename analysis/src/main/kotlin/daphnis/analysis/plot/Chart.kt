package daphnis.analysis.plot

import org.jetbrains.letsPlot.coord.coordFixed
import org.jetbrains.letsPlot.geom.geomErrorBar
import org.jetbrains.letsPlot.geom.geomHLine
import org.jetbrains.letsPlot.geom.geomLine
import org.jetbrains.letsPlot.geom.geomPath
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.geom.geomTile
import org.jetbrains.letsPlot.geom.geomVLine
import org.jetbrains.letsPlot.ggsize
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.label.ggtitle
import org.jetbrains.letsPlot.label.labs
import org.jetbrains.letsPlot.letsPlot
import org.jetbrains.letsPlot.scale.scaleColorManual
import org.jetbrains.letsPlot.scale.scaleFillGradient2
import org.jetbrains.letsPlot.scale.scaleLinetypeManual
import org.jetbrains.letsPlot.scale.scaleShapeManual
import org.jetbrains.letsPlot.scale.scaleXLog10
import org.jetbrains.letsPlot.scale.scaleYLog10
import org.jetbrains.letsPlot.themes.elementBlank
import org.jetbrains.letsPlot.themes.elementText
import org.jetbrains.letsPlot.themes.theme
import org.jetbrains.letsPlot.themes.themeMinimal
import org.jetbrains.letsPlot.tooltips.tooltipsNone

/** A named curve; [error] is one standard error by point, or null. Points that are NaN are left out. */
public class Curve(public val name: String, public val x: DoubleArray, public val y: DoubleArray, public val error: DoubleArray? = null)

/** Charts of the analysis, in one look. */
internal object Chart {
    const val WIDTH = 760
    const val HEIGHT = 340

    /**
     * Curves over a common axis, told apart by colour and by pattern; curves of few points have them marked. Curves after the [Figures.COLOURS] run out repeat.
     *
     * @param logX whether the axis is logarithmic, which its label then says; [logY] likewise, and values that are not positive are left out
     * @param horizontal a dashed line across at this height
     * @param vertical a dashed line upright at this place
     */
    fun lines(
        curves: List<Curve>,
        xLabel: String,
        yLabel: String,
        title: String = "",
        logX: Boolean = false,
        logY: Boolean = false,
        horizontal: Double? = null,
        vertical: Double? = null,
        height: Int = HEIGHT,
    ): Plot {
        var plot = letsPlot(points(curves, logY))
        if (horizontal != null) plot += geomHLine(yintercept = horizontal, color = Figures.QUIET, linetype = "dashed", size = 0.5)
        if (vertical != null) plot += geomVLine(xintercept = vertical, color = Figures.QUIET, linetype = "longdash", size = 0.7)
        if (curves.any { it.error != null }) {
            plot += geomErrorBar(width = 0.0, size = 0.5, alpha = 0.6, showLegend = false, tooltips = tooltipsNone) {
                x = "x"
                ymin = "low"
                ymax = "high"
                color = "curve"
            }
        }
        plot += geomLine(size = Figures.LINE) {
            x = "x"
            y = "y"
            color = "curve"
            linetype = "curve"
        }
        if (curves.all { it.x.size <= MOST_MARKED }) {
            plot += geomPoint(size = 2.0) {
                x = "x"
                y = "y"
                color = "curve"
                shape = "curve"
            }
        }
        plot = patterned(plot, curves) + labs(x = scaled(xLabel, logX), y = scaled(yLabel, logY)) + themeMinimal() + ggsize(WIDTH, height)
        plot += if (curves.size > 1) theme().legendPositionTop() else theme().legendPositionNone()
        if (title.isNotEmpty()) plot += ggtitle(title)
        if (logX) plot += scaleXLog10()
        if (logY) plot += scaleYLog10(limits = room(curves))
        return plot
    }

    /** Whether [values] are best drawn over a logarithmic axis: all positive, and nine tenths of them spread over more than a factor of five. */
    fun isWide(values: Iterable<Double>): Boolean {
        val drawn = values.filter { !it.isNaN() }.sorted()
        if (drawn.isEmpty() || drawn[0] <= 0) return false
        val low = (TAIL * drawn.lastIndex).toInt()
        return drawn[drawn.lastIndex - low] > LOG_FROM * drawn[low]
    }

    /** Says that an axis is logarithmic; a label that is long has its unit on a second line. */
    private fun scaled(label: String, log: Boolean): String {
        val shown = if (log) "$label (log scale)" else label
        return if (shown.length > LONGEST_LABEL) shown.replace(" [", "\n[") else shown
    }

    /** The points of [curves] as columns for lets-plot; NaN is left out, and what a logarithmic axis cannot show. */
    private fun points(curves: List<Curve>, logY: Boolean): Map<String, List<Any>> {
        val x = ArrayList<Double>()
        val y = ArrayList<Double>()
        val low = ArrayList<Double>()
        val high = ArrayList<Double>()
        val name = ArrayList<String>()
        for (curve in curves) {
            for (k in curve.x.indices) {
                if (curve.y[k].isNaN() || logY && curve.y[k] <= 0) continue
                val e = curve.error?.get(k)?.takeIf { !it.isNaN() } ?: 0.0
                x += curve.x[k]
                y += curve.y[k]
                low += if (logY && curve.y[k] - e <= 0) curve.y[k] else curve.y[k] - e
                high += curve.y[k] + e
                name += curve.name
            }
        }
        return mapOf("x" to x, "y" to y, "low" to low, "high" to high, "curve" to name)
    }

    private fun patterned(plot: Plot, curves: List<Curve>): Plot {
        val names = curves.map { it.name }
        return plot + scaleColorManual(Figures.COLOURS, name = "", limits = names) + scaleLinetypeManual(Figures.LINES, name = "", limits = names) +
            scaleShapeManual(Figures.SHAPES, name = "", limits = names) + theme(legendText = elementText(size = LEGEND_TEXT))
    }

    /** A little more than what the curves span: at the edge of a logarithmic axis lines are cut. */
    private fun room(curves: List<Curve>): Pair<Double, Double> {
        val values = curves.flatMap { it.y.asList() }.filter { it > 0 }
        if (values.isEmpty()) return 0.1 to 10.0
        val room = Math.pow(values.max() / values.min(), ROOM)
        return values.min() / room to values.max() * room
    }

    /** Lines through points in the order given, one for each curve, all alike; [vertical] are marks on the x axis. */
    fun paths(curves: List<Curve>, xLabel: String, yLabel: String, vertical: List<Double> = emptyList(), horizontal: List<Double> = emptyList()): Plot {
        val x = ArrayList<Double>()
        val y = ArrayList<Double>()
        val name = ArrayList<String>()
        for (curve in curves) {
            for (k in curve.x.indices) {
                if (curve.y[k].isNaN() || curve.x[k].isNaN()) continue
                x += curve.x[k]
                y += curve.y[k]
                name += curve.name
            }
        }
        var plot = letsPlot(mapOf("x" to x, "y" to y, "line" to name))
        for (mark in vertical) plot += geomVLine(xintercept = mark, color = Figures.ACCENT, linetype = "dashed", size = 0.5)
        for (mark in horizontal) plot += geomHLine(yintercept = mark, color = Figures.QUIET, linetype = "dotted", size = 0.5)
        return plot + geomPath(color = Figures.INK, size = 0.5, tooltips = tooltipsNone) {
            this.x = "x"
            this.y = "y"
            group = "line"
        } + labs(x = xLabel, y = yLabel) + themeMinimal() + ggsize(WIDTH, 420)
    }

    /** Coloured cells around zero, to scale; [values] at `i · ny + j` for the cell i along the vertical axis, j along the horizontal one. */
    fun map(vertical: DoubleArray, horizontal: DoubleArray, values: DoubleArray, xLabel: String, yLabel: String, name: String): Plot {
        val x = ArrayList<Double>()
        val y = ArrayList<Double>()
        val v = ArrayList<Double>()
        for (i in vertical.indices) {
            for (j in horizontal.indices) {
                x += horizontal[j]
                y += vertical[i]
                v += values[i * horizontal.size + j]
            }
        }
        return letsPlot(mapOf("x" to x, "y" to y, "v" to v)) + geomTile(tooltips = tooltipsNone) {
            this.x = "x"
            this.y = "y"
            fill = "v"
        } + scaleFillGradient2(low = Figures.INK, mid = "#ffffff", high = Figures.ACCENT, midpoint = 0.0, name = name) + coordFixed() +
            labs(x = xLabel, y = yLabel) + themeMinimal() + theme(panelGrid = elementBlank()) + ggsize(WIDTH, 560)
    }

    /** The closed curves given, on equal axes. */
    fun ellipses(curves: List<Curve>, xLabel: String, yLabel: String): Plot {
        val x = curves.flatMap { it.x.asList() }
        val y = curves.flatMap { it.y.asList() }
        val name = curves.flatMap { c -> List(c.x.size) { c.name } }
        val plot = letsPlot(mapOf("x" to x, "y" to y, "curve" to name)) + geomPath(size = Figures.LINE, tooltips = tooltipsNone) {
            this.x = "x"
            this.y = "y"
            color = "curve"
            linetype = "curve"
        } + coordFixed() + labs(x = xLabel, y = yLabel) + themeMinimal() +
            ggsize(WIDTH, 420)
        return patterned(plot, curves) + theme().legendPositionTop()
    }

    private const val LOG_FROM = 5.0
    private const val TAIL = 0.05
    private const val LONGEST_LABEL = 34
    private const val ROOM = 0.05

    /** Points of a curve up to which each is marked. */
    private const val MOST_MARKED = 40
    private const val LEGEND_TEXT = 14
}
