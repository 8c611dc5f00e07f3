package daphnis.app.bench

import daphnis.app.allEngines
import daphnis.core.scenario.BuiltIn
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class OverviewTest {
    private val contestants =
        listOf("serial" to 1, "actors" to 1, "horizon" to 1, "horizon" to 2).map { Contestant(it.first, it.second) }

    private fun contest(name: String, steps: Long?, vararg settings: String) =
        Contest(allEngines, contestants, BuiltIn.scenario(name, settings.asList()), name, steps)

    @Test
    fun `what will be timed is said`() {
        val whole = contest("cooling-gas", null, "until=0.55")
        val some = contest("shear-cell", 7)
        val lines = Overview(listOf(whole, some), contestants, 3, 1.0).lines()
        assertEquals("cooling-gas: 2000 spheres, 6 steps", lines[0])
        assertEquals("shear-cell: 2048 spheres, 7 steps", lines[1])
        assertEquals("engines: serial, actors on 1 thread; horizon on 1, 2 threads", lines[2])
        assertEquals(
            "1 s of turns, one at least, for each to warm up, then 3 rounds that count: " +
                "2 x 4 x 3 (scenarios x engines x rounds) = 24 turns",
            lines[3],
        )
        val short = Overview(listOf(some), contestants, 1, 0.0).lines().last()
        assertTrue(short.startsWith("one turn for each to warm up, then 1 round that counts: 1 x 4 x 1 ")) { short }
    }

    @Test
    fun `steps that cannot be known before are not said`() {
        val step = """timeStep={"type":"cell-crossing","fraction":0.1,"longest":0.1}"""
        val adaptive = contest("cooling-gas", null, "until=2.0", step)
        val overview = Overview(listOf(contest("cooling-gas", 1), adaptive), contestants, 1, 0.0)
        assertEquals("cooling-gas: 2000 spheres, 1 step", overview.lines()[0])
        assertEquals("cooling-gas: 2000 spheres, to time 2.0", overview.lines()[1])
        assertEquals("about 5 s left of cooling-gas, one scenario after it", overview.left(0, 0, 5.0))
    }

    @Test
    fun `the time left is that of the rounds to come, for later scenarios by spheres and steps`() {
        val overview = Overview(listOf(contest("cooling-gas", 10), contest("cooling-gas", 20)), contestants, 3, 0.0)
        val first = overview.left(0, 0, 10.0)
        assertEquals("about 30 s left of cooling-gas, roughly 2 min with one scenario after it", first)
        assertEquals("cooling-gas is done; roughly 80 s with one scenario after it", overview.left(0, 3, 10.0))
        assertEquals("about 3.3 h left", overview.left(1, 1, 6000.0))
        assertNull(overview.left(1, 3, 6000.0))
    }

    @Test
    fun `the time left has that of warming up later scenarios`() {
        // A round of the second takes 0.02 s, so 150 of them are needed for 4 contestants to have had 0.75 s each.
        val overview = Overview(listOf(contest("cooling-gas", 10), contest("cooling-gas", 20)), contestants, 3, 0.75)
        assertEquals("cooling-gas is done; roughly 3 s with one scenario after it", overview.left(0, 3, 0.01))
        assertEquals("cooling-gas is done; roughly 3 s with one scenario after it", overview.left(0, 3, 0.0))
        // A round of 10 s is longer than that.
        assertEquals("cooling-gas is done; roughly 40 s with one scenario after it", overview.left(0, 3, 5.0))
    }
}
