package daphnis.analysis.report

import daphnis.analysis.input.AnalysisInput
import daphnis.analysis.statistics.Steadiness.Verdict
import daphnis.core.initial.SeededRandom
import daphnis.core.run.Run
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Files
import java.nio.file.Path
import kotlin.math.PI
import kotlin.math.sin

/** Steadiness of quantities that a wave swings. */
class WaveSteadinessTest {
    private fun history(rows: Int, value: (Double) -> Double) =
        DoubleArray(rows) { it * 0.05 }.let { times -> History("q", times, DoubleArray(rows) { value(times[it]) }) }

    @Test
    fun `means over whole periods leave nothing of a wave, and are those of the rows`() {
        val period = 0.873
        val swinging = history(2000) { 5 + 3 * sin(2 * PI * it / period + 1) }
        val means = swinging.overPeriods(period, 20.0)
        assertTrue(means.values.size in 112..115) { "${means.values.size}" }
        // A period has 17 or 18 rows, which is not quite a whole one.
        assertTrue(means.values.all { Math.abs(it - 5) < 0.2 }) { means.values.joinToString() }
        assertEquals(period, means.times[7] - means.times[6], 0.06)
        assertEquals(swinging.keys, means.keys)
        val rising = history(2000) { it + 3 * sin(2 * PI * it / period) }.overPeriods(period, 20.0)
        assertEquals(Verdict.DRIFTING, rising.steadiness(20.0).verdict)
    }

    @Test
    fun `rows stay where a period has too few of them, or too few periods are left`() {
        val rows = history(200) { sin(it) }
        assertSame(rows, rows.overPeriods(0.06, 0.0))
        assertSame(rows, rows.overPeriods(1.0, 0.0))
        assertSame(rows, rows.overPeriods(0.3, 8.0))
        assertTrue(rows.overPeriods(0.3, 0.0).values.size == 33 - 1 || rows.overPeriods(0.3, 0.0).values.size == 33)
    }

    @Test
    fun `few of many made waves that are saturated are called drifting`() {
        var drifting = 0
        for (seed in 1L..200L) {
            val random = SeededRandom(seed)
            val phase = 2 * PI * random.nextDouble()
            val saturated = history(1200) {
                (5 + 0.3 * random.nextGaussian()) * (1 + 0.4 * sin(2 * PI * it / 0.873 + phase))
            }
            val found = saturated.overPeriods(0.873, 22.5).steadiness(22.5)
            if (found.verdict == Verdict.DRIFTING) drifting++
        }
        assertTrue(drifting <= 8) { "$drifting of 200" }
    }

    @Tag("thorough")
    @Test
    fun `a wave that grows to the end is named with its rate`(@TempDir home: Path) {
        val settings = listOf("timeStep.steps=200", "output.modesEvery=10", "output.transportEvery=5", "untilOrbits=20")
        Run.start(BuiltIn.scenario("overstability", settings), "waves", home).use { it.execute() }
        Analysis(AnalysisInput.ofRun(home)).write(home)
        val html = Files.readString(home.resolve("report.html"))
        val said =
            Regex(
                "a wave 100 units of length long grows by a factor e\\^\\(0\\.(?:09|1)[^)]*\\) per orbit, to the end",
            )
        assertTrue(said.containsMatchIn(html)) { html.substringAfter("Not steady").take(600) }
    }
}
