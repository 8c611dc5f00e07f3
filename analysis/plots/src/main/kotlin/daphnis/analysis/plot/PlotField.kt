package daphnis.analysis.plot

import kotlin.math.pow

/**
 * What a plot shows of the plane, with titles of its axes: by default a little more than from the least to the greatest
 * of [x] and of [y], which are marked at round places.
 *
 * @param x values to be seen along the horizontal axis; none for an empty field
 * @param logX whether the axis is logarithmic, which its label then says; all values are positive then
 * @param marks places of the horizontal axis that are named, instead of round ones
 * @param isFromZero whether the vertical axis begins at 0 and ends at a mark
 * @param isFixed whether a unit is as long along both axes
 */
internal class PlotField(
    private val xLabel: String,
    private val yLabel: String,
    x: List<Double>,
    y: List<Double>,
    logX: Boolean = false,
    logY: Boolean = false,
    marks: NamedMarks? = null,
    isFromZero: Boolean = false,
    private val isFixed: Boolean = false,
) {
    private val xSpan = Span(x, logX, marks)
    private val ySpan = if (isFromZero) Span.fromZero(y) else Span(y, logY)
    private val below = scaled(xLabel, logX)
    private val beside = scaled(yLabel, logY)

    /** Says that an axis is logarithmic; a label that is long has its unit on a second line. */
    private fun scaled(label: String, log: Boolean): String {
        val shown = if (log) label + LOG else label
        return if (shown.length > LONGEST_LABEL && '\n' !in shown) shown.replace(" [", "\n[") else shown
    }

    /** [label] with what is said of the scale on a line of its own where a line would be longer than [room] points. */
    private fun fitting(label: String, room: Double): String {
        val isLong = label.lines().any { LABEL * TextWidth.of(it) > room }
        return if (isLong) label.replace(LOG, "\n" + LOG.trim()) else label
    }

    /** Draws axes and grid where [top] points above are taken, and [right] points at the right; the frame of it. */
    fun draw(sheet: Sheet, width: Int, height: Int, top: Double, right: Double = MARGIN): PlotFrame {
        var above = top + MARGIN
        var bottom = height - MARGIN - below.lines().size * LABEL * PlotFrame.LINE_HEIGHT - NUMBER - PlotFrame.GAP
        val beside = fitting(beside, minOf(above + bottom, 2 * height - above - bottom))
        val numbers = NUMBER * (ySpan.ticks.labels.maxOfOrNull { TextWidth.of(it) } ?: 0.0)
        // From the title's upper edge to the field: its lines, the numbers, and a gap behind each.
        val room = beside.lines().size * LABEL * PlotFrame.LINE_HEIGHT + numbers + 2 * PlotFrame.GAP
        var left = MARGIN + room
        var end = width - right
        if (isFixed) {
            val unit = minOf((end - left) / xSpan.length, (bottom - above) / ySpan.length)
            val spareX = (end - left - unit * xSpan.length) / 2
            val spareY = (bottom - above - unit * ySpan.length) / 2
            left += spareX
            end -= spareX
            above += spareY
            bottom -= spareY
        }
        if (!isFixed) end -= overhang(left, end, width)
        val columns = if (isFixed) {
            xSpan.fitting(end - left) {
                NUMBER * TextWidth.of(it) + PlotFrame.GAP
            }
        } else {
            xSpan.ticks
        }
        val rows = if (isFixed) ySpan.fitting(bottom - above) { NUMBER + PlotFrame.GAP } else ySpan.ticks
        val frame = PlotFrame(xSpan.axis, ySpan.axis, columns, rows, left, end, above, bottom)
        frame.grid(sheet, NUMBER)
        val lowest = bottom + NUMBER + PlotFrame.GAP + below.lines().size * LABEL * PlotFrame.LINE_HEIGHT
        frame.titles(sheet, below, beside, LABEL, lowest, left - room)
        return frame
    }

    /** By how much the field must be narrower for the last number below it to end on a sheet of this [width]. */
    private fun overhang(left: Double, end: Double, width: Int): Double {
        val last = xSpan.ticks.places.lastOrNull() ?: return 0.0
        val part = xSpan.axis.fraction(last)
        val half = NUMBER * TextWidth.of(xSpan.ticks.labels.last()) / 2
        val over = left + part * (end - left) + half - (width - 1)
        return if (over > 0) over / part else 0.0
    }

    /** What one axis shows. */
    private class Span(val axis: Axis, val ticks: Ticks, val length: Double) {
        /** As many round places as have [room] for their labels, each of which takes its [part] of it. */
        fun fitting(room: Double, part: (String) -> Double): Ticks = (WANTED downTo 1).asSequence()
            .map { Ticks.linear(axis.from, axis.to, it) }
            .firstOrNull { fewer -> fewer.places.size > 1 && fewer.places.size * fewer.labels.maxOf(part) <= room }
            ?: Ticks.linear(axis.from, axis.to, 1)

        companion object {
            operator fun invoke(values: List<Double>, log: Boolean, marks: NamedMarks? = null): Span {
                val low = minOf(values.minOrNull() ?: 1.0, marks?.from ?: Double.POSITIVE_INFINITY)
                val high = maxOf(values.maxOrNull() ?: 1.0, marks?.to ?: Double.NEGATIVE_INFINITY)
                if (log) {
                    val room = (high / low).pow(ROOM)
                    val axis = Axis(low / room, high * room, true)
                    val ticks = marks?.ticks ?: if (high > low) Ticks.logarithmic(low, high) else axis.ticks()
                    return Span(axis, ticks, Double.NaN)
                }
                val room = (high - low) * ROOM
                val axis = Axis(low - room, high + room, false)
                return Span(axis, marks?.ticks ?: Ticks.linear(axis.from, axis.to, WANTED), axis.to - axis.from)
            }

            fun fromZero(values: List<Double>): Span {
                val ticks = Ticks.linearFromZero(values.maxOrNull() ?: 1.0)
                return Span(Axis(0.0, ticks.places.last(), false), ticks, ticks.places.last())
            }
        }
    }

    companion object {
        const val MARGIN = 10.0

        /** Sizes of text: of numbers at axes and names in legends, and of the titles of axes. */
        const val NUMBER = 13
        const val LABEL = 15
        private const val LONGEST_LABEL = 34
        private const val LOG = " (log scale)"
        private const val ROOM = 0.05

        /** Marks of an axis across its room at both ends too. */
        private const val WANTED = 9
    }
}

/** Marks of an axis that shows at least what is between [from] and [to]. */
internal class NamedMarks(val ticks: Ticks, val from: Double, val to: Double)
