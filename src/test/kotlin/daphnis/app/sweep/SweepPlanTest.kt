package daphnis.app.sweep

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class SweepPlanTest {
    private fun names(vararg settings: String, seeds: String? = null) =
        SweepPlan.of(settings.asList(), seeds).runs.map { it.name }

    @Test
    fun `lists give all combinations, each with all seeds`() {
        val plan = SweepPlan.of(listOf("a.x=1,2", "b=9", "c.y=3,4"), "1..2")
        assertEquals(
            listOf(
                "x=1,y=3,seed=1",
                "x=1,y=3,seed=2",
                "x=1,y=4,seed=1",
                "x=1,y=4,seed=2",
                "x=2,y=3,seed=1",
                "x=2,y=3,seed=2",
                "x=2,y=4,seed=1",
                "x=2,y=4,seed=2",
            ),
            plan.runs.map { it.name },
        )
        assertEquals(listOf("a.x=2", "b=9", "c.y=4"), plan.runs.last().settings)
        assertEquals(listOf("2", "4"), plan.runs.last().values)
        assertEquals(listOf("a.x", "c.y"), plan.varying.map { it.path })
    }

    @Test
    fun `names of many long keys stay short enough for file systems, and different`() {
        val keys = (1..4).map { "${"$it".repeat(40)}=${"y".repeat(40)},${"z".repeat(40)}" }.toTypedArray()
        val long = names(*keys, seeds = "1..3")
        assertEquals(48, long.toSet().size)
        assertTrue(long.all { it.length == 255 && Regex(".*,[0-9a-f]{8},seed=[123]").matches(it) }) { "$long" }
    }

    @Test
    fun `a single run has no seed in its name, and a sweep of seeds nothing else`() {
        assertEquals(listOf("x=1", "x=2"), names("a.x=1,2"))
        assertEquals(listOf("seed=3", "seed=5"), names("a.x=1", seeds = "3,5"))
    }

    @Test
    fun `names are different from one another in every file system, and plain`() {
        assertEquals(listOf("a.x=1,b.x=3", "a.x=1,b.x=4"), names("a.x=1,2", "b.x=3,4").take(2))
        assertEquals(listOf("forces-0-.x=-1.5", "forces-0-.x=2e-3"), names("forces[0].x=-1.5,2e-3"))
        assertEquals(listOf("lengths=1-2", "lengths=1-2-2"), names("box.lengths=[1,2],[1 2]"))
        assertEquals(listOf("n=Ab", "n=aB-2"), names("n=Ab,aB"))
        val long = "y".repeat(90)
        assertEquals(listOf("n=" + "y".repeat(32), "n=" + "y".repeat(32) + "-2"), names("n=$long,${long}z"))
        assertTrue(names("n=../..,/etc,\"\"").all { Regex("n=[A-Za-z0-9.-]+").matches(it) })
    }
}
