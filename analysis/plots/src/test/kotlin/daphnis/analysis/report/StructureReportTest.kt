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

/** What reports of gases at rest say of their structure. */
class StructureReportTest {
    @TempDir
    lateinit var home: Path

    private fun report(name: String, scenario: String, vararg settings: String): Path {
        val path = home.resolve(name)
        Run.start(BuiltIn.scenario(scenario, settings.toList()), scenario, path).use { it.execute() }
        Analysis(AnalysisInput.ofRun(path)).write(path)
        return path
    }

    private fun rows(path: Path, table: String) =
        Files.readAllLines(path.resolve("tables/$table.csv")).map { it.split(',') }

    private fun gas(radii: String, edge: String, count: Int) = arrayOf(
        "particles={\"count\":$count,\"sizes\":{\"type\":\"list\",\"radii\":$radii},\"mass\":1}",
        "box.lengths=$edge",
        "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
        "timeStep={\"type\":\"fixed\",\"dt\":0.1}",
        "output={\"snapshotEvery\":5,\"seriesEvery\":5}",
        "until=20",
    )

    @Test
    fun `an elastic gas has S at 0, contact value and the structure factor beside theory`() {
        val path = report("equal", "elastic-gas", *gas("[0.5]", "[7.57,7.57,7.57]", 250))
        val numbers = rows(path, "numbers").associateBy { it[0] }
        for ((key, known) in mapOf("structure_factor_zero" to 0.0963, "contact_value" to 2.4949)) {
            val row = numbers.getValue(key)
            assertEquals(known, row[4].toDouble(), 0.005 * known) { key }
            assertTrue(abs(row[1].toDouble() - known) < 4 * row[2].toDouble()) { row.joinToString() }
        }
        // Free flight: exp(−k² T t²/2) at first, 0 in the end.
        val memory = rows(path, "self-scattering")
        assertEquals(listOf("F_s", "F_s_error", "alpha_2", "alpha_2_error"), memory[0].drop(1))
        assertTrue(memory[1][1].toDouble() in 0.05..0.4 && abs(memory.last()[1].toDouble()) < 0.05)
        val factor = rows(path, "structure-factor")
        assertEquals("S_theory", factor[0][3])
        assertTrue("in space" in Files.readString(path.resolve("report.html")))
        assertEquals(2, AnalysisInput.ofRun(path).let { Analysis(it).numbers() }.count { it.key in KEYS })
        assertFalse(Files.exists(path.resolve("tables/contact-values.csv")))
    }

    @Tag("thorough")
    @Test
    fun `memory that is lost from one state to the next is not drawn, and the report says what would show it`() {
        val path = report("sparse", "elastic-gas", *gas("[0.5]", "[10,10,10]", 250), "output.snapshotEvery=7")
        assertFalse(Files.exists(path.resolve("plots/self-scattering.svg")))
        val html = Files.readString(path.resolve("report.html"))
        assertTrue(Regex("noise within 0\\.\\d+ [^(]*\\(output.snapshotEvery\\)").containsMatchIn(html)) {
            html.substringAfter("No self-intermediate").take(300)
        }
    }

    @Tag("thorough")
    @Test
    fun `where density varies over long distances g is said not to tend to 1`() {
        // A third of a box that is full, the rest empty: all have three times the mean density around them.
        val random = java.util.Random(1)
        val lines = (0 until 16).joinToString("") { frame ->
            val rows = (0 until 400).joinToString("") {
                "1 ${12 * random.nextDouble()} ${36 * random.nextDouble()} ${36 * random.nextDouble()} 0.1\n"
            }
            "400\nLattice=\"36 0 0 0 36 0 0 0 36\" Properties=species:S:1:pos:R:3:radius:R:1 Time=$frame\n$rows"
        }
        val file = home.resolve("third.xyz")
        Files.writeString(file, lines)
        val out = Files.createDirectories(home.resolve("out"))
        Analysis(AnalysisInput.ofFile(file, null, "")).write(out)
        val html = Files.readString(out.resolve("report.html"))
        assertTrue(Regex("g is about [23]\\.\\d+, not 1, since the density varies").containsMatchIn(html)) {
            html.substringAfter("Radial distribution").take(600)
        }
    }

