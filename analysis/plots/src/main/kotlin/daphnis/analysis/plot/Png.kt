package daphnis.analysis.plot

import java.awt.image.BufferedImage
import java.awt.image.DataBufferInt
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.util.zip.CRC32
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream

/**
 * PNG (ISO/IEC 15948) of an RGB picture, 8 bits a colour, without filters: a fraction of the time that the Java library
 * needs for its first one.
 */
internal object Png {
    private val SIGNATURE =
        byteArrayOf(0x89.toByte(), 'P'.code.toByte(), 'N'.code.toByte(), 'G'.code.toByte(), 13, 10, 26, 10)
    private const val BITS = 8
    private const val RGB = 2

    /** @param image of the type `TYPE_INT_RGB` */
    fun encode(image: BufferedImage): ByteArray {
        require(image.type == BufferedImage.TYPE_INT_RGB) { "image has type ${image.type}; it must be TYPE_INT_RGB" }
        val bytes = ByteArrayOutputStream()
        val out = DataOutputStream(bytes)
        out.write(SIGNATURE)
        chunk(out, "IHDR") {
            it.writeInt(image.width)
            it.writeInt(image.height)
            // Deflate, no filter, not interlaced.
            it.write(byteArrayOf(BITS.toByte(), RGB.toByte(), 0, 0, 0))
        }
        chunk(out, "IDAT") { it.write(deflated(image)) }
        chunk(out, "IEND") { }
        return bytes.toByteArray()
    }

    private fun deflated(image: BufferedImage): ByteArray {
        val pixels = (image.raster.dataBuffer as DataBufferInt).data
        val bytes = ByteArrayOutputStream()
        val deflater = Deflater(Deflater.BEST_SPEED)
        DeflaterOutputStream(bytes, deflater, 1 shl 16).use { out ->
            // A row begins with its filter: 0, none.
            val row = ByteArray(1 + 3 * image.width)
            for (y in 0 until image.height) {
                for (x in 0 until image.width) {
                    val rgb = pixels[y * image.width + x]
                    row[3 * x + 1] = (rgb shr 16).toByte()
                    row[3 * x + 2] = (rgb shr 8).toByte()
                    row[3 * x + 3] = rgb.toByte()
                }
                out.write(row)
            }
        }
        deflater.end()
        return bytes.toByteArray()
    }

    private fun chunk(out: DataOutputStream, name: String, write: (DataOutputStream) -> Unit) {
        val content = ByteArrayOutputStream()
        DataOutputStream(content).use {
            it.writeBytes(name)
            write(it)
        }
        val bytes = content.toByteArray()
        out.writeInt(bytes.size - name.length)
        out.write(bytes)
        out.writeInt(CRC32().apply { update(bytes) }.value.toInt())
    }
}
