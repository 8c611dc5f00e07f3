package daphnis.analysis.movie

import daphnis.analysis.plot.PlotScale

/**
 * What all frames of a movie have in common.
 *
 * @property sight which axes the picture has
 * @property isImage whether most particles are smaller than what is drawn as a disc, and make an image of their
 *   surface density together
 * @property cell of the surface density, in pixels; [passes] of smoothing follow
 * @property colours what the ends of the colour bar stand for
 * @property materials names of those that have a colour, by number, ascending; empty for other quantities
 * @property bright the surface density that is as bright as can be
 */
internal class Scene(
    val options: MovieOptions,
    val view: Viewport,
    val sight: Sight,
    val isImage: Boolean,
    val cell: Int,
    val passes: Int,
    val colours: ColourRange,
    val bright: Double,
    val scale: PlotScale,
    val materials: Map<Int, String> = emptyMap(),
) {
    /** Whether a sphere of [radius] is drawn as a disc, in a movie in which most are not. */
    fun isDisc(radius: Double): Boolean = isDisc(view, radius)

    companion object {
        /** A disc is at least two pixels wide. */
        fun isDisc(view: Viewport, radius: Double): Boolean = 2 * radius * minOf(view.scaleX, view.scaleY) >= 2.0
    }
}
