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
import org.jetbrains.letsPlot.scale.scaleXLog10
import org.jetbrains.letsPlot.scale.scaleYLog10
import org.jetbrains.letsPlot.themes.elementBlank
import org.jetbrains.letsPlot.themes.theme
import org.jetbrains.letsPlot.themes.themeMinimal
import org.jetbrains.letsPlot.tooltips.tooltipsNone

/** A named curve; [error] is one standard error by point, or null. Points that are NaN are left out. */
public class Curve(public val name: String, public val x: DoubleArray, public val y: DoubleArray, public val error: DoubleArray? = null)

/** Charts of the analysis, in one look. */
internal object Chart {
    const val WIDTH = 760
    const val HEIGHT = 340

    fun lines(
        curves: List<Curve>,
        xLabel: String,
        yLabel: String,
        title: String = "",
        logX: Boolean = false,
        logY: Boolean = false,
        horizontal: Double? = null,
        points: Boolean = false,
        height: Int = HEIGHT,
    ): Plot {
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
        val data = mapOf("x" to x, "y" to y, "low" to low, "high" to high, "curve" to name)
        val several = curves.size > 1
        var plot = letsPlot(data)
        if (horizontal != null) plot += geomHLine(yintercept = horizontal, color = Figures.QUIET, linetype = "dashed", size = 0.5)
        if (curves.any { it.error != null }) {
            plot += geomErrorBar(width = 0.0, size = 0.5, alpha = 0.6, tooltips = tooltipsNone) {
                this.x = "x"
                ymin = "low"
                ymax = "high"
                color = "curve"
            }
        }
        plot += if (points) {
            geomPoint(size = 1.6) {
                this.x = "x"
                this.y = "y"
                color = "curve"
            }
        } else {
            geomLine(size = Figures.LINE) {
                this.x = "x"
                this.y = "y"
                color = "curve"
            }
        }
        plot =
            plot + scaleColorManual(Figures.COLOURS, name = "", limits = curves.map { it.name }) + labs(x = xLabel, y = yLabel) + themeMinimal() + ggsize(WIDTH, height)
        plot += if (several) theme().legendPositionTop() else theme().legendPositionNone()
        if (title.isNotEmpty()) plot += ggtitle(title)
        if (logX) plot += scaleXLog10()
        if (logY) plot += scaleYLog10()
        return plot
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
        // Zero in the middle of the scale: as much colour above as below.
        val most = v.maxOfOrNull { Math.abs(it) }?.takeIf { it > 0 } ?: 1.0
        return letsPlot(mapOf("x" to x, "y" to y, "v" to v)) + geomTile(tooltips = tooltipsNone) {
            this.x = "x"
            this.y = "y"
            fill = "v"
        } + scaleFillGradient2(low = Figures.INK, mid = "#ffffff", high = Figures.ACCENT, midpoint = 0.0, name = name, limits = -most to most) + coordFixed() +
            labs(x = xLabel, y = yLabel) + themeMinimal() + theme(panelGrid = elementBlank()) + ggsize(WIDTH, 560)
    }

    /** The closed curves given, on equal axes. */
    fun ellipses(curves: List<Curve>, xLabel: String, yLabel: String): Plot {
        val x = curves.flatMap { it.x.asList() }
        val y = curves.flatMap { it.y.asList() }
        val name = curves.flatMap { c -> List(c.x.size) { c.name } }
        return letsPlot(mapOf("x" to x, "y" to y, "curve" to name)) + geomPath(size = Figures.LINE, tooltips = tooltipsNone) {
            this.x = "x"
            this.y = "y"
            color = "curve"
        } + scaleColorManual(Figures.COLOURS, name = "") + coordFixed() + labs(x = xLabel, y = yLabel) + themeMinimal() +
            theme().legendPositionTop() + ggsize(WIDTH, 420)
    }
}
