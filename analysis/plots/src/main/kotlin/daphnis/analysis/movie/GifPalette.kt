package daphnis.analysis.movie

import java.awt.image.DataBuffer
import java.awt.image.IndexColorModel

/**
 * 256 colours for all frames: greys for the legend, and each colour of the maps from dark to bright. Fixed, so that a
 * colour means one number in all frames.
 */
internal class GifPalette {
    /** As 0xRRGGBB; that of [TRANSPARENT] is never seen. */
    val colours: IntArray = IntArray(SIZE)

    /** The nearest index to each colour of five bits per component, found when it is asked for; −1 before. */
    private val known = IntArray(1 shl 15) { -1 }

    init {
        var n = 1
        colours[n++] = ColourMap.SPACE
        colours[n++] = Legend.GROUND
        for (k in 0 until GREYS) colours[n++] = ColourMap.mixed(Legend.GROUND, 0xffffff, (k + 1.0) / GREYS)
        for (k in 0 until DENSITIES) colours[n++] = ColourMap.DENSITY.rgb((k + 0.5) / DENSITIES)
        val hues = (SIZE - n) / SHADES
        for (k in 0 until hues) {
            val hue = ColourMap.QUANTITY.rgb(k / (hues - 1.0))
            for (s in 1..SHADES) colours[n++] = ColourMap.mixed(ColourMap.SPACE, hue, s.toDouble() / SHADES)
        }
    }

    /** Of images whose pixels are indices. */
    val model: IndexColorModel get() = IndexColorModel(8, SIZE, colours, 0, false, TRANSPARENT, DataBuffer.TYPE_BYTE)

    fun nearest(rgb: Int): Int {
        val colour = rgb and 0xffffff
        if (colour == ColourMap.SPACE) return 1
        val slot = (colour shr 9 and 0x7c00) or (colour shr 6 and 0x3e0) or (colour shr 3 and 0x1f)
        if (known[slot] < 0) {
            // The middle of all colours that share the slot.
            val middle = colour and 0xf8f8f8 or 0x040404
            known[slot] = (1 until SIZE).minBy { distance(colours[it], middle) }
        }
        return known[slot]
    }

    private fun distance(a: Int, b: Int): Int {
        val red = (a shr 16 and 0xff) - (b shr 16 and 0xff)
        val green = (a shr 8 and 0xff) - (b shr 8 and 0xff)
        val blue = (a and 0xff) - (b and 0xff)
        // The eye tells greens apart better than reds, and reds better than blues.
        return 3 * red * red + 4 * green * green + 2 * blue * blue
    }

    companion object {
        const val SIZE = 256

        /** Index of what is as it was in the frame before. */
        const val TRANSPARENT = 0
        private const val GREYS = 13
        private const val DENSITIES = 48
        private const val SHADES = 8
    }
}
