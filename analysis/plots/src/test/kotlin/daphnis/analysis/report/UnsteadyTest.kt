package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

class UnsteadyTest {
    @TempDir
    lateinit var home: Path

    @Test
    fun `a longer run is asked for where it helps, not of waves, and not of a single passage`() {
        assertEquals("a longer run is needed", Unsteady.advice(false, 1.1))
        assertEquals("a longer run is needed", Unsteady.advice(false, Double.NaN))
        assertTrue("mostly that of waves (total over thermal dispersion 3)" in Unsteady.advice(false, 3.0))
        assertTrue("passes once" in Unsteady.advice(true, Double.NaN))
    }

    @Tag("thorough")
    @Test
    fun `forced epicycles behind a moon are in the total dispersion, not in the thermal one`() {
        val path = home.resolve("pan")
        val settings = listOf(
            "box.lengths=[10,3000,0.6]",
            "particles.opticalDepth=0.02",
            "output.snapshotEvery=20",
            "output.transportEvery=20",
            "forces=[{\"type\":\"satellite\",\"massRatio\":8.71e-12,\"x\":-167,\"y\":-2500,\"radius\":14}]",
            "untilOrbits=4",
        )
        Run.start(BuiltIn.scenario("satellite-wake", settings), "pan", path).use { it.execute() }
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(frames = 4)).write(path)
        val numbers = Files.readAllLines(path.resolve("tables/numbers.csv")).drop(1).map { it.split(',') }
            .associate { it[0] to it[1].toDouble() }
        val thermal = numbers.getValue("velocity_dispersion_thermal")
        val total = numbers.getValue("velocity_dispersion_total")
        // 1.8 km of eccentricity, the random speeds are those of the start, 0.00001 km/s along each axis, damped.
        assertTrue(total > 3 * thermal) { "thermal $thermal, total $total" }
        val html = Files.readString(path.resolve("report.html"))
        assertFalse("a longer run is needed" in html)
        assertTrue("velocity dispersion, thermal" in html && "velocity dispersion, total" in html)
    }
}
