package daphnis.analysis.plot

/** What stands above a plot: [title], [subtitle] and a legend of [entries], each of them or none. */
internal class PlotHead(private val title: String, private val subtitle: String, private val entries: List<Entry>) {
    /** A name in the legend, and what draws its sign in the middle of ([x], [y]). */
    class Entry(val name: String, val sign: (sheet: Sheet, x: Double, y: Double) -> Unit)

    /** Draws it on a sheet [width] points wide. @return how many points it takes from above */
    fun draw(sheet: Sheet, width: Int): Double {
        var y = PlotField.MARGIN
        if (title.isNotEmpty()) {
            y += TITLE
            sheet.text(title, PlotField.MARGIN, y, TITLE, Anchor.START)
            y += PlotFrame.GAP
        }
        if (subtitle.isNotEmpty()) {
            y += PlotField.NUMBER
            sheet.text(subtitle, PlotField.MARGIN, y, PlotField.NUMBER, Anchor.START)
            y += PlotFrame.GAP
        }
        for (row in rows(width - 2 * PlotField.MARGIN)) {
            y += TEXT
            var x = (width - row.sumOf(::room)) / 2
            for (entry in row) {
                entry.sign(sheet, x + SIGN / 2, y - TEXT / 3.0)
                sheet.text(entry.name, x + SIGN + PlotFrame.GAP, y, TEXT, Anchor.START)
                x += room(entry)
            }
            y += PlotFrame.GAP
        }
        return if (y > PlotField.MARGIN) y - PlotFrame.GAP else 0.0
    }

    private fun rows(width: Double): List<List<Entry>> {
        val rows = ArrayList<ArrayList<Entry>>()
        for (entry in entries) {
            val row = rows.lastOrNull()
            if (row == null || row.sumOf(::room) + room(entry) > width) rows += arrayListOf(entry) else row += entry
        }
        return rows
    }

    private fun room(entry: Entry) = SIGN + PlotFrame.GAP + TextWidth.of(entry.name) * TEXT + BETWEEN

    companion object {
        /** How long the line beside a name is. */
        const val SIGN = 36.0
        private const val BETWEEN = 18.0
        private const val TITLE = 16
        private const val TEXT = 14
    }
}
