package daphnis.drills

import daphnis.app.assertDone
import daphnis.app.daphnis
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.api.parallel.Execution
import org.junit.jupiter.api.parallel.ExecutionMode
import java.nio.file.Files
import java.nio.file.Path

/** Short forms of the fuzzes; tools/drills has the long ones. */
@Execution(ExecutionMode.SAME_THREAD)
@Tag("drill")
class FuzzTest {
    @TempDir
    lateinit var home: Path

    private fun assertSound(counts: FuzzCounts, cases: Int) {
        assertTrue(counts.faults.isEmpty()) { "$counts" }
        assertTrue(counts.worked >= cases / 20) { "the mutations are too wild to test anything: $counts" }
        assertTrue(counts.refused >= cases / 10) { "the mutations are too tame to test anything: $counts" }
    }

    @Test
    fun `the scenarios that are mutated are sound themselves`() {
        for ((k, seed) in scenarioSeeds().withIndex()) {
            assertDone(daphnis("describe", Files.writeString(home.resolve("$k.json"), "$seed").toString()))
        }
    }

    @Test
    fun `mutated scenarios work or are refused in one line`() = assertSound(scenarioFuzz(150, 1, home), 150)

    @Test
    fun `mutated files of particles are read or refused in one line, whatever door they come by`() =
        assertSound(foreignFuzz(40, 1, home), 40)
}
