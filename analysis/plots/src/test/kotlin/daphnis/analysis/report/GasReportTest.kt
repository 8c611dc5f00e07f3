package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import daphnis.core.scenario.ScenarioJson
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ln

/** What reports say of the memory of gases, of their chemical potential and of the stresses of those that are sheared. */
class GasReportTest {
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

    private fun numbers(path: Path) = rows(path, "numbers").associateBy { it[0] }

    private fun column(path: Path, table: String, name: String): List<Double> = rows(path, table).let { all ->
        val k = all[0].indexOfFirst { it.substringBefore(' ') == name }
        all.drop(1).map { it[k].toDoubleOrNull() ?: Double.NaN }
    }

    private fun gas(radii: String, edge: Double, count: Int, until: Int) = arrayOf(
        "particles={\"count\":$count,\"sizes\":{\"type\":\"list\",\"radii\":$radii},\"mass\":1}",
        "box.lengths=[$edge,$edge,$edge]",
        "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
        "timeStep={\"type\":\"fixed\",\"dt\":0.02}",
        "output={\"snapshotEvery\":1,\"seriesEvery\":5,\"transportEvery\":5}",
        "until=$until",
    )

    @Test
    fun `a gas has its velocity autocorrelation, diffusion by two ways, chemical potential and relaxation`() {
        // φ = 0.3.
        val path = report("gas", "elastic-gas", *gas("[0.5]", 5.7337, 108, 30), "timeStep.dt=0.025")
        val numbers = numbers(path)
        fun value(key: String, k: Int = 1) = numbers.getValue(key)[k].toDouble()
        val slope = value("velocity_correlation_slope")
        assertEquals(
            -2.0 / 3 * value("collisions_per_particle") * 108 / 107,
            value("velocity_correlation_slope", 4),
            1e-9,
        )
        assertEquals(value("velocity_correlation_slope", 4), slope, 4 * value("velocity_correlation_slope", 2) + 0.05)
        // The same by both ways, but for places of 128 states and velocities of all.
        assertEquals(1.0, value("self_diffusion_green_kubo") / value("self_diffusion"), 0.1)
        assertEquals(4.8717, value("chemical_potential", 4), 0.01)
        assertEquals(
            4.8717,
            value("chemical_potential"),
            4 * value("chemical_potential", 2) + value("chemical_potential", 6),
        )
        // As Python and sweeps have them.
        val keys = Analysis(AnalysisInput.ofRun(path)).numbers().map { it.key }
        assertTrue(keys.containsAll(NumberKeys.VELOCITIES + NumberKeys.INSERTED)) { "$keys" }
        // A point fits exactly into what is free.
        assertEquals(
            -ln(1 - 108 * PI / 6 / (5.7337 * 5.7337 * 5.7337)),
            column(path, "insertion", "mu_ex_over_kT")[0],
            1e-12,
        )
        assertEquals(21, column(path, "insertion", "theory").size)
        val c = column(path, "velocity-autocorrelation", "C_normalised")
        assertTrue(c[0] == 1.0 && abs(c[1] - (1 + slope * 0.025)) < 0.03 && c.size > 40)
        val q = column(path, "overlap", "Q")
        assertTrue(q[0] > 0.9 && q.last() < 0.3 && column(path, "overlap", "chi_4").any { it > 0.1 })
        val f = column(path, "intermediate-scattering", "F")
        val at = column(path, "intermediate-scattering", "lag")
        assertTrue(at[0] == 0.0 && f[0] in 1.0..1.8 && abs(f.last()) < 0.4) { "$f" }
        val page = Files.readString(path.resolve("report.html"))
        for (heading in listOf("Diffusion", "Relaxation", "Insertion")) assertTrue(">$heading</h2>" in page) { heading }
        // What rings are shown is not of a gas in all of space.
        val ofLayers = listOf("plots/autocorrelation.svg", "tables/autocorrelation.csv", "plots/velocity-ellipsoid.svg")
        assertTrue(ofLayers.none { Files.exists(path.resolve(it)) })
        assertTrue("The dashed line is D by displacements" in page && "No velocity autocorrelation" !in page)
        for (plot in listOf(
            "velocity-autocorrelation",
            "green-kubo",
            "overlap",
            "dynamic-susceptibility",
            "insertion",
        )) {
            assertTrue(Files.exists(path.resolve("plots/$plot.svg"))) { plot }
        }
    }

