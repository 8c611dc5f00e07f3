package daphnis.analysis.plot

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.xml.parsers.DocumentBuilderFactory

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

    @Test
    fun `the SVG is XML that a parser takes, whatever the title is`() {
        RunPlot.write(series(10) { 1.0 / (1 + it) }, home, "<my> & \u0007 run")
        val root = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(home.resolve("run.svg").toFile()).documentElement
        assertEquals(listOf("svg", "800", "640"), listOf(root.tagName, root.getAttribute("width"), root.getAttribute("height")))
        val texts = root.getElementsByTagName("text")
        assertTrue((0 until texts.length).any { texts.item(it).textContent == "<my> &   run" })
        assertEquals("time", texts.item(texts.length - 2).textContent)
    }

    @Test
    fun `lines go where the numbers are, the same in both formats`() {
        // The temperature is 1 but for one row of 3 in the middle: the line touches the top of its panel there, at x = 430 of 800 points.
        RunPlot.write(series(101) { if (it == 50) 3.0 else 1.0 }, home, "peak")
        val path = Regex("stroke=\"#1f4e79\"[^>]* d=\"M([^\"]*)\"").find(Files.readString(home.resolve("run.svg")))!!.groupValues[1]
        val points = path.split('L').map { p -> p.split(' ').map { it.toDouble() } }
        assertEquals(101, points.size)
        val peak = points.minBy { it[1] }
        assertEquals(430.0, peak[0], 0.01)
        // Room of a twentieth of the values above and below, on axes 244 points high.
        assertEquals(32 + 244 * 0.05 / 1.1, peak[1], 0.01)
        assertEquals(32 + 244 * 1.05 / 1.1, points.first()[1], 0.01)
        val picture = ImageIO.read(home.resolve("run.png").toFile())
        val ink = (0 until 640).filter { y -> isInk(picture.getRGB(860, y)) }
        assertTrue(ink.isNotEmpty() && ink.first() in 80..100) { "ink from $ink" }
    }

    private fun isInk(rgb: Int) = (rgb shr 16 and 255) < 120 && (rgb and 255) in 80..200

    @Test
    fun `a series without particles, and one that never changes, are drawn`() {
        val text = "step,time,particles,collisions,granular_temperature\n0,0.0,0,0,0.0\n1,1.0,0,0,0.0\n"
        RunPlot.write(Files.writeString(home.resolve("empty.csv"), text), home.resolve("empty"), "nobody")
        RunPlot.write(series(3) { 2.5 }, home.resolve("same"), "same")
        RunPlot.write(series(3) { Double.NaN }, home.resolve("none"), "none")
        for (name in listOf("empty", "same", "none")) assertEquals(1600, ImageIO.read(home.resolve("$name/run.png").toFile()).width)
    }

    @Test
    fun `the one rate of a run of one step is a dash in the middle`() {
        RunPlot.write(series(2) { 1.0 + it }, home, "step")
        val dash = Regex("stroke=\"#b3541e\"[^>]* d=\"M([0-9.]*) ([0-9.]*)L([0-9.]*) ([0-9.]*)\"").find(Files.readString(home.resolve("run.svg")))!!
        assertEquals(listOf(423.0, 474.0, 437.0, 474.0), dash.groupValues.drop(1).map { it.toDouble() })
    }

    @Test
    fun `what was prepared leaves nothing behind`() {
        RunPlot.prepare()
        assertEquals(0, Files.list(home).use { it.count() })
    }
}
