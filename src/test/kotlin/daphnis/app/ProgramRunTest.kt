package daphnis.app

import daphnis.core.FixedTimeStep
import daphnis.core.Simulation
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Periodic
import daphnis.core.engine.CollisionForcing
import daphnis.core.population.Population
import daphnis.core.run.Program
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.OutputSpec
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.surface.ConstantRestitution
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** What the command line makes of a run directory that no scenario made. */
class ProgramRunTest {
    @TempDir
    lateinit var home: Path

    private class Gas(private val coefficient: Double, private val boundary: (Box) -> BoundaryConditions) : Program {
        private val setup = ScenarioSetup.of(BuiltIn.scenario("cooling-gas", listOf("particles.count=80")), "gas")
        override val name = "gas in a program"
        override val version = "1"
        override val until = 2.0
        override val output = OutputSpec(snapshotEvery = 5, transportEvery = 1)

        override fun population(): Population = setup.population

        override fun simulation(population: Population): Simulation {
            val collisions = CollisionForcing(ConstantRestitution(coefficient), setup.guard, recordCollisions = true)
            return Simulation(population, boundary(setup.boundary.box), collisions, FixedTimeStep(0.1))
        }
    }

    private fun run(name: String, coefficient: Double = 0.9, boundary: (Box) -> BoundaryConditions = { Periodic(it) }) =
        home.resolve(name).also { path ->
            Run.start(Gas(coefficient, boundary), path).use { it.execute() }
        }.toString()

    @Test
    fun `it is analysed as far as snapshots and tables go, and what is not known is said`() {
        val result = daphnis("analyze", run("gas"), "--quiet")
        assertDone(result)
        assertTrue("the program 'gas in a program', version '1': without a scenario" in result.err) { result.err }
        val page = Files.readString(home.resolve("gas/report.html"))
        assertTrue("gas in a program" in page && "granular temperature" in page)
        assertTrue(Files.exists(home.resolve("gas/tables/time-series.csv")))
    }

    @Test
    fun `a movie of it is drawn, and what is not known is said`() {
        val result = daphnis("movie", run("gas"), "--width", "240", "--quiet")
        assertTrue("5 frames of 240 × " in assertDone(result)) { result.out }
        assertTrue("without a scenario" in result.err) { result.err }
    }

    @Test
    fun `it is compared and exported, but not in units that nobody has said`() {
        val first = run("first")
        assertTrue("identical: 5 common snapshots" in assertDone(daphnis("compare", first, run("again"))))
        val other = daphnis("compare", first, run("other", 0.5))
        assertTrue(other.code == 1 && "differ at step" in other.out) { other.out }
        assertTrue("5 snapshots" in assertDone(daphnis("export", first, "--format", "h5md")))
        val si = daphnis("export", first, "--format", "h5md", "--units", "si")
        assertRefused(si, "--units", "the program 'gas in a program'")
    }

    @Tag("thorough")
    @Test
    fun `a scenario says what its box and frame are, but not which law was at work`() {
        val sheared = run("sheared") { LeesEdwards(it, 0.3) }
        val boundary = "boundary={\"type\":\"lees-edwards\",\"shearRate\":0.3}"
        val given = arrayOf("--scenario", "cooling-gas", "--set", boundary, "--from", "0", "--quiet")
        assertDone(daphnis("analyze", sheared, *given))
        val numbers = Files.readString(home.resolve("sheared/tables/numbers.csv"))
        assertTrue("viscosity_collisional" in numbers && "reduced_pressure" in numbers) { numbers }
        val page = Files.readString(home.resolve("sheared/report.html"))
        assertTrue("of the program 'gas in a program'" in page.replace("&#39;", "'") && "constant" !in page)
        assertTrue("inelastic" !in page && "scenario.json" !in page)
        val wrong = daphnis("analyze", sheared, *given, "--set", "box.lengths[1]=30")
        assertRefused(wrong, "--scenario: box.lengths[1]: is 30.0; in the run", "the box is 21.8781, periodic along y")
    }

    @Test
    fun `what only its program or a scenario can tell is refused in one line`() {
        assertRefused(
            daphnis("resume", run("gas")),
            "gas",
            "the program 'gas in a program'",
            "only it can continue the run",
        )
        val sheared = run("sheared") { LeesEdwards(it, 0.3) }
        assertRefused(daphnis("analyze", sheared), "images slide", "analyze it with one")
        assertRefused(daphnis("run", "cooling-gas", "--out", sheared), "exists")
    }
}
