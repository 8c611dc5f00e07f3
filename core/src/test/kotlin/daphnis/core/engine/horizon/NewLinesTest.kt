package daphnis.core.engine.horizon

import daphnis.core.parallel.InlineLoop
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class NewLinesTest {
    @Test
    fun `no two lines of an epoch get the same version, in whichever group and however many at once`() {
        val space = EpochSpace(InlineLoop)
        val sight = Sight(space.lines, space.before, space.shares)
        val groups = List(3) { NewLines(space, sight, space.roamers, it, 3) }
        space.lines.begin(SLOTS)
        // Cells are not asked in an epoch that cannot go on.
        space.lines.put(0, Double.NaN, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        repeat(2) {
            for (group in groups) group.begin()
            val versions = ArrayList<Int>()
            for (count in listOf(1, 4, 1, 2)) {
                for (group in groups) {
                    val first = group.takeVersions(count)
                    for (slot in 0 until count) {
                        group.settleInCell(slot, 0.0, first + slot)
                        versions += space.lines.version[slot]
                    }
                }
            }
            // 0 is that of a line which a sphere had at the start.
            assertEquals(24, versions.filter { it > 0 }.toSet().size) { "$versions" }
        }
    }

    private companion object {
        const val SLOTS = 4
    }
}
