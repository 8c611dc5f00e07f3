package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.format.H5md
import daphnis.core.format.Snapshot
import daphnis.core.run.Run
import daphnis.core.run.RunDirectory
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path

@Tag("jdk-neutral")
class DiffusionSectionTest {
    @TempDir
    lateinit var home: Path

    /** The section of the run in [path] from [from] on. */
    private fun section(path: Path, from: Double): DiffusionSection {
        val input = AnalysisInput.ofRun(path)
        val section = DiffusionSection(Study(input, from, listOf(input.size - 1), AnalysisOptions(), path))
        for (k in section.followed) section.follow(input.snapshot(k))
        return section
    }

    @Tag("thorough")
    @Test
    fun `the elastic gas diffuses as it should, from the snapshots of a run`() {
        val path = home.resolve("gas")
        val settings = listOf(
            "particles.count=2744",
            "box.lengths=[24.3105,24.3105,24.3105]",
            "until=100",
            "output.snapshotEvery=10",
            "output.checkpointEvery=0",
            "velocities={\"type\":\"gaussian\",\"sigma\":1,\"exact\":true}",
        )
        Run.start(BuiltIn.scenario("elastic-gas", settings), "gas", path).use { it.execute() }
        val rows = section(path, 5.0).numbers()
        val names = listOf("", "∞ of an infinite box", "_x", "_y", "_z").map { "self-diffusion D$it" }
        assertEquals(names, rows.map { it.name })
        assertEquals(0.929, rows[0].value, 0.04 * 0.929) { "D = ${rows[0].value} ± ${rows[0].error}" }
        assertTrue(rows[0].error < 0.03) { "${rows[0].error}" }
        for (row in rows.drop(2)) assertEquals(0.929, row.value, 4 * row.error) { row.name }
        // η of Enskog is 0.2232 at this density, ρ 0.6/π: 2.837297/(6π · (0.2232 + 0.6/π · D) · 24.3105).
        val resistance = 0.2232 + 0.6 / Math.PI * rows[0].value
        assertEquals(0.02774 * 0.2232 / resistance, rows[1].value - rows[0].value, 2e-4) { rows[1].note }
        assertTrue(rows[1].error == rows[0].error && "Yeh & Hummer" in rows[1].note && "Enskog" in rows[1].note)
        // As versions wrote them that did not count.
        val run = RunDirectory(path)
        for (step in run.snapshotSteps()) {
            val f = H5md.read(run.snapshot(step)).single()
            val silent = with(f) {
                Snapshot(step, time, lengths, periodic, shearOffset, id, position, velocity, radius, mass)
            }
            H5md.write(listOf(silent), run.snapshot(step), "old")
        }
        // Nor did their checkpoints know snapshots.
        for (name in listOf("checkpoint", "checkpoint.previous")) Files.deleteIfExists(path.resolve(name))
        val old = section(path, 5.0)
        assertEquals(emptyList<Any>(), old.numbers())
        assertTrue("do not say how often particles crossed the box" in old.leftOut!!)
    }

    @Test
    fun `sheared boxes diffuse across the flow only, rings by their guiding centres`() {
        val shear = home.resolve("shear")
        Run.start(
            BuiltIn.scenario("shear-cell", listOf("until=4", "output.snapshotEvery=5", "particles.count=300")),
            "shear",
            shear,
        ).use {
            it.execute()
        }
        section(shear, 0.0).write(ReportPage("shear"))
        val header = Files.readAllLines(shear.resolve("tables/mean-square-displacement.csv"))[0]
        assertEquals(
            listOf("lag", "msd_y", "msd_y_error", "msd_z", "msd_z_error"),
            header.split(',').map {
                it.substringBefore(' ')
            },
        )
        val ring = home.resolve("ring")
        val settings =
            listOf("untilOrbits=20", "box.lengths=[50,50,20]", "output.snapshotEvery=20", "output.checkpointEvery=0")
        Run.start(BuiltIn.scenario("ring-patch", settings), "ring", ring).use { it.execute() }
        val row = section(ring, 2 * 2 * Math.PI / 1.4e-4).numbers().single()
        assertEquals("self-diffusion of guiding centres D_X", row.name)
        // Of the order of the translational viscosity, as for any gas.
        assertTrue(row.value > 1 && row.value < 30 && row.error < 0.2 * row.value) {
            "${row.value} ± ${row.error} ${row.unit}, ${row.note}"
        }
    }

    @Tag("thorough")
    @Test
    fun `a run of two sizes has its diffusion among the numbers and its sizes in a section`() {
        val path = home.resolve("two")
        val settings = listOf(
            "particles={\"count\":150,\"sizes\":{\"type\":\"list\",\"radii\":[0.5,0.3]},\"density\":1}",
            "box.lengths=[8,8,8]",
            "until=24",
            "output.snapshotEvery=5",
            "velocities={\"type\":\"gaussian\",\"temperature\":1,\"exact\":true}",
        )
        Run.start(BuiltIn.scenario("elastic-gas", settings), "two", path).use { it.execute() }
        Analysis(AnalysisInput.ofRun(path), AnalysisOptions(from = 2.0, frames = 6)).write(path)
        val html = Files.readString(path.resolve("report.html"))
        for (heading in listOf("Sizes", "Diffusion")) assertTrue(">$heading</h2>" in html) { heading }
        assertTrue(NumberKeys.of(path).containsAll(NumberKeys.DIFFUSION))
        val table = Files.readAllLines(path.resolve("tables/size-classes.csv"))
        assertEquals(
            "count,mean_radius [units of length],sigma_x [units of length/time],sigma_x_error [units of length/time]",
            table[0].split(',').take(4).joinToString(","),
        )
        assertEquals(
            listOf("0.3", "0.5"),
            table.drop(1).map {
                it.split(',')[1].toDouble().let { r -> "%.1f".format(java.util.Locale.ROOT, r) }
            },
        )
        // Equipartition: m c² is the same for both.
        val energy = table.drop(1).map { row ->
            row.split(',').map { it.toDoubleOrNull() ?: Double.NaN }.let {
                it[1] *
                    it[1] *
                    it[1] *
                    it[8] *
                    it[8]
            }
        }
        assertEquals(1.0, energy[0] / energy[1], 0.25)
    }
}
