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

class RoughReportTest {
    @Test
    fun `a gas of rough spheres has numbers, a curve and a distribution of spins`(@TempDir home: Path) {
        val small = listOf("particles.count=300", "until=6", "output.snapshotEvery=10", "output.transportEvery=1")
        Run.start(BuiltIn.scenario("rough-gas", small), "gas", home).use { it.execute() }
        Analysis(AnalysisInput.ofRun(home)).write(home)
        assertEquals(NumberKeys.ROUGH_GAS, NumberKeys.of(home))
        assertTrue(">Spins</h2>" in Files.readString(home.resolve("report.html")))
        assertTrue("rotational temperature" in Files.readString(home.resolve("plots/temperature.svg")))
        val head = Files.readAllLines(home.resolve("tables/spin-distribution.csv"))[0]
        assertTrue(head.startsWith("component,s_x,s_x_error,s_y") && head.endsWith("maxwellian_modulus")) { head }
        val row = Files.readAllLines(home.resolve("tables/numbers.csv")).first { it.startsWith("rotational_temp") }
        assertEquals("not steady", row.split(',')[5])
    }
}
