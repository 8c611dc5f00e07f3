package daphnis.core.search

import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Test

class GridSortTest {
    @Test
    fun `both sorts, on any number of threads, give the order of the counting sort on one`() {
        for (seed in 1L..12L) {
            val random = SeededRandom(seed)
            val n = 4000 + random.nextInt(6000)
            val box = Box.centred(20.0, 30.0, 5.0)
            fun places(length: Double) = DoubleArray(n) { random.nextDouble(-length / 2, length / 2) }
            val x = places(20.0)
            // Sometimes already in the order of the slow axis, as after a step; sometimes all in one cell.
            val y = places(30.0).also { if (seed % 3 == 0L) it.sort() }
            val z = if (seed % 4 == 0L) DoubleArray(n) else places(5.0)
            val zeros = DoubleArray(n)
            val p = Population(x, y, z, zeros, zeros, zeros, DoubleArray(n) { 0.05 }, DoubleArray(n) { 1.0 })
            val reach = DoubleArray(3) { 0.1 }
            val expected = Grid().apply { build(p, Periodic(box), 0.0, 1.0, reach) }
            for (threads in intArrayOf(2, 3, 8)) {
                FixedPool(threads).use { pool ->
                    for (strategy in LoopStrategy.entries) {
                        for (sort in GridSort.entries) {
                            val grid = Grid(sort)
                            // Twice, so that leftovers of the first would show.
                            repeat(2) { grid.build(p, Periodic(box), 0.0, 1.0, reach, ParallelLoop(pool, strategy)) }
                            val story = "seed $seed, $n spheres, $threads threads, $strategy, $sort"
                            assertArrayEquals(expected.order.copyOf(n), grid.order.copyOf(n), story)
                            val cells = expected.cellsAlong(0) * expected.cellsAlong(1) * expected.cellsAlong(2)
                            assertArrayEquals(
                                expected.cellStart.copyOf(cells + 1),
                                grid.cellStart.copyOf(cells + 1),
                                story,
                            )
                        }
                    }
                }
            }
        }
    }
}
