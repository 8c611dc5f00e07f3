package daphnis.analysis.plot

import kotlin.math.abs

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
     * @param across places that the axis across shows too, as that of a chart beside this one does
     * @param joined whether lines join the points of a curve
     * @param ticks where the axis across has its marks, all whole numbers; null to choose. With them the other begins
     *   at 0 and ends at a mark, and there is a legend for a single curve too
     * @param marks named places across, instead of round ones
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
        ticks: List<Int>? = null,
        marks: NamedMarks? = null,
        joined: Boolean = true,
        subtitle: String = "",
        across: List<Double> = emptyList(),
    ): CurveChart {
        val points = curves.map { ChartPoints(it, logX, logY) }
        val x = points.flatMap { it.x }
        val y = points.flatMap { it.low + it.high }
        val seen = horizontal.takeIf { y.isNotEmpty() && !logY }
        val isSeen = seen != null || horizontal != null && logY && y.isNotEmpty() && horizontal in y.min()..y.max()
        val field = PlotField(
            xLabel,
            yLabel,
            x + across + listOfNotNull(vertical.takeIf { x.isNotEmpty() }),
            y + listOfNotNull(seen),
            logX,
            logY,
            marks ?: ticks?.let(::counted),
            isFromZero = ticks != null,
        )
        val isMarked = curves.all { it.x.size <= MOST_MARKED } || !joined
        val isNamed = curves.size > 1 || ticks != null
        val names = if (isNamed) curves.map { it.name } else emptyList()
        val head = PlotHead(title, subtitle, CurveChart.legend(names, isMarked, joined))
        val upright = vertical.takeIf { x.isNotEmpty() }
        return CurveChart(field, head, points, horizontal.takeIf { isSeen }, upright, isMarked, joined)
    }

    private fun counted(ticks: List<Int>): NamedMarks {
        val places = ticks.map { it.toDouble() }
        return NamedMarks(Ticks(places, ticks.map { "$it" }), places.min(), places.max())
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

    /**
     * Whether a few of [values] are so much larger than most that nothing of the others would be seen beside them: all
     * positive, and the largest more than thirty times their median.
     */
    fun hasPeak(values: Iterable<Double>): Boolean {
        val drawn = values.filter { it.isFinite() }.sorted()
        return drawn.isNotEmpty() && drawn[0] > 0 && drawn.last() > PEAK * drawn[drawn.size / 2]
    }

    /** Lines through points in the order given, one for each curve, all alike; [vertical] are marks on the x axis. */
    fun paths(
        curves: List<Curve>,
        xLabel: String,
        yLabel: String,
        vertical: List<Double> = emptyList(),
        horizontal: List<Double> = emptyList(),
    ): Figure {
        val lines = curves.map { curve ->
            val shown = curve.x.indices.filter { curve.x[it].isFinite() && curve.y[it].isFinite() }
            PathChart.Line(values(curve.x, shown), values(curve.y, shown), Figures.INK, PATH)
        }
        return PathChart(field(lines, xLabel, yLabel, false), NO_HEAD, lines, vertical, horizontal)
    }

    private fun values(all: DoubleArray, at: List<Int>) = DoubleArray(at.size) { all[at[it]] }

    private fun field(lines: List<PathChart.Line>, xLabel: String, yLabel: String, isFixed: Boolean) =
        PlotField(xLabel, yLabel, lines.flatMap { it.x.asList() }, lines.flatMap { it.y.asList() }, isFixed = isFixed)

    /**
     * Coloured cells around zero, to scale unless the axes measure different things; [values] at `i · ny + j` for the cell i along the vertical axis, j along
     * the horizontal one. The scale ends at the largest of them, or at [most], whose colour larger ones have.
     */
    fun map(
        vertical: DoubleArray,
        horizontal: DoubleArray,
        values: DoubleArray,
        xLabel: String,
        yLabel: String,
        name: String,
        isToScale: Boolean = true,
        most: Double? = null,
    ): Figure {
        // Zero in the middle of the scale: as much colour above as below.
        val end = most ?: values.filter { it.isFinite() }.maxOfOrNull { abs(it) }?.takeIf { it > 0 } ?: 1.0
        val field = PlotField(xLabel, yLabel, horizontal.asList(), vertical.asList(), isFixed = isToScale)
        return MapChart(field, horizontal, vertical, values, name, end)
    }

    /** The closed curves given, on equal axes. */
    fun ellipses(curves: List<Curve>, xLabel: String, yLabel: String): Figure {
        val lines = curves.mapIndexed { k, curve ->
            val dashes = Pattern.entries[k % Pattern.entries.size].dashes
            PathChart.Line(curve.x, curve.y, Figures.COLOURS[k % Figures.COLOURS.size], CurveChart.LINE, dashes)
        }
        val legend = CurveChart.legend(curves.map { it.name }, isMarked = false, isJoined = true)
        return PathChart(field(lines, xLabel, yLabel, true), PlotHead("", "", legend), lines)
    }

    private const val LOG_FROM = 5.0
    private const val TAIL = 0.05
    private const val PEAK = 30.0
    private const val PATH = 1.2

    /** Points of a curve up to which each is marked. */
    private const val MOST_MARKED = 40
    private val NO_HEAD = PlotHead("", "", emptyList())
}
