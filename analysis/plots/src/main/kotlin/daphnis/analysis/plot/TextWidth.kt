package daphnis.analysis.plot

/**
 * About how wide text is, in sizes of it: as in DejaVu Sans, which is among the widest of those that pictures are drawn
 * with. Widths asked of a font would differ between machines.
 */
internal object TextWidth {
    fun of(text: String): Double = text.sumOf { of(it) }

    private fun of(c: Char): Double = when (c) {
        in " .,·:;'|ijl()[]" -> NARROW
        in "⁰¹²³⁴⁵⁶⁷⁸⁹⁻" -> RAISED
        in "−+=<>±×mwMW%" -> WIDE
        else -> DIGIT
    }

    private const val NARROW = 0.39
    private const val RAISED = 0.48
    private const val DIGIT = 0.64
    private const val WIDE = 0.97
}
