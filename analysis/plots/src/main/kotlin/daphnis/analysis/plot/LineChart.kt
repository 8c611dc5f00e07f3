package daphnis.analysis.plot

/**
 * One line over an axis each way. A run ends with two of them.
 *
 * @param x by point, ascending
 * @param y by point; points that are not finite are left out, and one alone is a dash
 * @param from where the x axis begins, [to] where it ends
 * @param logarithmic whether the y axis is; all [y] are positive then
 * @param counted whether [y] count something: an axis that is not logarithmic begins at 0 then, unless all values are
 *   in the upper half of it
 */
internal class LineChart(
    private val title: String,
    private val xLabel: String,
    private val yLabel: String,
    private val x: List<Double>,
    private val y: List<Double>,
    private val colour: String,
    private val logarithmic: Boolean,
    private val from: Double,
    private val to: Double,
    private val counted: Boolean = false,
) {
    /** Sizes of text in points: of numbers, of the titles of axes, and of the title. */
    class Text(val small: Int, val medium: Int, val large: Int)

    /** Draws on [sheet], [top] points from its upper edge, as wide and high as given. */
    fun draw(sheet: Sheet, top: Double, width: Double, height: Double, text: Text) {
        val points = x.indices.filter { x[it].isFinite() && y[it].isFinite() }
        val across = Axis(from, to, false)
        val up = vertical(points)
        val frame = PlotFrame(
            across,
            up,
            across.ticks(((width - RIGHT - LEFT) / (NUMBER * text.small)).toInt().coerceIn(FEWEST, Ticks.WANTED)),
            up.ticks(),
            LEFT,
            width - RIGHT,
            top + ABOVE,
            top + height - BELOW,
        )
        frame.grid(sheet, text.small)
        sheet.text(title, LEFT, top + text.large + GAP, text.large, Anchor.START)
        val label = if (yLabel.length > LONGEST_LABEL) yLabel.replace(" [", "\n[") else yLabel
        frame.titles(sheet, xLabel, label, text.medium, top + height - GAP, GAP)
        if (points.size == 1) {
            val place = frame.atX(x[points[0]])
            val value = frame.atY(y[points[0]])
            sheet.line(place - GAP, value, place + GAP, value, colour, LINE)
        }
        if (points.size >= 2) {
            val places = DoubleArray(points.size) { frame.atX(x[points[it]]) }
            sheet.path(places, DoubleArray(points.size) { frame.atY(y[points[it]]) }, colour, LINE)
        }
    }

    /** The y axis, with some room above and below the line. */
    private fun vertical(points: List<Int>): Axis {
        val low = points.minOfOrNull { y[it] } ?: 0.0
        val high = points.maxOfOrNull { y[it] } ?: 1.0
        if (logarithmic) return Math.pow(high / low, ROOM).let { Axis(low / it, high * it, true) }
        if (counted && low in 0.0..high / 2) {
            return Axis(0.0, if (high > 0) high * (1 + ROOM) else 1.0, false)
        }
        return ((high - low) * ROOM).let { Axis(low - it, high + it, false) }
    }

    private companion object {
        const val LEFT = 104.0
        const val LONGEST_LABEL = 36
        const val RIGHT = 24.0
        const val ABOVE = 32.0
        const val BELOW = 44.0
        const val GAP = PlotFrame.GAP

        /** Width of a number with room beside it, in sizes of its text. */
        const val NUMBER = 4.5
        const val FEWEST = 3
        const val LINE = 1.5
        const val ROOM = 0.05
    }
}
