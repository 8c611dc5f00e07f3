package daphnis.analysis.plot

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test
import java.awt.image.BufferedImage
import java.util.Random
import javax.imageio.ImageIO

class PngTest {
    @Test
    fun `every pixel comes back through another reader`() {
        val random = Random(4)
        for ((width, height) in listOf(1 to 1, 7 to 3, 200 to 131)) {
            val image = BufferedImage(width, height, BufferedImage.TYPE_INT_RGB)
            for (x in 0 until width) for (y in 0 until height) image.setRGB(x, y, random.nextInt())
            val read = ImageIO.read(Png.encode(image).inputStream())
            assertEquals(listOf(width, height), listOf(read.width, read.height))
            for (x in 0 until width) {
                for (y in 0 until height) {
                    assertEquals(image.getRGB(x, y), read.getRGB(x, y)) {
                        "at $x, $y"
                    }
                }
            }
        }
    }

    @Test
    fun `another kind of picture is refused`() {
        assertThrows(IllegalArgumentException::class.java) {
            Png.encode(BufferedImage(2, 2, BufferedImage.TYPE_INT_ARGB))
        }
    }
}