    @Tag("thorough")
    @Test
    fun `a mixture has partial ones and contact values`() {
        val path = report("two", "elastic-gas", *gas("[0.5,0.3]", "[6,6,6]", 200))
        assertEquals("S_0.3-0.5", rows(path, "structure-factor-by-size")[0][3])
        assertEquals(7, rows(path, "pair-correlation-by-size")[0].size)
        val contacts = rows(path, "contact-values")
        assertEquals(listOf("0.3", "0.5"), contacts[2].take(2))
        for (row in contacts.drop(1)) {
            assertEquals(row[4].toDouble(), row[2].toDouble(), 5 * row[3].toDouble()) { row.joinToString() }
        }
        assertFalse(rows(path, "numbers").any { it[0] in KEYS })
    }

    @Test
    fun `a crystal is solid-like and has its bond order, a fluid of discs little order`() {
        val path = report(
            "crystal",
            "crystal",
            "box.lengths=[6.272,6.272,6.272]",
            "particles.count=256",
            "until=4",
            "output={\"snapshotEvery\":4}",
        )
        val numbers = rows(path, "numbers").associateBy { it[0] }
        fun value(key: String) = numbers.getValue(key)[1].toDouble()
        assertTrue(value("solid_like_share") > 0.99 && value("largest_solid_share") > 0.99)
        assertTrue(value("bond_order_q6") in 0.45..0.57 && value("bond_order_w6") < 0)
        assertTrue(value("bond_order_average_q6") in 0.4..0.57)
        assertTrue("structure_factor_zero" !in numbers && "contact_value" in numbers)
        val order = rows(path, "bond-order")
        assertTrue("density_q4" in order[0])
        assertEquals(1.0, order.drop(1).sumOf { it[1].toDouble() } * 0.65 / 50, 1e-9)
        val page = Files.readString(path.resolve("report.html"))
        assertTrue("Order of neighbours" in page && "In a crystal these bins beat with its planes" in page)
        assertTrue("since the density varies" !in page) { "g of a crystal swings around 1" }
        val discs = report(
            "discs",
            "hard-discs",
            "particles.count=300",
            "box.lengths=[19.4,19.4]",
            "placement={\"type\":\"grown\"}",
            "until=10",
            "output.snapshotInterval=0.5",
        )
        val ofDiscs = rows(discs, "numbers").associateBy { it[0] }
        assertTrue(ofDiscs.getValue("hexatic_order_local")[1].toDouble() in 0.4..0.8)
        assertTrue(ofDiscs.getValue("hexatic_order")[1].toDouble() < 0.5)
        assertFalse("bond_order_q6" in ofDiscs)
        assertTrue("structure_factor_zero" in ofDiscs)
    }

    @Tag("thorough")
    @Test
    fun `a gas that cools has spectra with the critical length, and clusters`() {
        val path = report(
            "cooling",
            "cooling-gas",
            "particles.count=1000",
            "until=30",
            "output={\"snapshotEvery\":50,\"seriesEvery\":10}",
        )
        val page = Files.readString(path.resolve("report.html"))
        assertTrue("Vortices</h2>" in page && "Clusters</h2>" in page && "L_c is" in page)
        assertEquals(
            listOf("k [1/", "S_transverse"),
            rows(path, "velocity-spectra")[0].let {
                listOf(it[0].take(5), it[1])
            },
        )
        // All in clusters by the distance of contacts; numbers of a state that changes are not in the table.
        assertTrue(rows(path, "cluster-history").size > 2)
        assertTrue(rows(path, "cluster-sizes").size > 2 && rows(path, "clusters").size > 2)
        assertFalse(rows(path, "numbers").any { "cluster" in it[0] })
    }

    private companion object {
        val KEYS = listOf("structure_factor_zero", "contact_value")
    }
}
