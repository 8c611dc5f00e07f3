package daphnis.analysis.plot

import daphnis.analysis.requireReplacedWhole
import daphnis.analysis.series.SeriesTable
import daphnis.analysis.table.UnitNames
import daphnis.core.format.FormatException
import daphnis.core.input.UnitsSpec
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
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

    private val gas = PlotScale(UnitNames(UnitsSpec()), null, 1.0)
    private val ring = PlotScale(UnitNames(UnitsSpec(100.0, 1.0, 1.0)), 2 * Math.PI / 10, 1.5)

    private fun series(rows: Int, temperature: (Int) -> Double): Path {
        val text = (0 until rows).joinToString("\n", "step,time,particles,collisions,granular_temperature\n") {
            "$it,${it * 0.1},100,${it * 5},${temperature(it)}"
        }
        return Files.writeString(home.resolve("series.csv"), text + "\n")
    }

    private fun svg(file: Path, scale: PlotScale): String {
        RunPlot.write(file, home.resolve("plots"), "my run", scale)
        return Files.readString(home.resolve("plots/run.svg"))
    }

    @Test
    fun `pictures are replaced whole`() {
        val file = series(50) { 1.0 / (1 + it) }
        requireReplacedWhole(home.resolve("plots"), files = 2) { svg(file, gas) }
    }

    @Test
    fun `a series becomes a picture of the right size with ink on it, and an SVG with its labels`() {
        val svg = svg(series(5000) { 1.0 / (1 + it) }, gas)
        val picture = ImageIO.read(home.resolve("plots/run.png").toFile())
        assertEquals(listOf(1600, 1280), listOf(picture.width, picture.height))
        val colours = HashSet<Int>()
        for (x in 0 until 1600 step 4) for (y in 0 until 1280) colours += picture.getRGB(x, y)
        assertTrue(colours.size > 10) { "the picture has ${colours.size} colours" }
        for (label in listOf("my run", "granular temperature", "collisions per particle")) {
            assertTrue(label in svg) {
                label
            }
        }
    }

    @Test
    fun `axes have units, in Hill's frame orbits and r times Omega`() {
        val ofGas = svg(series(50) { 1.0 }, gas)
        for (label in listOf("time [units of time]", "[units of length²/time²]", "[1/(unit of time)]")) {
            assertTrue(label in ofGas) { label }
        }
        val ofRing = svg(series(50) { 1.0 }, ring)
        for (label in listOf("time [orbits]", "[(r Ω)²]", "[1/orbit]")) assertTrue(label in ofRing) { label }
    }

    @Test
    fun `an axis that is logarithmic says so, and no other`() {
        assertFalse("log scale" in svg(series(50) { 1.0 + 0.05 * it }, gas))
        assertTrue("[units of length²/time²] (log scale)" in svg(series(50) { 1.0 / (1 + it) }, gas))
    }

    @Test
    fun `curves in Hill's frame count orbits, r Omega and collisions an orbit`() {
        val plots = SeriesPlots(SeriesTable.read(series(101) { 3.0 }), ring)
        val temperature = plots.temperature()!!
        assertEquals(1.0, temperature.x.last(), 1e-12)
        assertEquals(3.0 / (1.5 * 2 * Math.PI / 10).let { it * it }, temperature.y[0], 1e-12)
        // 5 collisions of 100 particles in 0.1: a particle has one in a unit of time, 10 in an orbit.
        val rate = plots.collisionRate()!!
        assertEquals(10.0, rate.y.average(), 1e-9)
        assertEquals(0.005, rate.x[0], 1e-12)
        assertTrue(plots.energies().isEmpty())
    }

    @Test
    fun `energies are the columns that are called so`() {
        val text = "time,particles,collisions,kinetic_energy,hill_energy,other_energy\n0,1,0,2,3,\n1,1,0,4,5,\n"
        val plots = SeriesPlots(SeriesTable.read(Files.writeString(home.resolve("e.csv"), text)), gas)
        assertEquals(listOf("kinetic", "Hill's"), plots.energies().map { it.name })
        assertEquals(listOf(3.0, 5.0), plots.energies()[1].y.asList())
        assertEquals(null, plots.temperature())
        val free = "time,particles,collisions,kinetic_energy,potential_energy,total_energy\n0,1,0,2,0,2\n1,1,0,4,0,4\n"
        val ofFree = SeriesPlots(SeriesTable.read(Files.writeString(home.resolve("free.csv"), free)), gas)
        assertEquals(listOf("kinetic"), ofFree.energies().map { it.name })
    }

    @Test
    fun `a temperature that falls to zero is drawn too`() {
        RunPlot.write(series(3) { if (it == 2) 0.0 else 1.0 }, home, "cold", gas)
        val points = temperatures()
        assertEquals(3, points.size)
        assertEquals(points[0][1], points[1][1])
        // The top and the bottom of the panel are a twentieth of the values away.
        assertEquals(244 / 1.1, points[2][1] - points[0][1], 0.01)
    }

    @Test
    fun `a series of one row is refused, a damaged one is named`() {
        assertThrows(FormatException::class.java) { RunPlot.write(series(1) { 1.0 }, home, "short", gas) }
        val damaged = Files.writeString(home.resolve("bad.csv"), "time,particles,collisions\n0,1,0\nx,1,0\n")
        assertTrue(
            "bad.csv:3" in
                assertThrows(FormatException::class.java) { RunPlot.write(damaged, home, "bad", gas) }.message!!,
        )
    }

    @Test
    fun `that of a page can be read where it is 300 pixels wide, and its numbers stand apart`() {
        RunPlot.write(series(101) { 1.0 + it }, home, "wide", gas)
        val svg = RunPlot.svg(home.resolve("series.csv"), "wide", gas)!!
        val sheet = Regex("<svg [^>]* width=\"([0-9]+)\"").find(svg)!!.groupValues[1].toInt()
        val texts = Regex(
            "translate\\(([0-9.]+) ([0-9.]+)\\)\" font-size=\"([0-9]+)\" text-anchor=\"middle\"[^>]*>([^<]*)<",
        )
            .findAll(svg).map { it.groupValues.drop(1) }.toList()
        assertTrue(texts.isNotEmpty() && texts.all { it[2].toDouble() * 300 / sheet >= 11 }) { "$sheet $texts" }
        val numbers = texts.filter { it[3].toDoubleOrNull() != null }.groupBy { it[1] }.values
        assertEquals(2, numbers.size)
        for (row in numbers) {
            for ((one, next) in row.zipWithNext()) {
                val wide = 0.6 * one[2].toInt() * (one[3].length + next[3].length) / 2
                assertTrue(next[0].toDouble() - one[0].toDouble() > wide) { "$row" }
            }
        }
    }

    @Test
    fun `the SVG is XML that a parser takes, whatever the title is`() {
        RunPlot.write(series(10) { 1.0 / (1 + it) }, home, "<my> & \u0007\u202e\u009b\uffff run", gas)
        val root = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(
            home.resolve("run.svg").toFile(),
        ).documentElement
        assertEquals(
            listOf("svg", "800", "640"),
            listOf(root.tagName, root.getAttribute("width"), root.getAttribute("height")),
        )
        val texts = root.getElementsByTagName("text")
        assertTrue((0 until texts.length).any { texts.item(it).textContent == "<my> & \\u0007\\u202e\\u009b  run" })
        assertEquals("time [units of time]", texts.item(texts.length - 3).textContent)
    }

    @Test
    fun `lines go where the numbers are, the same in both formats`() {
        // The temperature is 1 but for one row of 3 in the middle: the line touches the top of its panel there, at x =
        // 440 of 800 points.
        RunPlot.write(series(101) { if (it == 50) 3.0 else 1.0 }, home, "peak", gas)
        val points = temperatures()
        assertEquals(101, points.size)
        val peak = points.minBy { it[1] }
        assertEquals(440.0, peak[0], 0.01)
        // Room of a twentieth of the values above and below, on axes 244 points high.
        assertEquals(32 + 244 * 0.05 / 1.1, peak[1], 0.01)
        assertEquals(32 + 244 * 1.05 / 1.1, points.first()[1], 0.01)
        val picture = ImageIO.read(home.resolve("run.png").toFile())
        val ink = (0 until 640).filter { y -> isInk(picture.getRGB(880, y)) }
        assertTrue(ink.isNotEmpty() && ink.first() in 80..100) { "ink from $ink" }
    }

    /** The points of the line of the temperature, x and y from the upper left. */
    private fun temperatures(): List<List<Double>> {
        val line = Regex("stroke=\"#1f4e79\"[^>]* d=\"M([^\"]*)\"")
        val path = line.find(Files.readString(home.resolve("run.svg")))!!.groupValues[1]
        return path.split('L').map { p -> p.split(' ').map { it.toDouble() } }
    }

    private fun isInk(rgb: Int) = (rgb shr 16 and 255) < 120 && (rgb and 255) in 80..200

    @Test
    fun `a series without particles, and one that never changes, are drawn`() {
        val text = "step,time,particles,collisions,granular_temperature\n0,0.0,0,0,0.0\n1,1.0,0,0,0.0\n"
        RunPlot.write(Files.writeString(home.resolve("empty.csv"), text), home.resolve("empty"), "nobody", gas)
        RunPlot.write(series(3) { 2.5 }, home.resolve("same"), "same", gas)
        RunPlot.write(series(3) { Double.NaN }, home.resolve("none"), "none", gas)
        for (name in listOf(
            "empty",
            "same",
            "none",
        )) {
            assertEquals(1600, ImageIO.read(home.resolve("$name/run.png").toFile()).width)
        }
    }

    @Test
    fun `rates that are small numbers of collisions stand on an axis from 0, steady ones do not`() {
        fun heights(vararg collisions: Int): List<Double> {
            val rows = collisions.withIndex().joinToString("") { (k, c) -> "$k,$k.0,100,$c,1.0\n" }
            val text = "step,time,particles,collisions,granular_temperature\n$rows"
            RunPlot.write(Files.writeString(home.resolve("few.csv"), text), home, "few", gas)
            val line = Regex("stroke=\"#b3541e\"[^>]* d=\"M([^\"]*)\"")
            val path = line.find(Files.readString(home.resolve("run.svg")))!!.groupValues[1]
            // The panel of rates ends 44 points above the lower edge of the picture.
            return path.split('L').map { 596 - it.substringAfter(' ').toDouble() }
        }
        val few = heights(0, 0, 2, 3, 3)
        assertEquals(0.0, few[0])
        assertEquals(2.0, few[1] / few[2], 1e-3)
        assertEquals(listOf(0.0, 0.0), heights(0, 0, 0))
        val steady = heights(0, 101, 200, 300)
        assertEquals(244 * 0.05 / 1.1, steady.min(), 0.01)
        assertEquals(244 * 1.05 / 1.1, steady.max(), 0.01)
    }

    @Test
    fun `the one rate of a run of one step is a dash in the middle`() {
        RunPlot.write(series(2) { 1.0 + it }, home, "step", gas)
        val dash = Regex(
            "stroke=\"#b3541e\"[^>]* d=\"M([0-9.]*) ([0-9.]*)L([0-9.]*) ([0-9.]*)\"",
        ).find(Files.readString(home.resolve("run.svg")))!!
        assertEquals(listOf(433.0, 474.0, 447.0, 474.0), dash.groupValues.drop(1).map { it.toDouble() })
    }

    @Test
    fun `what was prepared leaves nothing behind`() {
        RunPlot.prepare()
        assertEquals(0, Files.list(home).use { it.count() })
    }
}
