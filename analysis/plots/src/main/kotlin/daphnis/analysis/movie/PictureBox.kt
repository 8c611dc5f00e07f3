package daphnis.analysis.movie

import daphnis.analysis.insitu.State
import daphnis.core.boundary.prepare
import daphnis.core.space.Images
import kotlin.math.roundToInt

/**
 * The box of a [state] in a picture with the axes of a [Sight], and the images beyond its faces. Where the box changes,
 * the window is that of the widest, and a narrower one fills a part of it: columns from [firstColumn] until
 * [endColumn], rows from [firstRow] until [endRow]. Along axes without images it has no ends.
 */
internal class PictureBox(private val state: State, private val view: Viewport, sight: Sight) {
    private val across = sight.across
    private val up = sight.up
    private val box = state.boundary.box
    private val images = Images().apply { prepare(state.boundary, state.time) }
    private val window = view.window

    val firstColumn: Int
    val endColumn: Int
    val firstRow: Int
    val endRow: Int

    init {
        fun cut(axis: Int, isNarrower: Boolean, place: Double, whole: Int) =
            if (images.period(axis) > 0 && isNarrower) place.roundToInt() else whole
        firstColumn = cut(across, box.lower(across) > window.left, view.x(box.lower(across)), view.firstColumn)
        endColumn = cut(across, box.upper(across) < window.right, view.x(box.upper(across)), view.endColumn)
        firstRow = cut(up, box.upper(up) < window.top, view.y(box.upper(up)), 0)
        endRow = cut(up, box.lower(up) > window.bottom, view.y(box.lower(up)), view.height)
    }

    /** Whether it fills less than the window. */
    val isPart: Boolean get() = firstColumn > view.firstColumn || endColumn < view.endColumn ||
        firstRow > 0 || endRow < view.height

    fun period(axis: Int): Double = images.period(axis)

    fun shift(code: Int, axis: Int): Double = images.shift(code, axis)

    /** Whether sphere [k] is nearer than [distance] to a face that is seen and has images beyond it. */
    fun isNear(k: Int, distance: Double): Boolean = isNear(across, k, distance) || isNear(up, k, distance)

    private fun isNear(axis: Int, k: Int, distance: Double): Boolean {
        val place = state.population.position(axis)[k]
        return images.period(axis) > 0 && (place - distance < box.lower(axis) || place + distance > box.upper(axis))
    }

    /** Codes of a sphere and its images that may be seen, itself among them. */
    val codes: IntArray = run {
        fun reach(axis: Int): IntRange {
            val isSeen = axis == across || axis == up
            return if (isSeen && images.period(axis) > 0) -REACH..REACH else 0..0
        }
        val list = ArrayList<Int>()
        for (iz in reach(2)) {
            for (iy in reach(1)) {
                for (ix in reach(0)) list += Images.code(ix, iy, iz)
            }
        }
        list.toIntArray()
    }

    private companion object {
        /** Two boxes away along the slide, since images are displaced by up to one. */
        const val REACH = 2
    }
}
