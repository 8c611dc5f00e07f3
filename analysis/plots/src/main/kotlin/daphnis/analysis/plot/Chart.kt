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
import org.jetbrains.letsPlot.scale.scaleXContinuous
import org.jetbrains.letsPlot.scale.scaleXLog10
import org.jetbrains.letsPlot.scale.scaleYContinuous
import org.jetbrains.letsPlot.scale.scaleYLog10
import org.jetbrains.letsPlot.themes.elementBlank
import org.jetbrains.letsPlot.themes.elementText
import org.jetbrains.letsPlot.themes.theme
import org.jetbrains.letsPlot.themes.themeMinimal
import org.jetbrains.letsPlot.tooltips.tooltipsNone

/** A named curve; [error] is one standard error by point, or null. Points that are NaN are left out. */
public class Curve @JvmOverloads constructor(
    public val name: String,
    public val x: DoubleArray,
    public val y: DoubleArray,
    public val error: DoubleArray? = null,
)

/** Charts of the analysis, in one look. */
internal object Chart {
    const val WIDTH = 760
    const val HEIGHT = 340

    /**
     * Curves over a common axis, told apart by colour and by pattern; curves of few points have them marked. Curves
     * after the [Figures.COLOURS] run out repeat.
     *
     * @param logX whether the axis is logarithmic, which its label then says; [logY] likewise; values that are not
     * positive are left out
     * @param horizontal a dashed line across at this height
     * @param vertical a dashed line upright at this place
     * @param joined whether lines join the points of a curve
     * @param ticks where the axis across has its marks, all whole numbers; null to choose. With them the other begins
     *   at 0 and ends at a mark, and there is a legend for a single curve too
     * @param subtitle what stands below the title
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
        ticks: List<Int>? = null,
        joined: Boolean = true,
        subtitle: String = "",
    ): Plot {
        // The first curve is drawn last, over the others.
        val points = ChartPoints(curves.asReversed(), logX, logY)
        val isMarked = curves.all { it.x.size <= MOST_MARKED }
        var plot = letsPlot(points.columns)
        if (horizontal != null) {
            plot += geomHLine(yintercept = horizontal, color = Figures.QUIET, linetype = "dashed", size = 0.5)
        }
        if (vertical != null) {
            plot += geomVLine(xintercept = vertical, color = Figures.QUIET, linetype = "longdash", size = 0.7)
        }
        if (curves.any { it.error != null }) {
            val size = if (isMarked) BAR else THIN_BAR
            plot += geomErrorBar(width = 0.0, size = size, alpha = 0.75, showLegend = false, tooltips = tooltipsNone) {
                x = "x"
                ymin = "low"
                ymax = "high"
                color = "curve"
            }
        }
        if (joined) {
            plot += geomLine(size = Figures.LINE) {
                x = "x"
                y = "y"
                color = "curve"
                linetype = "curve"
            }
        }
        if (isMarked || !joined) {
            plot += geomPoint(size = if (joined) POINT else LONE_POINT) {
                x = "x"
                y = "y"
                color = "curve"
                shape = "curve"
            }
        }
        plot = patterned(plot, curves) + labs(x = scaled(xLabel, logX), y = scaled(yLabel, logY)) + themeMinimal()
        plot += ggsize(WIDTH, height)
        val isNamed = curves.size > 1 || ticks != null
        plot += if (isNamed) theme().legendPositionTop() else theme().legendPositionNone()
        if (title.isNotEmpty()) plot += ggtitle(title, subtitle.ifEmpty { null })
        val x = points.x + listOfNotNull(vertical.takeIf { points.x.isNotEmpty() })
        val y = points.low + points.high + listOfNotNull(horizontal.takeIf { points.y.isNotEmpty() && !logY })
        return if (ticks == null) marked(plot, x, y, logX, logY) else counted(plot, ticks, y)
    }

    /**
     * Whether [values] are best drawn over a logarithmic axis: all positive, and nine tenths of them spread over more
     * than a factor of five.
     */
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

    /** [plot] with both axes marked at round places. */
    private fun marked(
        plot: Plot,
        x: List<Double>,
        y: List<Double>,
        logX: Boolean = false,
        logY: Boolean = false,
    ): Plot {
        if (x.isEmpty() || y.isEmpty()) return plot
        val across = if (logX) Ticks.logarithmic(x.min(), x.max()) else Ticks.linear(x.min(), x.max())
        val up = if (logY) Ticks.logarithmic(y.min(), y.max()) else Ticks.linear(y.min(), y.max())
        val xScale = if (logX) {
            // Without limits the bars' width, counted in units of x, makes it begin far below the first point.
            scaleXLog10(breaks = across.places, labels = across.labels, limits = room(x), expand = NO_MORE)
        } else {
            scaleXContinuous(breaks = across.places, labels = across.labels)
        }
        val yScale = if (logY) {
            scaleYLog10(breaks = up.places, labels = up.labels, limits = room(y), expand = NO_MORE)
        } else {
            scaleYContinuous(breaks = up.places, labels = up.labels)
        }
        return plot + xScale + yScale
    }