    @Test
    fun `two spheres that never meet have no slope, and bars are promised where there are some`() {
        Files.writeString(home.resolve("two.csv"), "x,y,z,radius,vx,vy,vz\n-2,0,0,0.5,0.1,0,0\n2,0,0,0.5,0,0.1,0\n")
        val scenario = ScenarioJson.parse(
            """{ "box": { "lengths": [8, 8, 8] }, "boundary": { "type": "periodic" },
              "placement": { "type": "file", "path": "${home.resolve("two.csv")}", "density": 1 },
              "restitution": { "type": "constant", "coefficient": 1 },
              "timeStep": { "type": "fixed", "dt": 0.1 }, "until": 6,
              "output": { "snapshotEvery": 1, "transportEvery": 5 } }""",
            "two",
        )
        val path = home.resolve("two")
        Run.start(scenario, "two", path).use { it.execute() }
        Analysis(AnalysisInput.ofRun(path)).write(path)
        assertTrue(column(path, "velocity-autocorrelation", "C_normalised").all { abs(it - 1) < 1e-12 })
        assertTrue("velocity_correlation_slope" !in numbers(path))
        fun caption(path: Path) =
            Files.readString(path.resolve("report.html")).substringAfter("<figcaption>Velocity autocorrelation")
                .substringBefore("</figcaption>")
        assertTrue("Bars" !in caption(path)) { caption(path) }
        val met = report("met", "elastic-gas", *gas("[0.5]", 5.7337, 108, 4))
        assertTrue("Bars are one standard error; at lags" in caption(met)) { caption(met) }
    }

    @Test
    fun `states far apart have no autocorrelation, and the report says what would show it`() {
        val path = report(
            "sparse",
            "elastic-gas",
            *gas("[0.5]", 5.7337, 108, 16),
            "output.snapshotEvery=12",
        )
        assertFalse(Files.exists(path.resolve("tables/velocity-autocorrelation.csv")))
        assertTrue(numbers(path).keys.none { it in NumberKeys.VELOCITIES })
        val page = Files.readString(path.resolve("report.html"))
        assertTrue(
            Regex(
                "No velocity autocorrelation: states are 0\\.240? .*\\(output.snapshotEvery\\)",
            ).containsMatchIn(page),
        )
    }

    @Tag("thorough")
    @Test
    fun `a dense fluid bounces back, and a mixture has the insertion of each diameter but no one potential`() {
        val dense = report(
            "dense",
            "elastic-gas",
            *gas("[0.5]", 5.0089, 108, 12),
            "placement={\"type\":\"grown\"}",
            "timeStep.dt=0.01",
        )
        val c = column(dense, "velocity-autocorrelation", "C_normalised")
        val error = column(dense, "velocity-autocorrelation", "C_normalised_error")
        assertTrue(c.indices.any { c[it] < -5 * error[it] }) { "${c.min()}" }
        assertTrue("It is clearly negative from" in Files.readString(dense.resolve("report.html")))
        val two = report("two", "elastic-gas", *gas("[0.5,0.3]", 5.0, 108, 16), "output.snapshotEvery=10")
        assertTrue("chemical_potential" !in numbers(two))
        val (found, errors, theory) = listOf("mu_ex_over_kT", "mu_ex_over_kT_error", "theory").map {
            column(two, "insertion", it)
        }
        assertTrue((1..20).all { abs(found[it] - theory[it]) < 5 * errors[it] + 0.05 * theory[it] })
    }

    @Test
    fun `a dilute gas that is sheared has its stresses beside those of Grad`() {
        val path = report(
            "shear",
            "shear-cell",
            "particles.count=300",
            "box.lengths=[25.04,25.04,25.04]",
            "velocities.sigma=17",
            "restitution.coefficient=0.8",
            "timeStep.dt=0.1",
            "until=120",
            "output={\"transportEvery\":2,\"snapshotEvery\":100}",
        )
        val numbers = numbers(path)
        val normal = listOf("xx", "yy", "zz").map { numbers.getValue("normal_stress_$it") }
        assertEquals(3.0, normal.sumOf { it[1].toDouble() }, 1e-14)
        for ((row, known) in normal.zip(listOf(1.30303, 0.84848, 0.84848)) +
            (numbers.getValue("shear_stress_ratio") to 0.43913)) {
            assertEquals(known, row[4].toDouble(), 5e-6) { row[0] }
            assertEquals(known, row[1].toDouble(), 4 * (row[2].toDoubleOrNull() ?: 0.02) + row[6].toDouble()) { row[0] }
        }
    }

    @Tag("thorough")
    @Test
    fun `discs forget their velocity at −2ν over 2, and have Henderson's chemical potential`() {
        val path = report(
            "discs",
            "hard-discs",
            "particles.count=400",
            "box.lengths=[33.33,33.33]",
            "until=60",
            "timeStep={\"type\":\"fixed\",\"dt\":0.06}",
            "output={\"snapshotEvery\":1,\"transportEvery\":5}",
        )
        val numbers = numbers(path)
        val slope = numbers.getValue("velocity_correlation_slope")
        assertEquals(-numbers.getValue("collisions_per_particle")[1].toDouble() * 400 / 399, slope[4].toDouble(), 1e-9)
        assertEquals(slope[4].toDouble(), slope[1].toDouble(), 4 * slope[2].toDouble() + 0.02)
        val potential = numbers.getValue("chemical_potential")
        assertEquals(potential[4].toDouble(), potential[1].toDouble(), 4 * potential[2].toDouble() + 0.02)
    }
}
