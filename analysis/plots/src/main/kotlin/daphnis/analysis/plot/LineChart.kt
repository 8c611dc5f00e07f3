package daphnis.analysis.plot

/**
 * One line over an axis each way. Drawn by ourselves, because a run ends with two of them: the plotting library that
 * draws the analysis takes over a second for its first picture.
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
    /** Draws on [sheet], [top] points from its upper edge, as wide and high as given. */
    fun draw(sheet: Sheet, top: Double, width: Double, height: Double) {
        val points = x.indices.filter { x[it].isFinite() && y[it].isFinite() }
        val across = Axis(from, to, false)
        val up = vertical(points)
        val right = width - RIGHT
        val above = top + ABOVE
        val bottom = top + height - BELOW
        fun atX(value: Double) = LEFT + across.fraction(value) * (right - LEFT)
        fun atY(value: Double) = bottom - up.fraction(value) * (bottom - above)
        val rows = up.ticks()
        for ((k, place) in rows.places.withIndex()) {
            sheet.line(LEFT, atY(place), right, atY(place), GRID, 1.0)
            sheet.text(rows.labels[k], LEFT - GAP, atY(place) + SMALL / 3.0, SMALL, Anchor.END)
        }
        val columns = across.ticks()
        for ((k, place) in columns.places.withIndex()) {
            sheet.line(atX(place), above, atX(place), bottom, GRID, 1.0)
            sheet.text(columns.labels[k], atX(place), bottom + GAP + SMALL, SMALL, Anchor.MIDDLE)
        }
        sheet.text(title, LEFT, top + LARGE + GAP, LARGE, Anchor.START)
        sheet.text(xLabel, (LEFT + right) / 2, top + height - GAP, MEDIUM, Anchor.MIDDLE)
        val lines = if (yLabel.length > LONGEST_LABEL) yLabel.replace(" [", "\n[").lines() else listOf(yLabel)
        for ((k, line) in lines.withIndex()) {
            sheet.text(
                line,
                GAP + MEDIUM * (1.2 * k + 0.8),
                (above + bottom) / 2,
                MEDIUM,
                Anchor.MIDDLE,
                upright = true,
            )
        }
        if (points.size == 1) {
            sheet.line(
                atX(x[points[0]]) - GAP,
                atY(y[points[0]]),
                atX(x[points[0]]) + GAP,
                atY(y[points[0]]),
                colour,
                LINE,
            )
        }
        if (points.size >= 2) {
            sheet.path(
                DoubleArray(points.size) {
                    atX(x[points[it]])
                },
                DoubleArray(points.size) { atY(y[points[it]]) },
                colour,
                LINE,
            )
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
        const val GAP = 7.0
        const val SMALL = 11
        const val MEDIUM = 13
        const val LARGE = 16
        const val LINE = 1.5
        const val ROOM = 0.05
        const val GRID = "#e5e5e5"
    }
}