    private fun counted(plot: Plot, ticks: List<Int>, y: List<Double>): Plot {
        val up = Ticks.linearFromZero(y.max())
        return plot + scaleXContinuous(breaks = ticks.map { it.toDouble() }, labels = ticks.map { "$it" }) +
            scaleYContinuous(breaks = up.places, labels = up.labels, limits = 0.0 to up.places.last())
    }

    private fun patterned(plot: Plot, curves: List<Curve>): Plot {
        val names = curves.map { it.name }
        return plot + scaleColorManual(Figures.COLOURS, name = "", limits = names) +
            scaleLinetypeManual(Figures.LINES, name = "", limits = names) +
            scaleShapeManual(Figures.SHAPES, name = "", limits = names) +
            theme(legendText = elementText(size = LEGEND_TEXT))
    }

    /** A little more than what the curves span: at the edge of a logarithmic axis lines are cut. */
    private fun room(values: List<Double>): Pair<Double, Double> {
        val room = Math.pow(values.max() / values.min(), ROOM)
        return values.min() / room to values.max() * room
    }

    /** Lines through points in the order given, one for each curve, all alike; [vertical] are marks on the x axis. */
    fun paths(
        curves: List<Curve>,
        xLabel: String,
        yLabel: String,
        vertical: List<Double> = emptyList(),
        horizontal: List<Double> = emptyList(),
    ): Plot {
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
        for (mark in vertical) {
            plot += geomVLine(xintercept = mark, color = Figures.ACCENT, linetype = "dashed", size = 0.5)
        }
        for (mark in horizontal) {
            plot += geomHLine(yintercept = mark, color = Figures.QUIET, linetype = "dotted", size = 0.5)
        }
        plot += geomPath(color = Figures.INK, size = 0.5, tooltips = tooltipsNone) {
            this.x = "x"
            this.y = "y"
            group = "line"
        }
        return marked(plot, x, y) + labs(x = xLabel, y = yLabel) + themeMinimal() + ggsize(WIDTH, 420)
    }

    /**
     * Coloured cells around zero, to scale; [values] at `i · ny + j` for the cell i along the vertical axis, j along
     * the horizontal one.
     */
    fun map(
        vertical: DoubleArray,
        horizontal: DoubleArray,
        values: DoubleArray,
        xLabel: String,
        yLabel: String,
        name: String,
    ): Plot {
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
        val shades = Ticks.linear(-most, most, wanted = FEW)
        val plot = letsPlot(mapOf("x" to x, "y" to y, "v" to v)) + geomTile(tooltips = tooltipsNone) {
            this.x = "x"
            this.y = "y"
            fill = "v"
        }
        return marked(plot, x, y) +
            scaleFillGradient2(
                low = Figures.INK,
                mid = "#ffffff",
                high = Figures.ACCENT,
                midpoint = 0.0,
                name = name,
                limits = -most to most,
                breaks = shades.places,
                labels = shades.labels,
            ) +
            coordFixed() +
            labs(x = xLabel, y = yLabel) + themeMinimal() + theme(panelGrid = elementBlank()) + ggsize(WIDTH, 560)
    }

    /** The closed curves given, on equal axes. */
    fun ellipses(curves: List<Curve>, xLabel: String, yLabel: String): Plot {
        val x = curves.flatMap { it.x.asList() }
        val y = curves.flatMap { it.y.asList() }
        val name = curves.flatMap { c -> List(c.x.size) { c.name } }
        val drawn = geomPath(size = Figures.LINE, tooltips = tooltipsNone) {
            this.x = "x"
            this.y = "y"
            color = "curve"
            linetype = "curve"
        }
        val plot = letsPlot(mapOf("x" to x, "y" to y, "curve" to name)) + drawn
        return patterned(marked(plot, x, y), curves) + coordFixed() + labs(x = xLabel, y = yLabel) + themeMinimal() +
            ggsize(WIDTH, 420) + theme().legendPositionTop()
    }

    private const val LOG_FROM = 5.0
    private const val TAIL = 0.05
    private const val LONGEST_LABEL = 34
    private const val ROOM = 0.05

    /** lets-plot would widen limits by a part of their difference, not of their ratio: by decades at the low end. */
    private val NO_MORE = listOf(0.0, 0.0)

    /** Points of a curve up to which each is marked. */
    private const val MOST_MARKED = 40
    private const val POINT = 2.0
    private const val LONE_POINT = 3.0
    private const val BAR = 0.9
    private const val THIN_BAR = 0.5
    private const val LEGEND_TEXT = 14

    /** Marks at a bar of colours. */
    private const val FEW = 5
}
