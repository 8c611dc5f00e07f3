package daphnis.drills

import daphnis.app.allEngines
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test

/** The drills in their short forms; the long ones are run by hand, see tools/drills and docs/reliability.md. */
@Tag("drill")
class DrillsTest {
    private val isLong = java.lang.Boolean.getBoolean("daphnis.long")

    private fun assertNothingLost(drill: Drill, cases: Int, seed: Long = 1) {
        val told = ArrayList<String>()
        val tally = drill.run(cases, seed) { told += it }
        assertEquals(emptyList<String>(), tally.lost) { told.joinToString("\n") }
        assertTrue(tally.tried >= cases) { "only ${tally.tried} of $cases were tried" }
    }

    @Test
    fun `runs that are killed and resumed leave the files of unbroken ones`() = assertNothingLost(KillDrill, 5)

    @Test
    fun `a live run notices nothing of who else uses its directory`() = assertNothingLost(LiveDirectoryDrill, 3)

    @Test
    fun `with too little memory everything ends by itself`() = assertNothingLost(SmallHeapDrill, 5)

    @Test
    fun `nodes that die, stand still, come and go leave the files of one engine`() =
        assertNothingLost(NodesDrill, if (isLong) 10 else 1)

    @Test
    fun `a network that fails costs a run over nodes no bit`() {
        assumeTrue(isLong && Namespaces.refusal() == null) {
            "only with --long, and where network namespaces can be had"
        }
        assertNothingLost(NetworkDrill, 5)
    }

    @Test
    fun `drawn systems end with one digest in every engine, each of which is timed`() {
        val told = ArrayList<String>()
        val tally = CliffDrill.run(6, 1) { told += it }
        assertEquals(emptyList<String>(), tally.lost) { told.joinToString("\n") }
        assertEquals(6, tally.tried)
        assertEquals(6, told.size)
        for (engine in allEngines.names - "serial") {
            assertTrue(
                tally.notes.any {
                    it.startsWith("$engine: half of the cases")
                },
            ) { tally.notes.joinToString("\n") }
        }
        assertEquals(10, tally.notes.count { " × in " in it })
    }

    @Test
    fun `on and on nothing overlaps, heats up or grows`() = assertNothingLost(SoakDrill, 30_000)
}
