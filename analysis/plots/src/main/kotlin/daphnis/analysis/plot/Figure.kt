package daphnis.analysis.plot

/** Something that can be drawn at any size. The same figure draws the same. */
internal fun interface Figure {
    /** Draws all over [sheet], which is [width] by [height] points. */
    fun draw(sheet: Sheet, width: Int, height: Int)
}
