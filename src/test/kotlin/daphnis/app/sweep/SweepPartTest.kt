package daphnis.app.sweep

import daphnis.core.input.InputException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SweepPartTest {
    private fun runs(count: Int) = List(count) { PlannedRun("$it", emptyList(), emptyList(), null) }

    private fun part(text: String, vararg environment: Pair<String, Any>): Pair<Int, Int> {
        val part = SweepPart.parse(text, environment.associate { (name, value) -> name to "$value" })
        return part.number to part.parts
    }

    private fun refused(text: String, vararg environment: Pair<String, Any>): String =
        assertThrows(InputException::class.java) { part(text, *environment) }.message!!

    @Test
    fun `each run is in one part, whatever their number`() {
        val runs = runs(24)
        for (parts in listOf(1, 2, 3, 7, 24, 30)) {
            val shares = (1..parts).map { SweepPart(it, parts).of(runs) }
            assertEquals(runs.map { it.name }.sorted(), shares.flatten().map { it.name }.sorted())
            assertTrue(shares.maxOf { it.size } - shares.minOf { it.size } <= 1)
        }
        assertEquals(listOf("1", "4", "7"), SweepPart(2, 3).of(runs(9)).map { it.name })
    }

    @Test
    fun `parts are given as numbers, and wrong ones refused in one line`() {
        assertEquals(2 to 8, part("2/8"))
        assertEquals(1 to 1, part(" 1 / 1 "))
        for ((text, why) in listOf(
            "0/4" to "parts are numbered from 1 to 4",
            "5/4" to "parts are numbered from 1 to 4",
            "-1/4" to "parts are numbered from 1 to 4",
            "1/0" to "there must be 1 to",
            "1/99999999" to "there must be 1 to",
            "1" to "such as 2/8",
            "1/2/3" to "such as 2/8",
            "a/b" to "such as 2/8",
            "" to "such as 2/8",
            "1.5/2" to "such as 2/8",
        )) {
            val said = refused(text)
            assertTrue("--part" in said && why in said && said.lines().size == 1) { said }
        }
    }

    @Test
    fun `a task of an array knows its part, however the tasks are numbered`() {
        val id = "SLURM_ARRAY_TASK_ID"
        val count = "SLURM_ARRAY_TASK_COUNT"
        val min = "SLURM_ARRAY_TASK_MIN"
        val max = "SLURM_ARRAY_TASK_MAX"
        val step = "SLURM_ARRAY_TASK_STEP"
        assertEquals(3 to 8, part("auto", id to 3, count to 8))
        assertEquals(3 to 8, part("auto", id to 3, count to 8, min to 1, max to 8, step to 1))
        assertEquals(1 to 8, part("auto", id to 0, count to 8, min to 0, max to 7, step to 1))
        assertEquals(3 to 4, part("auto", id to 14, count to 4, min to 10, max to 16, step to 2))
        // Tasks 3 and 7 of an array of eight.
        assertTrue("no whole division" in refused("auto", id to 7, count to 2, min to 3, max to 7, step to 1))
        assertTrue("no whole division" in refused("auto", id to 0, count to 8))
        assertTrue("no whole division" in refused("auto", id to 9, count to 8))
        assertTrue("no whole division" in refused("auto", id to 15, count to 4, min to 10, max to 16, step to 2))
        assertTrue("no whole division" in refused("auto", id to 1, count to 0))
        assertTrue("$count is not set" in refused("auto", id to 3))
        assertTrue("$id is not set" in refused("auto", count to 3))
        assertTrue("'x', which is no number" in refused("auto", id to "x", count to 3))
    }

    @Test
    fun `an indexed job knows its part where it is told how many there are`() {
        val index = "JOB_COMPLETION_INDEX"
        assertEquals(1 to 6, part("auto", index to 0, "JOB_COMPLETIONS" to 6))
        assertEquals(6 to 6, part("auto", index to 5, "JOB_COMPLETIONS" to 6))
        assertTrue("JOB_COMPLETIONS is not set" in refused("auto", index to 0))
        assertTrue("$index is 6 with JOB_COMPLETIONS 6" in refused("auto", index to 6, "JOB_COMPLETIONS" to 6))
        assertTrue("both" in refused("auto", index to 0, "SLURM_ARRAY_TASK_ID" to 1))
        assertTrue("no job of an array" in refused("auto"))
    }
}
