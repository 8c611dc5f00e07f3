package daphnis.drills

import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import java.nio.file.Path

@Tag("drill")
class DamageTest {
    @TempDir
    lateinit var home: Path

    @Test
    fun `whatever is damaged in a run directory, a command does the same or says which file it is`() {
        val cases = Damage(home, SEED).run(CASES)
        val bad = cases.filterNot { it.verdict.isGood }
        assertTrue(bad.isEmpty()) { "seed $SEED:\n" + bad.joinToString("\n") }
        for (verdict in listOf(Verdict.SAME, Verdict.TOLD)) {
            assertTrue(cases.count { it.verdict == verdict } > CASES / 10) { "$verdict" }
        }
    }

    private companion object {
        const val SEED = 20L
        const val CASES = 100
    }
}
