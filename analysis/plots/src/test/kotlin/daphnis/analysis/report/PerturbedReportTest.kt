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

class PerturbedReportTest {
    private val small = listOf(
        "box.lengths=[40,40,20]",
        "timeStep.steps=100",
        "output.transportEvery=2",
        "output.seriesEvery=0",
        "output.snapshotEvery=75",
        "output.checkpointEvery=0",
    )

    @Test
    fun `a perturbed ring has a flux, a balance and pictures of its period in place of viscosities`(
        @TempDir home: Path,
    ) {
        val scenario = BuiltIn.scenario("perturbed-ring", small + "untilOrbits=30.3")
        Run.start(scenario, "perturbed-ring", home).use { it.execute() }
        val from = 5 * 47819.0
        Analysis(AnalysisInput.ofRun(home), AnalysisOptions(from = from)).write(home)
        val keys = NumberKeys.of(home)
        assertEquals(NumberKeys.PERTURBED, keys)
        val rows = Analysis(AnalysisInput.ofRun(home), AnalysisOptions(from = from)).rows().associateBy { it.key }
        assertEquals(0.5, rows.getValue("perturbation").value, 1e-12)
        assertEquals(3.0, rows.getValue("surface_density_ratio").value, 1e-12)
        // Of the mean width, whenever the run ends.
        assertEquals(0.5, rows.getValue("optical_depth").value, 0.01)
        val balance = rows.getValue("shear_work_over_dissipation")
        assertTrue(balance.error > 0 && balance.error < 0.03) { "$balance" }
        assertEquals(1.0, balance.value, maxOf(4 * balance.error, 0.01))
        val flux = rows.getValue("angular_momentum_flux")
        assertEquals(1.7, flux.value, 0.5)
        val html = Files.readString(home.resolve("report.html"))
        assertTrue(">Perturbation</h2>" in html && "Streamlines: in a perturbed sheet" in html)
        assertTrue("Diffusion: in a perturbed sheet" in html)
        assertTrue(Files.size(home.resolve("plots/perturbation.png")) > 1000)
        val table = Files.readAllLines(home.resolve("tables/perturbation.csv"))
        assertEquals(26, table.size)
    }

    @Test
    fun `what is of states of one phase has no error and no value in a sweep, and the report says what to set`(
        @TempDir home: Path,
    ) {
        val scenario = BuiltIn.scenario("perturbed-ring", small + listOf("output.snapshotEvery=25", "untilOrbits=28"))
        Run.start(scenario, "perturbed-ring", home).use { it.execute() }
        val from = 2 * 47819.0
        val ofStates = listOf("velocity_dispersion_thermal", "midplane_filling_factor")
        val input = AnalysisInput.ofRun(home)
        // All are of four phases, every fourth is of one.
        val spread = Analysis(input, AnalysisOptions(from = from, frames = 104))
        assertTrue(spread.rows().filter { it.key in ofStates }.all { it.error > 0 })
        assertTrue(spread.numbers().filter { it.key in ofStates }.all { it.value > 0 })
        val one = Analysis(input, AnalysisOptions(from = from, frames = 26))
        val rows = one.rows()
        assertEquals(ofStates, rows.filter { it.unknown == Unknown.FEW_PHASES }.map { it.key })
        assertTrue(rows.filter { it.key in ofStates }.all { it.error.isNaN() && it.value > 0 })
        assertTrue(rows.single { it.key == "velocity_dispersion" }.error > 0)
        assertEquals(ofStates, one.numbers().filter { it.value.isNaN() }.map { it.key })
        one.write(home)
        val html = Files.readString(home.resolve("report.html"))
        assertTrue("26 states averaged are not spread over the phases" in html && "104 frames would" in html)
        assertTrue("since the states are of few phases" in html)
        assertTrue("r Ω,,states of few phases," in Files.readString(home.resolve("tables/numbers.csv")))
        // Without the other states another run is needed.
        val few = home.resolve("few")
        val settings = small + listOf("output.snapshotEvery=200", "untilOrbits=8")
        Run.start(BuiltIn.scenario("perturbed-ring", settings), "perturbed-ring", few).use { it.execute() }
        Analysis(AnalysisInput.ofRun(few)).write(few)
        val page = Files.readString(few.resolve("report.html"))
        assertTrue("a run with output.snapshotEvery=238 would" in page)
    }

    @Test
    fun `the surface density of q = 0,866 goes up and down by the factor 13,93`(@TempDir home: Path) {
        val settings = small + listOf(
            "boundary.perturbation=0.866",
            "box.lengths=[40,40,80]",
            "particles.opticalDepth=0.05",
            "output.snapshotEvery=25",
            "untilOrbits=1",
        )
        Run.start(BuiltIn.scenario("perturbed-ring", settings), "perturbed-ring", home).use { it.execute() }
        val input = AnalysisInput.ofRun(home)
        val densities = (0 until input.size).map { k -> input.state(k).let { it.population.mass.sum() / it.area } }
        assertEquals(13.93, densities.max() / densities.min(), 0.005)
        // The file says it too.
        val lengths = (0 until input.size).map { input.snapshot(it).lengths[0] }
        assertEquals(13.93, lengths.max() / lengths.min(), 0.005)
        assertFalse(lengths.distinct().size < 3)
    }

    @Tag("thorough")
    @Test
    fun `errors are as large as numbers scatter from seed to seed`(@TempDir home: Path) {
        val scenario = BuiltIn.scenario("perturbed-ring", small + listOf("output.snapshotEvery=400", "untilOrbits=40"))
        val bars = ErrorBars()
        for (seed in 1L..SEEDS) bars.add(scenario, seed, home.resolve("$seed"))
        val lines = bars.lines().associateBy { it.name }
        for (name in listOf("angular_momentum_flux", "angular_momentum_flux_translational")) {
            val line = lines.getValue(name)
            assertTrue(line.covered in 0.5..0.85 && line.spread in 0.7..1.4 && line.given >= 0.75 * SEEDS) {
                bars.table()
            }
        }
        assertTrue(lines.getValue("shear_work_over_dissipation").spread in 0.6..1.4) { bars.table() }
        println(bars.table())
    }

    private companion object {
        const val SEEDS = 40
    }
}
