package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.format.H5md
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

/** The report of spheres that grow: nothing is averaged over time, and the pressure stands over the filling factor. */
class GrowthReportTest {
    @Test
    fun `of a run that grows the last state is measured, and no drift is denied`(@TempDir home: Path) {
        val settings = listOf("particles.count=200", "until=6", "output.snapshotEvery=20", "box.lengths=[8,8,8]")
        Run.start(BuiltIn.scenario("glass", settings), "glass", home).use { it.execute() }
        Analysis(AnalysisInput.ofRun(home)).write(home)
        val page = Files.readString(home.resolve("report.html"))
        assertTrue("so averages over time mean nothing: numbers are of one state." in page)
        assertTrue("No drift is seen" !in page && "spheres grow, so no time" in page)
        assertTrue("by an end of growth" !in page) { "it reached its time" }
        assertTrue("Averages over 1 state of 7" in page)
        assertTrue("the number is of one state of a run that changes" in page && "steady over the time" !in page)
        val last = Files.readAllLines(home.resolve("tables/numbers.csv")).map { it.split(',') }
            .first { it[0] == "filling_factor" }[1].toDouble()
        assertTrue("to ${ReportText.short(last)}, so averages" in page)
        assertTrue(Files.exists(home.resolve("plots/compression.svg")))
        val rows = Files.readAllLines(home.resolve("tables/compression.csv"))
        assertEquals(listOf("time", "filling_factor", "reduced_pressure", "fluid"), rows[0].split(',').map(::name))
        val numbers = rows.drop(1).map { line -> line.split(',').map { it.toDouble() } }
        for (row in numbers) assertEquals(EquationOfState.ofSpheres(row[1]), row[3], 1e-6 * row[3])
        assertEquals(1.0, numbers.map { it[2] / it[3] }.average(), 0.2)
    }

    @Test
    fun `a run that its growth ends says so, one that falls short of its time by rounding does not`(
        @TempDir home: Path,
    ) {
        for ((until, goal) in listOf("30" to "0.31", "0.33" to "0.6")) {
            val settings = listOf("particles.count=100", "until=$until", "timeStep={\"type\":\"fixed\",\"dt\":0.03}") +
                "box.lengths=[7,7,7]" + "growth.untilFillingFactor=$goal"
            val path = home.resolve(until)
            Run.start(BuiltIn.scenario("glass", settings), "glass", path).use { it.execute() }
            Analysis(AnalysisInput.ofRun(path)).write(path)
            val page = Files.readString(path.resolve("report.html"))
            assertEquals(goal == "0.31", "ended before time 30 by an end of growth" in page)
            assertEquals(goal == "0.31", "by an end of growth" in page)
        }
    }

    @Test
    fun `a file whose spheres change their radii says so, and its numbers are of its last state`(@TempDir home: Path) {
        val settings = listOf("particles.count=200", "until=6", "output.snapshotEvery=20", "box.lengths=[8,8,8]")
        Run.start(BuiltIn.scenario("glass", settings), "glass", home).use { it.execute() }
        val file = home.resolve("grown.h5")
        H5md.write(Run.open(home).states().toList(), file, "test")
        val out = home.resolve("out")
        Analysis(AnalysisInput.ofFile(file, null, "")).write(out)
        val page = Files.readString(out.resolve("report.html"))
        val run = AnalysisInput.ofRun(home)
        val ends = listOf(0, run.size - 1).map { ReportText.short(Bulk(run.state(it), run).fillingFactor) }
        val what = "The spheres change their radii from the filling factor ${ends[0]} to ${ends[1]}, so averages"
        assertTrue("$what over time mean nothing: numbers are of one state." in page) {
            page.substringAfter("The spheres").take(300)
        }
        assertTrue("Averages over 1 state of 7" in page)
    }

    @Test
    fun `rows of a file without ids may be in any order`(@TempDir home: Path) {
        fun isGrowing(name: String, scale: Double): Boolean {
            fun state(from: Int, scale: Double) = "20\nProperties=pos:R:3:radius:R:1 Lattice=\"9 0 0 0 9 0 0 0 9\"\n" +
                (0 until 20).joinToString("") { "${(it + from) % 20 * 0.4} 0 0 ${scale * (1 + (it + from) % 20)}\n" }
            val file = Files.writeString(home.resolve("$name.xyz"), state(0, 0.01) + state(7, 0.01 * scale))
            return Growth.isSeen(AnalysisInput.ofFile(file, null, ""))
        }
        assertFalse(isGrowing("turned", 1.0))
        assertTrue(isGrowing("grown", 1.1))
    }

    private fun name(heading: String) = heading.substringBefore(' ')

    @Test
    fun `equations of state have their known values`() {
        assertEquals(12.41, EquationOfState.ofSpheres(0.493), 0.1)
        assertEquals(1.96322, EquationOfState.ofDiscs(0.2827433), 1e-5)
    }
}
