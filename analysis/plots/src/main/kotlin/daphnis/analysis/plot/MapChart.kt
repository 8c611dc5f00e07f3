package daphnis.analysis.plot

/**
 * Coloured tiles to scale around the points of a lattice in a [field], with a bar of the colours at the right: zero is
 * white, [most] one colour and −[most] another.
 *
 * @param values at `i · horizontal.size + j` for the tile in row i of [vertical]; those that are NaN have no tile
 */
internal class MapChart(
    private val field: PlotField,
    private val horizontal: DoubleArray,
    private val vertical: DoubleArray,
    private val values: DoubleArray,
    private val name: String,
    private val most: Double,
) : Figure {
    override fun draw(sheet: Sheet, width: Int, height: Int) {
        val bar = maxOf(TextWidth.of(name) * PlotField.LABEL, BAR + ROOM_FOR_NUMBERS) + 2 * PlotField.MARGIN
        val frame = field.draw(sheet, width, height, 0.0, bar)
        val tileWidth = step(horizontal) * (frame.atX(1.0) - frame.atX(0.0))
        val tileHeight = step(vertical) * (frame.atY(0.0) - frame.atY(1.0))
        for (i in vertical.indices) {
            for (j in horizontal.indices) {
                val value = values[i * horizontal.size + j]
                if (value.isNaN()) continue
                val x = frame.atX(horizontal[j]) - tileWidth / 2
                val y = frame.atY(vertical[i]) - tileHeight / 2
                sheet.tile(x, y, tileWidth, tileHeight, colour(value / most))
            }
        }
        scale(sheet, frame, frame.right + PlotField.MARGIN)
    }

    private fun step(places: DoubleArray) =
        if (places.size < 2) 1.0 else (places.last() - places.first()) / (places.size - 1)

    private fun scale(sheet: Sheet, frame: PlotFrame, left: Double) {
        val middle = (frame.top + frame.bottom) / 2
        val half = minOf(MOST_BAR, frame.bottom - frame.top - 2 * PlotField.LABEL) / 2
        sheet.text(name, left, middle - half - PlotFrame.GAP * 2, PlotField.LABEL, Anchor.START)
        for (k in 0 until STEPS) {
            val y = middle + half - (k + 1) * 2 * half / STEPS
            sheet.tile(left, y, BAR, 2 * half / STEPS, colour(2 * (k + 0.5) / STEPS - 1))
        }
        val ticks = Ticks.linear(-most, most, FEW)
        for ((k, place) in ticks.places.withIndex()) {
            val y = middle - half * place / most
            sheet.text(
                ticks.labels[k],
                left + BAR + PlotFrame.GAP,
                y + PlotField.NUMBER / 3.0,
                PlotField.NUMBER,
                Anchor.START,
            )
        }
    }

    internal companion object {
        private const val BAR = 22.0
        private const val MOST_BAR = 220.0
        private const val ROOM_FOR_NUMBERS = 60.0
        private const val STEPS = 64

        /** Marks at a bar of colours. */
        private const val FEW = 5

        /** Of [part] in −1..1; 0 is white. */
        fun colour(part: Double): String =
            Colours.mixed("#ffffff", if (part < 0) Figures.INK else Figures.ACCENT, Math.abs(part).coerceAtMost(1.0))
    }
}
