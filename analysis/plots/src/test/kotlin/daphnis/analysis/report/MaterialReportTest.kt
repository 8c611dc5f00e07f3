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
import kotlin.math.abs

class MaterialReportTest {
    private val small = listOf("particles.count=400", "box.lengths=[21,21,21]", "until=20", "output.snapshotEvery=50")

    private fun report(home: Path, settings: List<String> = small): Map<String, List<String>> {
        Run.start(BuiltIn.scenario("mixture", settings), "mixture", home).use { it.execute() }
        Analysis(AnalysisInput.ofRun(home)).write(home)
        return Files.readAllLines(home.resolve("tables/numbers.csv")).map { it.split(',') }.associateBy { it[0] }
    }

    @Test
    fun `an elastic mixture has partial temperatures that are one, their ratio, and who is beside whom`(
        @TempDir home: Path,
    ) {
        val numbers = report(home, small + "restitution.coefficient=1" + "until=60")
        val (heavy, light) = listOf("heavy", "light").map { numbers["partial_temperature_$it"]!![1].toDouble() }
        val ratio = numbers["temperature_ratio_heavy_light"]!![1].toDouble()
        assertTrue(abs(ratio / (heavy / light) - 1) < 0.02) { "$ratio, $heavy over $light" }
        assertTrue(abs(ratio - 1) < 0.25) { "$ratio" }
        assertTrue("<small>by mass" in Files.readString(home.resolve("report.html")))
        val table = Files.readAllLines(home.resolve("tables/materials.csv"))
        assertTrue(table[0].startsWith("material,count,mean_radius"))
        assertEquals(listOf("0.0,200.0,1.0,", "1.0,200.0,0.5,"), table.drop(1).map { it.take(14) })
        val pairs = Files.readAllLines(home.resolve("tables/pair-correlation-by-material.csv")).map { it.split(',') }
        assertEquals(listOf("g_heavy-heavy", "g_heavy-light", "g_light-light"), pairs[0].slice(listOf(1, 3, 5)))
        // Contacts are at 2, 1.5 and 1.
        for ((column, contact) in listOf(1 to 2.0, 3 to 1.5, 5 to 1.0)) {
            val inside = pairs.drop(1).filter { it[0].toDouble() < contact - 0.2 }
            assertTrue(inside.all { it[column].toDouble() == 0.0 })
            assertTrue(pairs.drop(1).any { it[0].toDouble() in contact..contact + 0.4 && it[column].toDouble() > 0.8 })
        }
        assertTrue(">Materials</h2>" in Files.readString(home.resolve("report.html")))
    }

    @Test
    fun `a mixture with swaps says how many, and follows places but no velocities`(@TempDir home: Path) {
        val elastic = small + "restitution.coefficient=1" + "output.snapshotEvery=1"
        val plain = report(home.resolve("plain"), elastic)
        val numbers = report(home.resolve("swaps"), elastic + """swaps={"rate": 20}""")
        val page = Files.readString(home.resolve("swaps/report.html"))
        val summary = Run.open(home.resolve("swaps")).summary()!!
        assertTrue("${summary.swaps} of ${summary.swapAttempts} tried" in page)
        assertTrue("Paths are those of places" in page)
        assertTrue("velocity_correlation_slope" in plain && "velocity_correlation_slope" !in numbers)
        assertTrue("velocity-autocorrelation" !in page && "No velocity autocorrelation" !in page)
        assertTrue("self_diffusion" in numbers)
        assertEquals(plain["compressibility"]!![4], numbers["compressibility"]!![4])
        assertTrue(plain["compressibility"]!![4].toDouble() > 1)
        // Of each kind there are as many in all states.
        val tables = listOf("plain", "swaps").map { Files.readAllLines(home.resolve("$it/tables/materials.csv")) }
        assertEquals(tables[0].map { it.take(14) }, tables[1].map { it.take(14) })
    }

    @Tag("thorough")
    @Test
    fun `where the others are moonlets there is nothing to compare`(@TempDir home: Path) {
        val one = listOf(
            """particles={"count":200,"materials":[{"name":"ice","share":1,"sizes":{"type":"equal","radius":0.5}}]}""",
            """bodies=[{"radius":2,"position":[0,0,0],"material":"rock","mass":9}]""",
        )
        val numbers = report(home, small.drop(1) + one)
        assertFalse(numbers.keys.any { "partial_temperature" in it })
        assertFalse(">Materials</h2>" in Files.readString(home.resolve("report.html")))
    }
}
