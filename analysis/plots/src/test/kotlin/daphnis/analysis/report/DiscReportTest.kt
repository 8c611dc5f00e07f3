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
import kotlin.math.abs

/** The report of a run of discs. */
class DiscReportTest {
    @Test
    fun `a report of discs has their area fraction, temperature and equation of state`(@TempDir directory: Path) {
        val scenario = BuiltIn.scenario(
            "hard-discs",
            listOf(
                "particles.count=900",
                "box.lengths=[50,50]",
                "until=30",
                "output.snapshotInterval=5",
                "roughness={\"type\":\"smooth\"}",
                "spins={\"type\":\"gaussian\",\"temperature\":3}",
            ),
        )
        val run = directory.resolve("run")
        Run.start(scenario, "hard-discs", run).use { it.execute() }
        Analysis(AnalysisInput.ofRun(run)).write(run)
        val rows = Files.readAllLines(run.resolve("tables/numbers.csv")).drop(1).map { it.split(',') }
            .associateBy { it[0] }
        fun value(key: String) = rows.getValue(key)[1].toDouble()
        assertEquals(0.28274, value("area_fraction"), 1e-5)
        assertEquals(1.0, value("granular_temperature"), 1e-9)
        assertTrue("filling_factor" !in rows)
        val pressure = rows.getValue("compressibility")
        assertEquals(1.96284, pressure[4].toDouble(), 1e-5)
        assertTrue(abs(value("compressibility") - 1.96284) < 5 * pressure[2].toDouble()) { pressure.joinToString() }
        assertEquals(2.17291, rows.getValue("collisions_per_particle")[4].toDouble(), 1e-5)
        // Spins about z alone: ⟨I ω²⟩ is their temperature.
        assertEquals(3.0, value("rotational_temperature"), 0.6)
        assertTrue("mean_spin_z" in rows && "mean_spin_x" !in rows)
        assertTrue("self_diffusion_z" !in rows)
        val page = Files.readString(run.resolve("report.html"))
        assertTrue("From above; y to the right, x up" in page && "sizes (equal, radius 0.5), mass 1.0" in page)
        assertTrue("it gives the same state digest on any machine" in page && "interrupted" !in page)
        assertTrue("Radial distribution function of discs" in page && "height z" !in page)
        assertTrue("Energy of all discs" in page && "area fraction" in page)
        assertTrue("filling factor" !in Files.readString(run.resolve("plots/radial-filling-factor.svg")))
        // A gas at rest has no long axis.
        assertTrue("Velocity ellipsoid: nothing prefers a direction there" in page)
        assertTrue(!Files.exists(run.resolve("plots/velocity-ellipsoid.svg")))
        // Energy and temperature of elastic discs are conserved: marks that differ in the sixteenth digit tell nothing.
        val temperature = Files.readString(run.resolve("plots/temperature.svg"))
        assertTrue("99999" !in temperature && "00000" !in temperature)
        assertTrue(Files.exists(run.resolve("tables/profile-radial.csv")))
        assertTrue(!Files.exists(run.resolve("tables/profile-vertical.csv")))
        // Areas of discs, cut at the faces of bins, add up to the area fraction.
        val table = Files.readAllLines(run.resolve("tables/profile-radial.csv"))
        val column = table[0].split(',').indexOfFirst { it.startsWith("filling_factor") }
        assertEquals(0.28274, table.drop(1).map { it.split(',')[column].toDouble() }.average(), 1e-5)
    }
}
