package daphnis.analysis.report

import daphnis.analysis.brightness.ObservedBrightness
import daphnis.analysis.brightness.PhaseTable
import daphnis.analysis.brightness.ScatteringLaw
import daphnis.analysis.input.AnalysisInput
import daphnis.core.input.InputException
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class BrightnessReportTest {
    @TempDir
    lateinit var directory: Path

    private fun run(name: String, vararg settings: String): Path {
        val path = directory.resolve(name)
        val all = listOf("untilOrbits=2", "box.lengths=[40,40,20]", "output.snapshotEvery=20") + settings
        Run.start(BuiltIn.scenario("ring-patch", all), name, path).use { it.execute() }
        return path
    }

    private fun table(path: Path, name: String): Map<String, List<String>> {
        val rows = Files.readAllLines(path.resolve("tables/$name.csv")).map { it.split(',') }
        return rows[0].withIndex().associate { (k, head) -> head.substringBefore(" [") to rows.drop(1).map { it[k] } }
    }

    private fun Map<String, List<String>>.numbers(name: String) = getValue(name).map { it.toDouble() }.toDoubleArray()

    @Test
    fun `brightness over the grid, phases and beside what was observed is on the page and in tables`() {
        val path = run("ring")
        val seen = Files.writeString(
            directory.resolve("seen.csv"),
            "elevation,azimuth,light_elevation,phase_angle,i_over_f,error\n" +
                "28,0,28,0,0.3,0.05\n28,0,28,16,0.2,0.04\n20,30,-28,140,0.01,0.01\n",
        )
        val options = AnalysisOptions(
            from = 0.0,
            occultation = OccultationOptions(doubleArrayOf(60.0, 28.0), 4),
            brightness = BrightnessOptions(
                ScatteringLaw.lommelSeeliger(0.8),
                phaseAngles = doubleArrayOf(16.0, 0.0),
                orders = 3,
                paths = 40,
                observed = ObservedBrightness.read(seen),
            ),
        )
        Analysis(AnalysisInput.ofRun(path), options).write(path)
        val html = Files.readString(path.resolve("report.html"))
        assertTrue(
            "surfaces of Lommel and Seeliger of the single-scattering albedo 0.8. Light is scattered up to 3" in html,
        )
        for (plot in listOf("azimuth", "elevation", "phase", "observed")) {
            assertTrue(Files.size(path.resolve("plots/brightness-$plot.png")) > 1000) { plot }
        }

        val grid = table(path, "brightness-grid")
        assertArrayEquals(DoubleArray(16) { if (it < 8) 28.0 else 60.0 }, grid.numbers("elevation"))
        assertArrayEquals(DoubleArray(8) { 45.0 * it }, grid.numbers("azimuth").copyOf(8))
        assertArrayEquals(grid.numbers("azimuth"), grid.numbers("light_azimuth"))
        // The transmission that the report gives, along the lines that both have.
        val through = table(path, "occultation-grid").numbers("transmission")
        val here = grid.numbers("transmission")
        val single = grid.numbers("single_scattering")
        for (k in 0 until 4) {
            assertEquals(through[k], here[k])
            assertEquals(through[4 + k], here[8 + k])
        }
        for (k in here.indices) assertEquals(0.8 / 8 * (1 - here[k]), single[k], 1e-14)
        val all = grid.numbers("i_over_f")
        assertTrue(all.indices.all { all[it] > single[it] && all[it] < 1.5 * single[it] })

        val tilt = table(path, "brightness-elevation")
        assertEquals(all.take(8).average(), tilt.numbers("i_over_f")[0], 1e-12)
        val phases = table(path, "brightness-phase")
        assertArrayEquals(doubleArrayOf(0.0, 16.0), phases.numbers("phase_angle"))
        val sum = (1..3).sumOf { phases.numbers("order_$it")[1] }
        assertEquals(sum, phases.numbers("i_over_f")[1], 1e-12)
        assertEquals(phases.numbers("i_over_f").let { it[1] / it[0] }, phases.numbers("over_first")[1], 1e-12)
        val compared = table(path, "brightness-observed")
        assertEquals(listOf("28.0", "28.0", "-28.0"), compared["light_elevation"])
        assertEquals(phases.numbers("i_over_f")[1], compared.numbers("patch")[1], 1e-12)
        assertEquals(0.2 - compared.numbers("patch")[1], compared.numbers("residual")[1], 1e-12)
        assertTrue(compared.numbers("patch")[2] > 0) { "light from below" }
        val square = compared.numbers("residual_over_error").sumOf { it * it }
        val shown = Regex("χ² against the observed I/F.*?</tr>").find(html)!!.value
        assertTrue(ReportText.plain(square) in shown && "3 expected, ± 2.45" in shown) { shown }
    }

    @Test
    fun `without an answer to brightness there is none, and of discs and boxes the page says why`() {
        val path = run("plain", "untilOrbits=0.2")
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 0.0)).write(path)
        assertFalse("Brightness" in Files.readString(path.resolve("report.html")))
        val gas = directory.resolve("gas")
        Run.start(BuiltIn.scenario("elastic-gas", listOf("until=0.05", "particles.count=50")), "gas", gas).use {
            it.execute()
        }
        val options = AnalysisOptions(from = 0.0, brightness = BrightnessOptions(ScatteringLaw.lambert(0.5)))
        Analysis(AnalysisInput.ofRun(gas), options).write(gas)
        val html = Files.readString(gas.resolve("report.html"))
        assertTrue("Brightness: the box is filled above and below." in html)
        assertFalse(Files.exists(gas.resolve("tables/brightness-grid.csv")))
    }

    @Test
    fun `options out of range are refused in one line, and phases are chosen as far as light and table go`() {
        val law = ScatteringLaw.lambert(0.5)
        fun refused(words: String, act: () -> Unit) {
            val e = assertThrows(InputException::class.java, act)
            assertTrue(e.message!!.startsWith(words)) { e.message }
        }
        refused("lightElevation: is 0.0; it must be in 0.1..90 degrees, or as far below 0") {
            BrightnessOptions(law, 0.0)
        }
        refused("phaseAngle: is NaN; it must be in -180..180") { BrightnessOptions(law, phaseAngle = Double.NaN) }
        refused("phaseAngles: is 200.0") { BrightnessOptions(law, phaseAngles = doubleArrayOf(0.0, 200.0)) }
        refused("phaseAngles: is 181 of them") { BrightnessOptions(law, phaseAngles = DoubleArray(181)) }
        refused("orders: is 101; it must be in 1..100") { BrightnessOptions(law, orders = 101) }
        refused("paths: is 0; it must be in 1..1000000") { BrightnessOptions(law, paths = 0) }
        refused("phaseAngle: is 3.0; it must be 4 to 128 degrees in size with the eye at 28 and the light at 24") {
            AnalysisOptions(brightness = BrightnessOptions(law, 24.0, 3.0))
        }
        val options = BrightnessOptions(law, 24.0)
        assertEquals(listOf(4.0, 8.0, 16.0, 32.0, 64.0), options.phases(28.0).toList())
        assertEquals(4.0, options.phase(28.0))
        val table = PhaseTable(doubleArrayOf(0.0, Math.toRadians(10.0)), doubleArrayOf(1.0, 0.5))
        val part = BrightnessOptions(ScatteringLaw.ofSpheres(0.5, table))
        assertEquals(listOf(0.0, 0.5, 1.0, 2.0, 4.0, 8.0), part.phases(28.0).toList())
        // Straight from above light and eye are at one place.
        assertEquals(listOf(0.0), BrightnessOptions(law).phases(90.0).toList())
    }
}
