package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.run.Summary
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

@Tag("jdk-neutral")
class ReportNumberTest {
    @TempDir
    lateinit var directory: Path

    private fun run(name: String, vararg settings: String): Path {
        val path = directory.resolve(name)
        Run.start(BuiltIn.scenario(name, settings.asList()), name, path).use { it.execute() }
        return path
    }

    @Tag("thorough")
    @Test
    fun `the numbers of a report are those of its table, without a file written`() {
        val ring = run("ring-patch", "untilOrbits=12", "box.lengths=[40,40,20]", "output.snapshotEvery=45")
        val gas = run(
            "elastic-gas",
            "particles={\"count\":150,\"sizes\":{\"type\":\"list\",\"radii\":[0.5,0.3]},\"density\":1}",
            "box.lengths=[8,8,8]",
            "until=24",
            "output.snapshotEvery=5",
            "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
        )
        for ((path, diffusion) in listOf(ring to "guiding_centre_diffusion", gas to "self_diffusion")) {
            val options = AnalysisOptions(from = AnalysisInput.ofRun(path).times.last() / 4)
            val numbers = Analysis(AnalysisInput.ofRun(path), options).numbers()
            assertTrue(!Files.exists(path.resolve("tables")) && !Files.exists(path.resolve("report.html")))
            Analysis(AnalysisInput.ofRun(path), options).write(path)
            val table = Files.readAllLines(path.resolve("tables/numbers.csv")).drop(1).map { it.split(',') }
            assertEquals(table.map { it[0] }, numbers.map { it.key })
            assertEquals(table.map { it[1] }, numbers.map { "${it.value}" })
            assertEquals(table.map { it[3] }, numbers.map { it.unit })
            assertTrue(diffusion in numbers.map { it.key }) { diffusion }
        }
    }

    @Test
    fun `the end of the series is its last row, with units`() {
        val path = run("cooling-gas", "until=1", "particles.count=50", "output.snapshotEvery=1")
        val input = AnalysisInput.ofRun(path)
        val end = ReportNumber.atEnd(input.series!!, input.units).associateBy { it.key }
        val summary = Summary.read(path.resolve("summary.json"))
        assertEquals(summary.temperature, end.getValue("end_granular_temperature").value)
        assertEquals(summary.collisions.toDouble(), end.getValue("end_collisions").value)
        assertEquals("", end.getValue("end_collisions").unit)
        assertEquals("units of length^2/time^2", end.getValue("end_granular_temperature").unit)
        assertTrue(end.values.all { it.isSteady })
        assertTrue("end_step" !in end && "end_time" !in end)
    }
}
