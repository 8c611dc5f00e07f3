package daphnis.analysis.plot

/**
 * The field of a plot with its grid, the numbers at its axes and their titles; a title may have several lines.
 *
 * @param columns marks along the horizontal axis, [rows] those along the vertical one
 * @param left edges of the field on the sheet, like [right], [top] and [bottom], in points
 */
internal class PlotFrame(
    private val across: Axis,
    private val up: Axis,
    private val columns: Ticks,
    private val rows: Ticks,
    val left: Double,
    val right: Double,
    val top: Double,
    val bottom: Double,
) {
    /** Where [value] stands along the horizontal axis. */
    fun atX(value: Double): Double = left + across.fraction(value) * (right - left)

    /** Where [value] stands along the vertical axis. */
    fun atY(value: Double): Double = bottom - up.fraction(value) * (bottom - top)

    /** Draws grid and numbers, of [size] points. */
    fun grid(sheet: Sheet, size: Int) {
        for ((k, place) in rows.places.withIndex()) {
            sheet.line(left, atY(place), right, atY(place), GRID, 1.0)
            sheet.text(rows.labels[k], left - GAP, atY(place) + size / 3.0, size, Anchor.END)
        }
        for ((k, place) in columns.places.withIndex()) {
            sheet.line(atX(place), top, atX(place), bottom, GRID, 1.0)
            sheet.text(columns.labels[k], atX(place), bottom + GAP + size, size, Anchor.MIDDLE)
        }
    }

    /** Draws the titles of the axes, of [size] points: [x] with its last line at [lowest], [y] from [leftmost] on. */
    fun titles(sheet: Sheet, x: String, y: String, size: Int, lowest: Double, leftmost: Double) {
        val below = x.lines()
        for ((k, line) in below.withIndex()) {
            val height = lowest - LINE_HEIGHT * size * (below.lastIndex - k)
            sheet.text(line, (left + right) / 2, height, size, Anchor.MIDDLE)
        }
        for ((k, line) in y.lines().withIndex()) {
            val place = leftmost + size * (LINE_HEIGHT * k + 0.8)
            sheet.text(line, place, (top + bottom) / 2, size, Anchor.MIDDLE, upright = true)
        }
    }

    companion object {
        const val GAP = 7.0

        /** From one line of text to the next, in sizes of the text. */
        const val LINE_HEIGHT = 1.2
        private const val GRID = "#e5e5e5"
    }
}
