package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.format.FormatException
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/** What the report says of modes.csv. */
class WaveReportTest {
    @TempDir
    lateinit var directory: Path

    private fun run(vararg settings: String): Path = directory.resolve("run").also { path ->
        val all =
            listOf("timeStep.steps=120", "output.modesEvery=6", "output.snapshotEvery=120", "box.lengths=[90,4,20]")
        val scenario = BuiltIn.scenario("overstability", all + settings)
        Run.start(scenario, "waves", path, force = true).use { it.execute() }
    }

    private fun report(path: Path): String {
        Analysis(AnalysisInput.ofRun(path, acceptLoss = true)).write(path)
        return Files.readString(path.resolve("report.html"))
    }

    /** Replaces mode [m] of a finished run by a wave that grows and goes outward with [frequency]. */
    private fun put(path: Path, m: Int, frequency: Double, size: (Double) -> Double) {
        val file = path.resolve("modes.csv")
        val lines = Files.readAllLines(file).mapIndexed { k, line ->
            val cells = line.split(',').toMutableList()
            if (k > 0 && cells[2] == "$m") {
                val t = cells[1].toDouble()
                val amplitude = size(t / (2 * PI))
                // vx, vy of an epicycle that goes outward: i (2 v_y) = v_x.
                cells[6] = "${amplitude * cos(frequency * t)}"
                cells[7] = "${-amplitude * sin(frequency * t)}"
                cells[8] = "${-amplitude / 2 * sin(frequency * t)}"
                cells[9] = "${-amplitude / 2 * cos(frequency * t)}"
            }
            cells.joinToString(",")
        }
        Files.write(file, lines)
    }

    private fun number(path: Path, key: String): List<String> =
        Files.readAllLines(path.resolve("tables/numbers.csv")).map { it.split(',') }.single { it[0] == key }

    @Tag("thorough")
    @Test
    fun `a wave that is put in is found with its length, rate, frequency and direction`() {
        val path = run("untilOrbits=30")
        put(path, 2, 1.12) { 0.1 * Math.exp(0.2 * it) }
        val html = report(path)
        assertTrue(NumberKeys.WAVES.all { it in NumberKeys.of(path) }) { "${NumberKeys.of(path)}" }
        assertEquals(45.0, number(path, "wave_wavelength")[1].toDouble(), 1e-9)
        assertEquals(45.0, number(path, "wave_first_wavelength")[1].toDouble(), 1e-9)
        assertEquals(0.2, number(path, "wave_growth_rate")[1].toDouble(), 1e-4)
        assertEquals("1/orbit", number(path, "wave_growth_rate")[3])
        assertEquals(1.12, number(path, "wave_growth_frequency")[1].toDouble(), 1e-5)
        assertEquals(1.0, number(path, "wave_direction")[1].toDouble(), 1e-3)
        assertTrue(number(path, "wave_growth_rate")[2].isNotEmpty()) {
            "a change has its error though the run is not steady"
        }
        for (name in listOf("waves", "wave-history", "wave-blocks", "wave-density", "autocorrelation-x")) {
            assertTrue(Files.exists(path.resolve("tables/$name.csv"))) { name }
        }
        assertTrue(">Waves</h2>" in html && ">Structure</h2>" in html)
        assertTrue("The dashed line is the wave that grows first." in html)
        assertTrue("stroke-dasharray" in Files.readString(path.resolve("plots/wavelength.svg")))
        val blocks = Files.readAllLines(path.resolve("tables/wave-blocks.csv"))
        assertEquals(7, blocks.size)
        // The root of the mean of 0.005 e^{0.4 t} over orbits 5 to 10.
        val expected = Math.sqrt(0.005 * (Math.exp(4.0) - Math.exp(2.0)) / 2)
        assertEquals(expected, blocks[2].split(',')[3].toDouble(), 0.03 * expected)
    }

    private fun column(path: Path, table: String, name: String): List<Double> {
        val lines = Files.readAllLines(path.resolve("tables/$table.csv")).map { it.split(',') }
        val k = lines[0].indexOfFirst { it.substringBefore(" [") == name }
        return lines.drop(1).map { it[k].ifEmpty { "NaN" }.toDouble() }
    }

    @Test
    fun `a harmonic keeps its rms in table and plot, and has no frequency`() {
        val path = run("untilOrbits=12", "output.modes=12", "particles.opticalDepth=0.2")
        put(path, 2, 1.12) { 0.1 }
        put(path, 3, 2.3) { 3.0 }
        report(path)
        val rms = 3 / Math.sqrt(2.0)
        assertEquals(rms, column(path, "waves", "rms_vx")[2], 1e-9)
        column(path, "wave-history", "rms_vx_3").forEach { assertEquals(rms, it, 0.03 * rms) }
        assertTrue(column(path, "wave-history", "coherent_vx_3").all { it < 0.5 })
        assertTrue(column(path, "waves", "frequency")[2].isNaN() && column(path, "waves", "direction")[2].isNaN())
        assertEquals(1.12, column(path, "waves", "frequency")[1], 1e-5)
        assertEquals(30.0, number(path, "wave_wavelength")[1].toDouble(), 1e-9)
        assertFalse("wave_frequency" in NumberKeys.of(path))
        // Four places in the shortest of 12 waves.
        assertEquals(48, column(path, "wave-density", "x").distinct().size)
    }

    @Test
    fun `of waves that grow the last one is named`() {
        val path = run("untilOrbits=40", "particles.opticalDepth=0.2")
        put(path, 2, 1.12) { minOf(5.0, 0.1 * Math.exp(0.3 * it)) }
        put(path, 1, 1.05) { 0.1 * Math.exp(0.1 * it) }
        report(path)
        val input = AnalysisInput.ofRun(path, acceptLoss = true)
        val waves = checkNotNull(Waves.of(input, 100.0))
        assertEquals(2, waves.first)
        assertEquals(1, waves.growsLast)
    }

    @Tag("thorough")
    @Test
    fun `too few rows and damage are said, and without modes there is no word of them`() {
        val seldom = run("untilOrbits=4", "output.modesEvery=60")
        assertTrue("Waves: modes.csv needs four states in every epicyclic period" in report(seldom))
        val none = run("untilOrbits=4", "output.modesEvery=0")
        assertFalse("Waves" in report(none) || "modes.csv" in report(none))
        val path = run("untilOrbits=4")
        val file = path.resolve("modes.csv")
        val lines = Files.readAllLines(file)
        // Half a state at the end is one that is being written.
        Files.write(file, lines.dropLast(3))
        report(path)
        Files.write(file, lines.take(5) + lines.drop(6))
        val e = assertThrows(FormatException::class.java) { report(path) }
        assertEquals("$file:6: is of mode 5.0; it must be of mode 4 of one state", e.message)
    }
}
