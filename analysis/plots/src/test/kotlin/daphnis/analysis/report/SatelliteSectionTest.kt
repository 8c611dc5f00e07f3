package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI

/** What a report says of satellites that feel the ring. */
class SatelliteSectionTest {
    @TempDir
    lateinit var home: Path

    private fun analysed(name: String, vararg settings: String): Path = home.resolve(name).also { path ->
        Run.start(BuiltIn.scenario("shepherds", SMALL + settings), name, path).use { it.execute() }
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 0.0)).write(path)
    }

    private fun numbers(path: Path): Map<String, List<String>> =
        Files.readAllLines(path.resolve("tables/numbers.csv")).drop(1).map { it.split(',') }.associateBy { it[0] }

    @Test
    fun `a report shows how shepherds recede, and that the ringlet loses what they take up`() {
        val path = analysed("run")
        val numbers = numbers(path)
        assertEquals(NumberKeys.SATELLITE, numbers.keys.filter { it in NumberKeys.SATELLITE })
        fun value(key: String) = numbers.getValue(key)[1].toDouble()
        assertEquals(1.0, value("satellite_balance"), 1e-8)
        // The inner one goes inward, and its drift is that of the force: 2 F (2π/Ω)/(M Ω).
        val omega = Math.sqrt(0.008 / (64.0 * 64 * 64))
        assertTrue(value("satellite_force") < 0)
        val drift = 2 * value("satellite_force") * 2 * PI / (1e13 * omega * omega)
        assertEquals(1.0, value("satellite_drift") / drift, 0.1)
        assertEquals("km/orbit", numbers.getValue("satellite_drift")[3])
        val html = Files.readString(path.resolve("report.html"))
        assertTrue(">Satellites</h2>" in html && "on satellite 2 along its orbit" in html)
        // In the caption of the picture, where they are not drawn: at the time of the last state.
        val standing = Regex("Satellites, not drawn, are at x = (\\S+), y = \\S+ km and x = (\\S+), y = \\S+ km\\.")
        val (first, second) = standing.find(html)!!.destructured
        assertEquals(0.0, first.replace('−', '-').toDouble() + second.replace('−', '-').toDouble(), 0.3)
        assertTrue("open along x, z" in html)
        assertFalse(">Moonlets</h2>" in html)
        for (plot in listOf("satellite-walk", "satellite-eccentricity")) {
            assertTrue("satellite 2" in Files.readString(path.resolve("plots/$plot.svg"))) { plot }
        }
    }

    @Test
    fun `through faces that repeat, balance counts how often`() {
        val path = analysed("sheet", "boundary.radiallyOpen=false", "untilOrbits=2")
        assertEquals(1.0, numbers(path).getValue("satellite_balance")[1].toDouble(), 1e-8)
    }

    @Test
    fun `no balance stands where a satellite keeps its orbit or a state has no row, and streamlines see moons now`() {
        val kept = analysed("kept", "forces[1].feelsRing=false", "untilOrbits=1")
        assertFalse("satellite_balance" in numbers(kept))
        val rare = analysed("rare", "output.bodiesEvery=40", "untilOrbits=1")
        assertFalse("satellite_balance" in numbers(rare))
        // A heavy ring moves its moon at once.
        val path = analysed("moved", "particles.density=5e11", "untilOrbits=3")
        val x = Files.readAllLines(path.resolve("bodies.csv")).last { ",-1," in it }.split(',')[10].toDouble()
        assertTrue(kotlin.math.abs(x + 9) > 0.05) { "$x" }
        val distance = Regex("distance from the moon's orbit.*?<td[^>]*>([0-9.]+)", RegexOption.DOT_MATCHES_ALL)
            .find(Files.readString(path.resolve("report.html")))!!.groupValues[1].toDouble()
        assertEquals(-x, distance, 0.01)
    }

    @Test
    fun `without rows the report says what is missing`() {
        val path = analysed("silent", "output.bodiesEvery=0", "untilOrbits=1")
        assertTrue("output.bodiesEvery" in Files.readString(path.resolve("report.html")))
        assertTrue(numbers(path).keys.none { it in NumberKeys.SATELLITE })
    }

    private companion object {
        val SMALL = listOf("particles.sizes.radius=0.25", "untilOrbits=6", "output.snapshotEvery=75")
    }
}
