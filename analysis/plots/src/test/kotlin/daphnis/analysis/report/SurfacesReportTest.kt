package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** The report of a room that is not its box. */
class SurfacesReportTest {
    @Test
    fun `of a drum nothing is measured over its box, and its flow is named`(@TempDir home: Path) {
        val settings = listOf("particles.count=60", "until=4", "output.snapshotEvery=10")
        Run.start(BuiltIn.scenario("drum", settings), "drum", home).use { it.execute() }
        Analysis(AnalysisInput.ofRun(home)).write(home)
        val page = Files.readString(home.resolve("report.html"))
        assertTrue("Structure: walls cut off a part of the box." in page)
        assertTrue("Occultation" !in page) { "a drum is no ring" }
        val resting = Regex("The collapse guard made \\d\\d % of the collisions elastic, as where spheres rest")
        assertTrue(resting.containsMatchIn(page))
        val plots = listOf("pair-correlation", "structure-factor", "occultation", "radial-optical-depth") +
            listOf("radial-filling-factor", "vertical-filling-factor")
        assertEquals(emptyList<String>(), plots.filter { Files.exists(home.resolve("plots/$it.svg")) })
        val columns = Files.readAllLines(home.resolve("tables/profile-vertical.csv"))[0].split(',')
            .map { it.substringBefore(' ') }
        assertTrue("c_zz" in columns && columns.none { "density" in it || "depth" in it || "filling" in it })
        assertTrue("Diffusion: no axis is periodic." in page)
        assertTrue("nothing replaces the energy" !in page)
        // Of temperature, a₂, mean square velocities over height, and of the ellipsoid, which is left out.
        assertTrue("Velocity ellipsoid: the flow that walls drag along counts as random motion." in page)
        assertEquals(4, page.split("the flow that walls drag along counts as random motion").size - 1)
    }
}
