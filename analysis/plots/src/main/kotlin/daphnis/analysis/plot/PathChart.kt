package daphnis.analysis.plot

/** Lines through points in their order in a [field], with marks across it. */
internal class PathChart(
    private val field: PlotField,
    private val head: PlotHead,
    private val lines: List<Line>,
    private val vertical: List<Double> = emptyList(),
    private val horizontal: List<Double> = emptyList(),
) : Figure {
    /** The line through the points ([x], [y]). */
    class Line(
        val x: DoubleArray,
        val y: DoubleArray,
        val colour: String,
        val width: Double,
        val dashes: Dashes? = null,
    )

    override fun draw(sheet: Sheet, width: Int, height: Int) {
        val frame = field.draw(sheet, width, height, head.draw(sheet, width))
        for (mark in vertical) {
            val x = frame.atX(mark)
            if (x !in frame.left..frame.right) continue
            sheet.path(doubleArrayOf(x, x), doubleArrayOf(frame.bottom, frame.top), Figures.ACCENT, THIN, Dashes(4, 4))
        }
        for (mark in horizontal) {
            val y = frame.atY(mark)
            if (y !in frame.top..frame.bottom) continue
            sheet.path(doubleArrayOf(frame.left, frame.right), doubleArrayOf(y, y), Figures.QUIET, THIN, Dashes(1, 2))
        }
        for (line in lines) {
            if (line.x.size < 2) continue
            val x = DoubleArray(line.x.size) { frame.atX(line.x[it]) }
            val y = DoubleArray(line.x.size) { frame.atY(line.y[it]) }
            sheet.path(x, y, line.colour, line.width, line.dashes)
        }
    }

    private companion object {
        const val THIN = 1.0
    }
}
