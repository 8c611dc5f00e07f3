package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

class RunSectionTest {
    @TempDir
    lateinit var home: Path

    private val small = listOf("particles.count=20", "box.lengths=[9,9,9]", "timeStep={\"type\":\"fixed\",\"dt\":0.1}")

    /** What is told of a run with [settings] whose last half is averaged, of a row that lacks an error for [why]. */
    private fun told(why: Unknown?, vararg settings: String): String? {
        val path = home.resolve("${settings.hashCode()} ${settings.joinToString("").hashCode()}")
        Run.start(BuiltIn.scenario("elastic-gas", small + settings), "test", path).use { it.execute() }
        val input = AnalysisInput.ofRun(path)
        val from = (input.times.first() + input.times.last()) / 2
        val averaged = input.times.indices.filter { input.times[it] >= from }
        val study = Study(input, from, averaged, AnalysisOptions(), path)
        return RunSection.longer(study, listOf(NumberRow("n", 1.0, Double.NaN, "", unknown = why)))
            ?.removeSurrounding("A run with ", " may be long enough for these errors.")
    }

    private val few = Unknown.TOO_FEW

    @Test
    fun `the run that may have more is as much longer as it takes, and writes enough`() {
        // 40 steps, of which half are averaged: 80 of 160.
        val states = "output.snapshotEvery=2"
        val rows = "output.transportEvery=2"
        assertEquals("--until 16", told(few, "until=4", states, rows))
        assertEquals("--until 24", told(Unknown.SHORT_TIME, "until=4", states, rows))
        assertEquals("--set output.snapshotEvery=2 --until 16", told(few, "until=4", "output.snapshotEvery=3", rows))
        assertEquals("--set output.snapshotEvery=2 --until 16", told(few, "until=4", "output.snapshotEvery=0", rows))
        assertEquals("--set output.snapshotEvery=2 --until 16", told(few, "until=4", "output.snapshotEvery=999", rows))
        assertEquals(
            "--set output.transportEvery=2 --until 16",
            told(few, "until=4", states, "output.transportEvery=3"),
        )
        // Three states at 2, 3 and 4 would be twelve.
        val intervals = "output={\"snapshotInterval\":1,\"transportEvery\":2}"
        assertEquals("--set output.snapshotInterval=0.3 --until 16", told(few, "until=4", intervals))
        for (why in listOf(null, Unknown.UNSTEADY, Unknown.ONE_STATE)) assertNull(told(why, "until=4"))
    }

    @Test
    fun `digits are those of the length of the run, not of the time at which it begins`() {
        assertEquals("2004.01", RunSection.until(2000.0, 4.001))
        assertEquals("19100000", RunSection.until(0.0, 1.903e7 + 7e4 - 1))
        assertEquals("0.4", RunSection.until(0.0, 4 * 0.1))
        assertEquals("1.2", RunSection.until(0.0, 4 * 0.30000000000000004))
    }
}
