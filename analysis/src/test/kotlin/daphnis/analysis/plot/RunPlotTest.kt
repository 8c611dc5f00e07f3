package daphnis.analysis.plot

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO

class RunPlotTest {
    @TempDir
    lateinit var home: Path

    private fun series(rows: Int, temperature: (Int) -> Double): Path {
        val text = (0 until rows).joinToString("\n", "step,time,particles,collisions,granular_temperature\n") { "$it,${it * 0.1},100,${it * 5},${temperature(it)}" }
        return Files.writeString(home.resolve("series.csv"), text + "\n")
    }

    @Test
    fun `a series becomes a picture of the right size with ink on it, and an SVG with its labels`() {
        RunPlot.write(series(5000) { 1.0 / (1 + it) }, home.resolve("plots"), "my run")
        val picture = ImageIO.read(home.resolve("plots/run.png").toFile())
        assertEquals(listOf(1600, 1280), listOf(picture.width, picture.height))
        val colours = HashSet<Int>()
        for (x in 0 until 1600 step 4) for (y in 0 until 1280) colours += picture.getRGB(x, y)
        assertTrue(colours.size > 10) { "the picture has ${colours.size} colours" }
        val svg = Files.readString(home.resolve("plots/run.svg"))
        for (label in listOf("my run", "granular temperature", "collisions of a sphere")) assertTrue(label in svg) { label }
    }

    @Test
    fun `a temperature that falls to zero is drawn too`() {
        RunPlot.write(series(3) { if (it == 2) 0.0 else 1.0 }, home, "cold")
        assertTrue(Files.size(home.resolve("run.png")) > 1000)
    }

    @Test
    fun `a series of one row is refused`() {
        assertThrows(IllegalArgumentException::class.java) { RunPlot.write(series(1) { 1.0 }, home, "short") }
    }
}
