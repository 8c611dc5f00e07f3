package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.analysis.order.RadialKey
import daphnis.analysis.streamline.Streamlines
import daphnis.core.boundary.Box
import daphnis.core.hill.HillSheet
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class StreamlineRunsTest {
    /** Spheres in four groups; the second is moved [by] outward in the slabs [displaced], its guiding centre is not. */
    private fun lines(by: Double, displaced: IntRange): Streamlines {
        val slabs = 8
        val groups = 4
        val each = 4
        val n = slabs * groups * each
        fun slab(k: Int) = k / (groups * each)
        fun group(k: Int) = k / each % groups
        val box = Box.centred(40.0, 80.0, 10.0)
        val home = DoubleArray(n) { -15.0 + 10.0 * group(it) + 0.01 * (it % each) }
        val off = DoubleArray(n) { if (group(it) == 1 && slab(it) in displaced) by else 0.0 }
        val population = Population(
            DoubleArray(n) { home[it] + off[it] },
            DoubleArray(n) { -35.0 + 10.0 * slab(it) + it % each },
            DoubleArray(n),
            DoubleArray(n),
            // The guiding centre is 4 x + 2 v_y/Ω.
            DoubleArray(n) { (home[it] - 4 * (home[it] + off[it])) / 2 },
            DoubleArray(n),
            DoubleArray(n) { 0.5 },
            DoubleArray(n) { 1.0 },
        )
        return Streamlines.of(State(population, HillSheet(box, 1.0), 0.0, 1.0), slabs, groups, RadialKey.GUIDING_CENTRE)
    }

    @Test
    fun `forced eccentricity is taken for noise where as few slabs without it may be chance`() {
        // Of noise (1 − 1/e) is the share of them; e⁻⁴ is 1.8 % and e⁻⁵ 0.7 %.
        assertEquals(
            listOf(true, false),
            listOf(4 to 0, 5 to 0).map { (n, zeros) ->
                StreamlineSection.isNoise(n, zeros)
            },
        )
        // Mean 85 and standard deviation 5.6.
        assertEquals(listOf(true, true, false), listOf(85, 75, 68).map { StreamlineSection.isNoise(135, it) })
        assertEquals(listOf(true, true, false), listOf(2000, 1264, 1000).map { StreamlineSection.isNoise(2000, it) })
    }

    @Test
    fun `streamlines in their order are drawn whole`() {
        val runs = StreamlineRuns(lines(0.0, 0..-1), (0..3).toList())
        assertEquals(1.0, runs.part)
        assertEquals(listOf(0, 1, 2, 3), runs.list.map { it.first })
        assertTrue(runs.list.all { it.second == (0..7).toList() })
    }

    @Test
    fun `where one crosses the next neither is drawn`() {
        val runs = StreamlineRuns(lines(12.0, 3..4), (0..3).toList())
        val drawn = runs.list.groupBy({ it.first }, { it.second })
        assertEquals(listOf((0..7).toList()), drawn[0])
        for (g in 1..2) assertEquals(listOf((0..2).toList(), (5..7).toList()), drawn[g])
        assertEquals(28 / 32.0, runs.part)
    }
}
