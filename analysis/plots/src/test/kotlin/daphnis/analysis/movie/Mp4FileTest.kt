package daphnis.analysis.movie

import org.jcodec.api.FrameGrab
import org.jcodec.common.io.NIOUtils
import org.jcodec.common.model.Picture
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.awt.image.BufferedImage
import java.nio.file.Path
import java.util.Random

/** What is written is decoded again. */
class Mp4FileTest {
    @TempDir
    lateinit var home: Path

    private fun frame(width: Int, height: Int, rgb: (Int, Int) -> Int) =
        BufferedImage(width, height, BufferedImage.TYPE_INT_RGB).apply {
            for (y in 0 until height) for (x in 0 until width) setRGB(x, y, rgb(x, y))
        }

    private fun decoded(frames: List<BufferedImage>, act: (FrameGrab, Int, Picture) -> Unit) {
        val path = home.resolve("movie.mp4")
        Mp4File(path, frames[0].width, frames[0].height, 25.0).use { file ->
            frames.forEach(file::add)
            file.finish()
        }
        NIOUtils.readableChannel(path.toFile()).use { channel ->
            val grab = FrameGrab.createFrameGrab(channel)
            var k = 0
            while (true) {
                val picture = grab.nativeFrame ?: break
                act(grab, k++, picture)
            }
            assertEquals(frames.size, k)
        }
    }

    /** Below noise, whose edges lead an encoder astray that smooths before it predicts, flat colour stays. */
    @Test
    fun `colours do not drift over a frame, nor from one to the next`() {
        val random = Random(7)
        val flat = 0x20242c
        // Faint enough to be smoothed at coarse steps: ±16 of each component.
        val frames = List(4) {
            frame(320, 336) { _, y -> if (y < 288) 0x304050 + (random.nextInt() and 0x1f1f1f) else flat }
        }
        decoded(frames) { _, k, picture ->
            val luma = picture.getPlaneData(0)
            val blue = picture.getPlaneData(1)
            val red = picture.getPlaneData(2)
            // 16 + 0.1826 · 32 + 0.6142 · 36 + 0.0620 · 44 = 46.7, and so on; the decoder's bytes are less by 128.
            for (x in 16 until 304) {
                val y = 320
                assertTrue(Math.abs(luma[y * picture.width + x] + 128 - 47) <= 3) { "luma of frame $k at $x" }
                val chroma = y / 2 * (picture.width / 2) + x / 2
                assertTrue(Math.abs(blue[chroma] + 128 - 132) <= 3) { "blue of frame $k at $x: ${blue[chroma] + 128}" }
                assertTrue(Math.abs(red[chroma] + 128 - 126) <= 3) { "red of frame $k at $x: ${red[chroma] + 128}" }
            }
        }
    }

    @Test
    fun `frames have the size that was asked for, also beyond whole blocks`() {
        decoded(List(2) { frame(250, 118) { x, y -> x * y } }) { _, _, picture ->
            assertEquals(250, picture.croppedWidth)
            assertEquals(118, picture.croppedHeight)
        }
    }

    @Test
    fun `odd sizes are refused`() {
        for ((width, height) in listOf(251 to 118, 250 to 117)) {
            assertThrows(IllegalArgumentException::class.java) { Mp4File(home.resolve("a.mp4"), width, height, 25.0) }
        }
    }
}
