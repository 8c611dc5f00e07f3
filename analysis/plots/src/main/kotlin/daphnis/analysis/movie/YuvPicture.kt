package daphnis.analysis.movie

import org.jcodec.common.model.ColorSpace
import org.jcodec.common.model.Picture

/**
 * A frame as the encoder of H.264 takes it: brightness per pixel and colour for two by two pixels, by ITU-R BT.709 in
 * the range of video.
 */
internal class YuvPicture(private val width: Int, private val height: Int) {
    // The encoder takes no other format; what it writes about the range is what is here.
    val picture: Picture = Picture.create(width, height, ColorSpace.YUV420J)

    /** @param pixels as 0xRRGGBB, row by row */
    fun take(pixels: IntArray) {
        val luma = picture.getPlaneData(0)
        for (k in 0 until width * height) luma[k] = byte(Y, pixels[k], LOWEST_LUMA)
        val blue = picture.getPlaneData(1)
        val red = picture.getPlaneData(2)
        for (j in 0 until height / 2) {
            for (i in 0 until width / 2) {
                val k = 2 * j * width + 2 * i
                val rgb = mean(pixels[k], pixels[k + 1], pixels[k + width], pixels[k + width + 1])
                blue[j * (width / 2) + i] = byte(CB, rgb, NO_COLOUR)
                red[j * (width / 2) + i] = byte(CR, rgb, NO_COLOUR)
            }
        }
    }

    private fun mean(a: Int, b: Int, c: Int, d: Int): Int {
        val even = (a and EVEN) + (b and EVEN) + (c and EVEN) + (d and EVEN)
        val green = (a and GREEN) + (b and GREEN) + (c and GREEN) + (d and GREEN)
        return (even + ROUND_EVEN shr 2 and EVEN) or (green + ROUND_GREEN shr 2 and GREEN)
    }

    /** The encoder's bytes are less by 128. */
    private fun byte(row: DoubleArray, rgb: Int, offset: Int): Byte {
        val value = row[0] * (rgb shr 16 and 0xff) + row[1] * (rgb shr 8 and 0xff) + row[2] * (rgb and 0xff)
        return (Math.round(value).toInt() + offset - 128).coerceIn(-128, 127).toByte()
    }

    private companion object {
        val Y = doubleArrayOf(0.1826, 0.6142, 0.0620)
        val CB = doubleArrayOf(-0.1006, -0.3386, 0.4392)
        val CR = doubleArrayOf(0.4392, -0.3989, -0.0403)
        const val LOWEST_LUMA = 16
        const val NO_COLOUR = 128
        const val EVEN = 0xff00ff
        const val GREEN = 0x00ff00
        const val ROUND_EVEN = 0x020002
        const val ROUND_GREEN = 0x000200
    }
}
