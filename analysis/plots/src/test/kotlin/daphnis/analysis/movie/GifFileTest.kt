package daphnis.analysis.movie

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.w3c.dom.Node
import java.awt.image.BufferedImage
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import javax.imageio.ImageIO
import javax.imageio.metadata.IIOMetadataNode

/** What is written is read back with the Java library's reader. */
class GifFileTest {
    @TempDir
    lateinit var home: Path

    private fun write(frames: List<BufferedImage>, framesPerSecond: Double): Path {
        val path = home.resolve("movie.gif")
        GifFile(path, frames[0].width, frames[0].height, framesPerSecond).use { file ->
            frames.forEach(file::add)
            file.finish()
        }
        return path
    }

    private fun <T> read(path: Path, act: (javax.imageio.ImageReader) -> T): T =
        ImageIO.createImageInputStream(path.toFile()).use { input ->
            val reader = ImageIO.getImageReadersByFormatName("gif").next()
            reader.input = input
            act(reader)
        }

    private fun entry(reader: javax.imageio.ImageReader, frame: Int, name: String): IIOMetadataNode {
        val metadata = reader.getImageMetadata(frame)
        var node: Node? = metadata.getAsTree(metadata.nativeMetadataFormatName).firstChild
        while (node!!.nodeName != name) node = node.nextSibling
        return node as IIOMetadataNode
    }

    /** Of colours of the palette, so that nothing is lost: noise, which fills the table of codes many times over. */
    private fun noise(width: Int, height: Int, seed: Long): BufferedImage {
        val colours = GifPalette().colours
        val random = Random(seed)
        return BufferedImage(width, height, BufferedImage.TYPE_INT_RGB).apply {
            for (y in 0 until height) for (x in 0 until width) setRGB(x, y, colours[1 + random.nextInt(255)])
        }
    }

    @Test
    fun `frames come back as they were, whatever stays from one to the next`() {
        val first = noise(211, 97, 1)
        val second = noise(211, 97, 2)
        // The upper half stays.
        for (y in 0 until 48) for (x in 0 until 211) second.setRGB(x, y, first.getRGB(x, y))
        val frames = listOf(first, second, second, noise(211, 97, 3))
        val shown = BufferedImage(211, 97, BufferedImage.TYPE_INT_RGB)
        val palette = GifPalette()
        fun near(rgb: Int) = palette.colours[palette.nearest(rgb)]
        read(write(frames, 10.0)) { reader ->
            assertEquals(frames.size, reader.getNumImages(true))
            for (k in frames.indices) {
                shown.createGraphics().apply { drawImage(reader.read(k), 0, 0, null) }.dispose()
                for (y in 0 until 97) {
                    for (x in 0 until 211) {
                        assertEquals(near(frames[k].getRGB(x, y)), shown.getRGB(x, y) and 0xffffff) { "$k: $x $y" }
                    }
                }
            }
        }
    }

    @Test
    fun `delays are whole hundredths of a second, and no time is lost over the movie`() {
        val frames = List(31) { noise(8, 8, 1) }
        for ((rate, total) in listOf(30.0 to 103, 25.0 to 124, 7.0 to 443)) {
            read(write(frames, rate)) { reader ->
                val delays = frames.indices.map {
                    entry(reader, it, "GraphicControlExtension").getAttribute("delayTime").toInt()
                }
                assertEquals(total, delays.sum()) { "$rate" }
                assertTrue(delays.max() - delays.min() <= 1) { "$delays" }
            }
        }
    }

    @Test
    fun `it repeats for ever`() {
        val bytes = String(Files.readAllBytes(write(listOf(noise(8, 8, 1)), 25.0)), Charsets.ISO_8859_1)
        assertTrue("NETSCAPE2.0\u0003\u0001\u0000\u0000\u0000" in bytes)
    }

    @Test
    fun `the palette holds space, and each colour of the maps to within what is seen`() {
        val palette = GifPalette()
        assertEquals(ColourMap.SPACE, palette.colours[palette.nearest(ColourMap.SPACE)])
        for (map in listOf(ColourMap.QUANTITY, ColourMap.DENSITY)) {
            for (k in 0..100) {
                val wanted = map.rgb(k / 100.0)
                val found = palette.colours[palette.nearest(wanted)]
                for (shift in listOf(0, 8, 16)) {
                    val apart = Math.abs((wanted shr shift and 0xff) - (found shr shift and 0xff))
                    assertTrue(apart <= 20) { "%06x is %06x".format(wanted, found) }
                }
            }
        }
    }
}
