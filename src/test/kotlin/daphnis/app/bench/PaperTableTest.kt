package daphnis.app.bench

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PaperTableTest {
    private fun timing(scenario: String, threads: Int) =
        Timing(scenario, 70_736, "serial", threads, 300, 440_000, listOf(3.0, 2.8), listOf(2.5, 2.9), "25")

    @Test
    fun `a system of the paper stands beside what its authors' program needs, with the source`() {
        val table = PaperTable.of(listOf(listOf(timing("paper-figure-1", 1), timing("paper-figure-1", 2))))!!
        assertEquals(
            "| paper-figure-1 | serial | 2.80 | 2.90 | 6.36 | 7.90 | 17.9 | 2.8 | 1.06 to 1.20 |",
            table.lines()[2],
        )
        assertEquals("", table.lines()[3])
        for (source in listOf("157ca72", "on another day", "Lewis & Massingill", "left out")) {
            assertTrue(source in table) { source }
        }
        assertTrue(table.lines().drop(3).all { it.length <= 120 })
    }

    @Test
    fun `what the paper has not makes no table`() {
        assertNull(PaperTable.of(listOf(listOf(timing("paper-figure-1", 2)), listOf(timing("cooling-gas", 1)))))
        assertNull(PaperTable.of(emptyList()))
    }
}
