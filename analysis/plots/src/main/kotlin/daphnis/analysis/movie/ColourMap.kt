package daphnis.analysis.movie

/**
 * Colours for numbers from 0 to 1, of equal steps to the eye, told apart by colour-blind eyes and in grey (the maps
 * viridis and inferno of Smith and van der Walt, https://bids.github.io/colormap, in the public domain).
 */
internal class ColourMap private constructor(private val anchors: IntArray) {
    /** Red, green and blue as 0xRRGGBB at [t], which is brought into 0..1. */
    fun rgb(t: Double): Int {
        val place = t.coerceIn(0.0, 1.0) * (anchors.size - 1)
        val k = minOf(place.toInt(), anchors.size - 2)
        return mixed(anchors[k], anchors[k + 1], place - k)
    }

    companion object {
        /** For quantities of spheres; its dark end is left out, or slow spheres would be lost in space. */
        val QUANTITY = ColourMap(
            intArrayOf(0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725),
        )

        /** For the surface density: nothing is as dark as space. */
        val DENSITY = ColourMap(
            intArrayOf(
                SPACE, 0x1b0c41, 0x4a0c6b, 0x781c6d, 0xa52c60, 0xcf4446, 0xed6925, 0xfb9b06, 0xf7d13d, 0xfcffa4,
            ),
        )

        /** Where there is nothing: that of the report's pictures. */
        const val SPACE = 0x10141c

        /** What is behind a wall, likewise. */
        const val WALL = 0x4a5262

        /** Bodies, such as moonlets. */
        const val BODY = 0xf2efe6

        /** [a] and [b] in the proportion 1 − [t] to [t], by component. */
        fun mixed(a: Int, b: Int, t: Double): Int = part(a, b, t, RED) or part(a, b, t, GREEN) or part(a, b, t, BLUE)

        private fun part(a: Int, b: Int, t: Double, shift: Int): Int {
            val from = a shr shift and 0xff
            val to = b shr shift and 0xff
            return (from + (to - from) * t + 0.5).toInt().coerceIn(0, 255) shl shift
        }

        private const val RED = 16
        private const val GREEN = 8
        private const val BLUE = 0
    }
}
