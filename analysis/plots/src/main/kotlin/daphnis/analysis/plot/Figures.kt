package daphnis.analysis.plot

/** Figures as files, and their colours; needs no display. */
internal object Figures {
    const val INK = "#1f4e79"
    const val ACCENT = "#b3541e"
    const val QUIET = "#7a7a7a"
    const val TEXT = "#333333"

    /**
     * Colours of curves, first to last: told apart by the colour-blind (after Okabe & Ito) and, since each of the first
     * four is lighter than the one before, in grey too; none so light that it is lost on white. Curves differ in
     * [Pattern] as well.
     */
    val COLOURS = listOf("#00355f", "#9c2f6b", "#c8571b", "#3a96d0", "#000000", "#5f7a00", "#7a5cc2", "#8a6d3b")

    fun svg(figure: Figure, width: Int = Chart.WIDTH, height: Int = Chart.HEIGHT): String =
        SvgSheet(width, height).also { figure.draw(it, width, height) }.toString()

    /** @throws IllegalStateException when this Java cannot draw */
    fun png(figure: Figure, width: Int = Chart.WIDTH, height: Int = Chart.HEIGHT): ByteArray = drawing {
        Png.encode(ImageSheet(width, height, PNG_SCALE).also { figure.draw(it, width, height) }.image)
    }

    private const val PNG_SCALE = 2
}
