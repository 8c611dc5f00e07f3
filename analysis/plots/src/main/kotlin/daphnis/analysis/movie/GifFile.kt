package daphnis.analysis.movie

import java.awt.image.BufferedImage
import java.awt.image.DataBufferByte
import java.awt.image.DataBufferInt
import java.nio.file.Path
import javax.imageio.IIOImage
import javax.imageio.ImageIO
import javax.imageio.ImageTypeSpecifier
import javax.imageio.ImageWriteParam
import javax.imageio.ImageWriter
import javax.imageio.metadata.IIOMetadata
import javax.imageio.metadata.IIOMetadataNode
import javax.imageio.stream.FileImageOutputStream

/**
 * Animated GIF that repeats for ever, by the writer of the Java library, in the colours of [GifPalette] for all frames.
 * What a frame leaves as it was is transparent. A delay is a whole number of hundredths of a second; the delays of
 * frames differ by one so that no time is lost or gained over the movie.
 */
internal class GifFile(path: Path, width: Int, height: Int, private val framesPerSecond: Double) : MovieFile {
    override val writer: String = "ImageIO"
    private val palette = GifPalette()
    private val before = ByteArray(width * height)
    private val frame = BufferedImage(width, height, BufferedImage.TYPE_BYTE_INDEXED, palette.model)
    private val indices = (frame.raster.dataBuffer as DataBufferByte).data
    private val encoder: ImageWriter = ImageIO.getImageWritersByFormatName("gif").next()
    private val settings = encoder.defaultWriteParam.apply { progressiveMode = ImageWriteParam.MODE_DISABLED }

    // `createFromRenderedImage` would be of the colours of the web.
    private val type = ImageTypeSpecifier(frame)
    private val out = FileImageOutputStream(path.toFile())
    private var frames = 0L

    init {
        encoder.output = out
        encoder.prepareWriteSequence(null)
    }

    override fun add(image: BufferedImage) {
        val pixels = (image.raster.dataBuffer as DataBufferInt).data
        for (k in indices.indices) {
            val index = palette.nearest(pixels[k]).toByte()
            indices[k] = if (frames > 0 && index == before[k]) GifPalette.TRANSPARENT.toByte() else index
            before[k] = index
        }
        encoder.writeToSequence(IIOImage(frame, null, metadata()), settings)
        frames++
    }

    private fun metadata(): IIOMetadata {
        val metadata = encoder.getDefaultImageMetadata(type, settings)
        val root = metadata.getAsTree(metadata.nativeMetadataFormatName) as IIOMetadataNode
        val control = root.getElementsByTagName("GraphicControlExtension").item(0) as IIOMetadataNode
        control.setAttribute("disposalMethod", "doNotDispose")
        control.setAttribute("delayTime", "${delay()}")
        if (frames == 0L) {
            val repeats = IIOMetadataNode("ApplicationExtension")
            repeats.setAttribute("applicationID", "NETSCAPE")
            repeats.setAttribute("authenticationCode", "2.0")
            repeats.userObject = byteArrayOf(1, 0, 0)
            root.appendChild(IIOMetadataNode("ApplicationExtensions").apply { appendChild(repeats) })
        }
        metadata.setFromTree(metadata.nativeMetadataFormatName, root)
        return metadata
    }

    /** Of the frame that comes next, in hundredths of a second. */
    private fun delay(): Int {
        fun end(frame: Long) = Math.round(frame * HUNDREDTHS / framesPerSecond)
        return (end(frames + 1) - end(frames)).toInt()
    }

    override fun finish() {
        encoder.endWriteSequence()
        out.flush()
    }

    override fun close() {
        encoder.dispose()
        out.close()
    }

    private companion object {
        const val HUNDREDTHS = 100.0
    }
}
