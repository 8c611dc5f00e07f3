package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.format.Snapshot
import daphnis.core.population.Population
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
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

    @Tag("thorough")
    @Test
    fun `spheres that spin and rest, or move together, have no ratio of temperatures`(@TempDir home: Path) {
        for ((name, speed) in listOf("rest" to 0.0, "flow" to 1.0 / 3)) {
            fun all(value: Double) = DoubleArray(50) { value }
            fun place(axis: Int) = DoubleArray(50) { ((it + 1) * 0.37 * axis) % 1 * 8 - 4 }
            val population = Population(
                place(1),
                place(2),
                place(3),
                all(speed),
                all(0.0),
                all(0.0),
                all(0.1),
                all(1.0),
            ).withSpin(all(0.0), all(0.0), DoubleArray(50) { 1.0 + it })
            val box = Periodic(Box.centred(8.0, 8.0, 8.0))
            val states = AnalysisInput.ofStates(name, doubleArrayOf(0.0, 1.0), box, null) {
                Snapshot.of(population, box, it.toLong(), it.toDouble())
            }
            Analysis(states).write(home.resolve(name))
            val keys = NumberKeys.of(home.resolve(name))
            assertTrue("rotational_temperature" in keys && "rotational_over_translational" !in keys) { "$name $keys" }
        }
    }
}
