package daphnis.analysis.movie

import java.awt.image.BufferedImage
import java.awt.image.DataBufferInt
import java.io.BufferedOutputStream
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * Animated GIF (GIF89a) that repeats for ever, in the colours of [GifPalette] for all frames. What a frame leaves as it
 * was is transparent. A delay is a whole number of hundredths of a second; the delays of frames differ by one so that
 * no time is lost or gained over the movie.
 */
internal class GifFile(
    path: Path,
    private val width: Int,
    private val height: Int,
    private val framesPerSecond: Double,
) : MovieFile {
    private val out: OutputStream = BufferedOutputStream(Files.newOutputStream(path), 1 shl 16)
    private val palette = GifPalette()
    private val before = ByteArray(width * height)
    private val indices = ByteArray(width * height)
    private var frames = 0L

    init {
        out.write("GIF89a".toByteArray())
        short(width)
        short(height)
        // A table of 256 colours for all frames; the background is its first.
        out.write(byteArrayOf(0xf7.toByte(), 0, 0))
        for (rgb in palette.colours) out.write(byteArrayOf((rgb shr 16).toByte(), (rgb shr 8).toByte(), rgb.toByte()))
        out.write(byteArrayOf(0x21, 0xff.toByte(), 11))
        out.write("NETSCAPE2.0".toByteArray())
        out.write(byteArrayOf(3, 1, 0, 0, 0))
    }

    override fun add(image: BufferedImage) {
        val pixels = (image.raster.dataBuffer as DataBufferInt).data
        for (k in indices.indices) {
            val index = palette.nearest(pixels[k]).toByte()
            indices[k] = if (frames > 0 && index == before[k]) GifPalette.TRANSPARENT.toByte() else index
            before[k] = index
        }
        // What stands stays; the index of what is transparent.
        out.write(byteArrayOf(0x21, 0xf9.toByte(), 4, 0x05))
        short(delay())
        out.write(byteArrayOf(GifPalette.TRANSPARENT.toByte(), 0))
        out.write(0x2c)
        short(0)
        short(0)
        short(width)
        short(height)
        out.write(0)
        Lzw(out).write(indices)
        frames++
    }

    /** Of the frame that comes next, in hundredths of a second. */
    private fun delay(): Int {
        fun end(frame: Long) = Math.round(frame * HUNDREDTHS / framesPerSecond)
        return (end(frames + 1) - end(frames)).toInt()
    }

    override fun finish() {
        out.write(0x3b)
        out.flush()
    }

    override fun close(): Unit = out.close()

    private fun short(value: Int) {
        out.write(value and 0xff)
        out.write(value shr 8)
    }

    private companion object {
        const val HUNDREDTHS = 100.0
    }
}
