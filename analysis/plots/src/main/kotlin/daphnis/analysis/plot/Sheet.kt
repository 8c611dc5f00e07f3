package daphnis.analysis.plot

/** Where text stands against its point. */
internal enum class Anchor(val svg: String, val before: Double) {
    START("start", 0.0),
    MIDDLE("middle", 0.5),
    END("end", 1.0),
}

/** A white sheet to draw on, in points from its upper left corner. Colours are `#rrggbb`. */
internal interface Sheet {
    fun line(x1: Double, y1: Double, x2: Double, y2: Double, colour: String, width: Double)

    /**
     * A line through the points ([x], [y]), of which there are two or more.
     *
     * @param dashes lengths of dashes and of the gaps between them in turn; null for none
     */
    fun path(x: DoubleArray, y: DoubleArray, colour: String, width: Double, dashes: Dashes? = null)

    /** The inside of the closed line through the points ([x], [y]). */
    fun area(x: DoubleArray, y: DoubleArray, colour: String)

    /** The disc of radius [r] around ([x], [y]), or only its edge as a line of [width]. */
    fun disc(x: Double, y: Double, r: Double, colour: String, width: Double? = null)

    /** A rectangle of a mosaic, from its upper left corner ([x], [y]); those beside each other leave no seam. */
    fun tile(x: Double, y: Double, width: Double, height: Double, colour: String)

    /** Text in one line with its base line through ([x], [y]); [upright] text runs upwards. */
    fun text(text: String, x: Double, y: Double, size: Int, anchor: Anchor, upright: Boolean = false)
}

/** Lengths of the dashes and gaps of a line in turn, in widths of the line. */
internal class Dashes(vararg val lengths: Int)
