package daphnis.analysis.report

import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.math.sqrt

/** A short form of what `tools/error-bars` holds: docs/validation.md has the whole. */
@Tag("thorough")
class ErrorBarsTest {
    @Test
    fun `errors of a small ring are as large as its numbers scatter from seed to seed`(@TempDir home: Path) {
        val scenario = BuiltIn.scenario(
            "ring-patch",
            listOf(
                "box.lengths=[30,30,20]",
                "timeStep.steps=60",
                "output.transportEvery=6",
                "output.seriesEvery=0",
                "output.snapshotEvery=240",
                "output.checkpointEvery=0",
            ),
        )
        val bars = ErrorBars()
        for (seed in 1L..SEEDS) bars.add(scenario, seed, home.resolve("$seed"))
        val lines = bars.lines().associateBy { it.name }
        // With blocks of a hundredth of the run these were 1.5 in the mean, and the last one 0.3.
        val slow = listOf("sigma_x", "sigma_y", "sigma_z", "scale_height", "viscosity_total").map(lines::getValue)
        val spread = sqrt(slow.sumOf { it.spread * it.spread } / slow.size)
        val covered = slow.map { it.covered }.average()
        assertTrue(spread in 0.8..1.2 && covered in 0.55..0.78) { bars.table() }
        assertTrue(slow.all { it.given >= 0.75 * SEEDS }) { bars.table() }
        assertTrue(lines.getValue("shear_work_over_dissipation").spread in 0.7..1.3) { bars.table() }
        assertEquals(SEEDS, bars.runs)
        // Errors of a line are 3.5 of those of the average.
        for ((name, found) in bars.drifts()) {
            assertTrue(found.first() <= 0.08 * SEEDS && found.last() >= 0.75 * SEEDS) { "$name: $found" }
        }
    }

    private companion object {
        const val SEEDS = 40
    }
}
