package daphnis.analysis.movie

import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.sqrt

/** Draws shaded discs into [pixels] in rows of the width of [view], cut at the border of a box. */
internal class DiscRaster(private val pixels: IntArray, private val view: Viewport) {
    /**
     * A sphere, of which what is in [box] is seen, at the pixel ([x], [y]) with half widths [across] and [above], lit from
     * the upper left. One that is smaller than a pixel covers as much of one as it is large.
     */
    fun draw(box: PictureBox, x: Double, y: Double, across: Double, above: Double, rgb: Int) {
        val rx = maxOf(across, LEAST)
        val ry = maxOf(above, LEAST)
        val opacity = across * above / (rx * ry)
        val edge = minOf(rx, ry)
        val isShaded = edge > SHADED
        val left = maxOf(floor(x - rx - 0.5).toInt(), box.firstColumn)
        val right = minOf(ceil(x + rx + 0.5).toInt(), box.endColumn - 1)
        val top = maxOf(floor(y - ry - 0.5).toInt(), box.firstRow)
        val bottom = minOf(ceil(y + ry + 0.5).toInt(), box.endRow - 1)
        for (j in top..bottom) {
            val v = (j + 0.5 - y) / ry
            for (i in left..right) {
                val u = (i + 0.5 - x) / rx
                val square = u * u + v * v
                val covered = ((1 - sqrt(square)) * edge + 0.5).coerceIn(0.0, 1.0)
                if (covered == 0.0) continue
                val light = if (isShaded) light(u, v, square) else FLAT
                val k = j * view.width + i
                val colour = ColourMap.mixed(0, rgb, light)
                pixels[k] = ColourMap.mixed(pixels[k], colour, covered * opacity)
            }
        }
    }

    private fun light(u: Double, v: Double, square: Double): Double {
        val towards = sqrt(maxOf(0.0, 1 - square))
        return DARK + (1 - DARK) * maxOf(0.0, LIGHT * towards - SLANT * (u + v))
    }

    private companion object {
        const val LEAST = 0.6
        const val SHADED = 1.5
        const val FLAT = 0.85
        const val DARK = 0.25

        /** The direction of the light: (−SLANT, −SLANT, LIGHT), of length 1. */
        const val SLANT = 0.42
        const val LIGHT = 0.80448741444475
    }
}
