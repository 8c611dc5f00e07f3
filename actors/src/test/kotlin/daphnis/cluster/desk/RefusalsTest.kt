package daphnis.cluster.desk

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class RefusalsTest {
    private val lines = ArrayList<String>()
    private val refusals = Refusals(lines::add)
    private val second = 1_000_000_000L

    @Test
    fun `whoever tries again and again is named once an hour`() {
        for (t in 0L..3599L) refusals.refused("a:1", "another secret", hasAnswered = true, t * second)
        assertEquals(listOf("refused a:1: another secret"), lines)
        refusals.refused("a:1", "another secret", hasAnswered = true, 3600 * second)
        assertEquals(2, lines.size)
    }

    @Test
    fun `forged calls are counted each minute, and those who have answered are named all the same`() {
        var k = 0
        for (t in 0L until 600L) {
            repeat(50) { refusals.refused("forged:${k++}", "version 0", hasAnswered = false, t * second) }
            if (t % 100 == 99L) refusals.refused("true:$t", "another secret", hasAnswered = true, t * second)
        }
        refusals.tick(601 * second)
        assertEquals(6, lines.count { it.startsWith("refused true:") })
        assertEquals(10 * 20, lines.count { it.startsWith("refused forged:") })
        val counts = lines.filter { "more callers" in it }.map { it.split(' ')[1].toInt() }
        assertEquals(10, counts.size)
        assertEquals(k - 200, counts.sum())
        refusals.tick(700 * second)
        assertTrue(lines.last() != lines[lines.size - 2])
        assertEquals(10, lines.count { "more callers" in it })
    }
}
