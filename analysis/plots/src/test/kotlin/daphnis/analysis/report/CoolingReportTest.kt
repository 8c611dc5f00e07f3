package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.plot.Curve
import daphnis.core.run.Run
import daphnis.core.run.SeriesColumns
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.cbrt

/** A gas that cools has Haff's law beside its temperature, and the a₂ of theory beside its own. */
class CoolingReportTest {
    @TempDir
    lateinit var home: Path

    /** Of 1000 spheres at the filling factor 0.1. */
    private fun run(name: String, vararg settings: String): Study {
        val edge = cbrt(1000 * PI / 6 / 0.1)
        val gas = listOf(
            "particles={\"count\":1000,\"sizes\":{\"type\":\"equal\",\"radius\":0.5},\"mass\":1}",
            "box.lengths=[$edge,$edge,$edge]",
            "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
            "restitution={\"type\":\"constant\",\"coefficient\":0.9}",
            "timeStep={\"type\":\"fixed\",\"dt\":0.2}",
            "output={\"seriesEvery\":5,\"snapshotEvery\":25}",
            "until=40",
        )
        val path = home.resolve(name)
        Run.start(BuiltIn.scenario("cooling-gas", gas + settings), "cooling-gas", path).use { it.execute() }
        val input = AnalysisInput.ofRun(path)
        return Study(input, 0.0, listOf(input.size - 1), AnalysisOptions(), path)
    }

    @Test
    fun `the temperature falls by Haff's law with the rate of theory, and a report shows both`() {
        val study = run("even")
        val series = study.input.series!!
        val measured = Curve("T", series[SeriesColumns.TIME], series[SeriesColumns.GRANULAR_TEMPERATURE])
        val law = CoolingReferences.line(study, measured)!!
        assertTrue(measured.y.last() < 0.2) { "${measured.y.last()}" }
        for (k in law.y.indices) assertEquals(1.0, measured.y[k] / law.y[k], 0.06) { "at ${law.x[k]}" }
        Analysis(study.input).write(home.resolve("even"))
        assertTrue("Haff" in Files.readString(home.resolve("even/plots/temperature.svg")))
        assertTrue("Haff's law begins" in Files.readString(home.resolve("even/report.html")))
        val a2 = CoolingReferences.of(study.physics!!, study.last).getValue("velocity_a2")
        assertEquals(-0.01456, a2.value, 1e-5)
    }

    @Test
    fun `spheres that rest have no cumulants`() {
        val study = run("still", "velocities={\"type\":\"gaussian\",\"sigma\":0}", "until=2", "output.snapshotEvery=1")
        Analysis(study.input).write(home.resolve("still"))
        val numbers = Files.readString(home.resolve("still/tables/numbers.csv"))
        assertTrue("granular_temperature,0.0" in numbers && "velocity_a2" !in numbers) { numbers }
    }

    @Test
    fun `no other gas has them`() {
        val others = listOf(
            "restitution={\"type\":\"constant\",\"coefficient\":0.6}",
            "restitution={\"type\":\"constant\",\"coefficient\":1}",
            "boundary={\"type\":\"walls\"}",
            "roughness={\"type\":\"constant\",\"coefficient\":0}",
            "forces=[{\"type\":\"white-noise\",\"intensity\":0.1}]",
            "particles.sizes={\"type\":\"list\",\"radii\":[0.5,0.4]}",
        )
        for ((k, other) in others.withIndex()) {
            val study = run("$k", other, "until=1")
            assertEquals(emptyMap<String, Reference>(), CoolingReferences.of(study.physics!!, study.last)) { other }
            assertNull(CoolingReferences.line(study, Curve("T", doubleArrayOf(0.0), doubleArrayOf(1.0)))) { other }
        }
    }
}
