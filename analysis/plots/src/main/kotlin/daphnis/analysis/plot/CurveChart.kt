package daphnis.analysis.plot

/**
 * Curves in a [field], told apart by colour and by [Pattern]; the first is drawn last, over the others.
 *
 * @param points of the curves that can be shown, in their order
 * @param horizontal a dashed line across at this height
 * @param vertical a dashed line upright at this place
 * @param isMarked whether each point has a mark, [isJoined] whether lines join them
 */
internal class CurveChart(
    private val field: PlotField,
    private val head: PlotHead,
    private val points: List<ChartPoints>,
    private val horizontal: Double?,
    private val vertical: Double?,
    private val isMarked: Boolean,
    private val isJoined: Boolean,
) : Figure {
    override fun draw(sheet: Sheet, width: Int, height: Int) {
        val frame = field.draw(sheet, width, height, head.draw(sheet, width))
        horizontal?.let { dashed(sheet, frame.left, frame.atY(it), frame.right, frame.atY(it)) }
        vertical?.let { dashed(sheet, frame.atX(it), frame.bottom, frame.atX(it), frame.top) }
        for (k in points.indices.reversed()) bars(sheet, frame, k)
        if (isJoined) for (k in points.indices.reversed()) line(sheet, frame, k)
        if (!isMarked && isJoined) return
        for (k in points.indices.reversed()) {
            val p = points[k]
            for (i in p.x.indices) {
                val radius = if (isJoined) POINT else LONE_POINT
                pattern(k).mark(sheet, frame.atX(p.x[i]), frame.atY(p.y[i]), radius, colour(k))
            }
        }
    }

    private fun dashed(sheet: Sheet, x1: Double, y1: Double, x2: Double, y2: Double) =
        sheet.path(doubleArrayOf(x1, x2), doubleArrayOf(y1, y2), Figures.QUIET, THIN, Dashes(4, 4))

    private fun bars(sheet: Sheet, frame: PlotFrame, k: Int) {
        val p = points[k]
        val pale = Colours.mixed("#ffffff", colour(k), PALE)
        for (i in p.x.indices) {
            if (p.low[i] == p.high[i]) continue
            val x = frame.atX(p.x[i])
            sheet.line(x, frame.atY(p.low[i]), x, frame.atY(p.high[i]), pale, if (isMarked) BAR else THIN)
        }
    }

    private fun line(sheet: Sheet, frame: PlotFrame, k: Int) {
        val p = points[k]
        if (p.x.size < 2) return
        val x = DoubleArray(p.x.size) { frame.atX(p.x[it]) }
        sheet.path(x, DoubleArray(p.x.size) { frame.atY(p.y[it]) }, colour(k), LINE, pattern(k).dashes)
    }

    companion object {
        const val LINE = 2.0
        private const val THIN = 1.0
        private const val BAR = 1.8
        private const val POINT = 3.2
        private const val LONE_POINT = 4.5

        /** How much of its colour a bar has. */
        private const val PALE = 0.7

        private fun pattern(k: Int) = Pattern.entries[k % Pattern.entries.size]

        private fun colour(k: Int) = Figures.COLOURS[k % Figures.COLOURS.size]

        /** Entries of a legend for curves of these [names], in their order. */
        fun legend(names: List<String>, isMarked: Boolean, isJoined: Boolean): List<PlotHead.Entry> =
            names.mapIndexed { k, name ->
                PlotHead.Entry(name) { sheet, x, y ->
                    val ends = doubleArrayOf(x - PlotHead.SIGN / 2, x + PlotHead.SIGN / 2)
                    if (isJoined) sheet.path(ends, doubleArrayOf(y, y), colour(k), LINE, pattern(k).dashes)
                    if (isMarked) pattern(k).mark(sheet, x, y, POINT, colour(k))
                }
            }
    }
}
