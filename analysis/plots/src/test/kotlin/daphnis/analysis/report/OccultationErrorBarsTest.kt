package daphnis.analysis.report

import daphnis.analysis.occultation.Footprint
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path
import kotlin.math.sqrt

/** Errors of the light through real runs against their scatter from seed to seed: docs/validation.md has the numbers. */
@Tag("thorough")
class OccultationErrorBarsTest {
    @Test
    fun `errors of scans and of a grid are as large as their numbers scatter from seed to seed`(@TempDir home: Path) {
        val scenario = BuiltIn.scenario(
            "ring-patch",
            listOf(
                "box.lengths=[30,30,20]",
                "timeStep.steps=60",
                "output.transportEvery=0",
                "output.seriesEvery=0",
                "output.snapshotEvery=30",
                "output.checkpointEvery=0",
                "untilOrbits=30",
            ),
        )
        val options = OccultationOptions(doubleArrayOf(20.0, 50.0), 3, Footprint.rectangle(5.0, 5.0), photons = 1000.0)
        val bars = ErrorBars(AnalysisOptions(occultation = options))
        for (seed in 1L..SEEDS) bars.add(scenario, seed, home.resolve("$seed"))
        println(bars.table())
        val lines = bars.lines().associateBy { it.name }
        val names = listOf("mean transmission of the scans", "excess variance", "skewness", "transmission at 20°, 0°")
        val found = names.map(lines::getValue)
        val spread = sqrt(found.sumOf { it.spread * it.spread } / found.size)
        val covered = found.map { it.covered }.average()
        assertTrue(spread in 0.8..1.25 && covered in 0.55..0.78) { bars.table() }
    }

    private companion object {
        const val SEEDS = 40
    }
}
