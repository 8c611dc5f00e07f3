package daphnis.core.search

import daphnis.core.initial.SeededRandom
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class CellCountingTest {
    @Test
    fun `spheres in order with a crowded last cell are sorted stably, on any number of threads`() {
        for (seed in 1L..20L) {
            val random = SeededRandom(seed)
            val n = 4096 + random.nextInt(3000)
            val cells = 1 + random.nextInt(if (seed % 5 == 0L) 3 else 9000)
            // Nearly in order, but for those in the last cell; in every seventh draw there are no others.
            val cellOf = IntArray(n) { k ->
                val isLast = seed % 7 == 0L || random.nextInt(8) == 0
                if (isLast) cells - 1 else (k.toLong() * cells / n + random.nextInt(30)).toInt().coerceAtMost(cells - 1)
            }
            val expected = (0 until n).sortedBy { cellOf[it] }.toIntArray()
            val counting = CellCounting()
            for (threads in intArrayOf(1, 2, 3, 8)) {
                FixedPool(threads).use { pool ->
                    val into = CellOrder()
                    val loop = if (threads == 1) InlineLoop else ParallelLoop(pool, LoopStrategy.DYNAMIC)
                    // Twice, so that leftovers of the first would show.
                    repeat(2) {
                        counting.sort(n, cells, into, loop) { a, b -> for (k in a until b) into.cellOf[k] = cellOf[k] }
                    }
                    val story = "seed $seed, $n spheres, $cells cells, $threads threads"
                    assertArrayEquals(expected, into.order.copyOf(n), story)
                    for (cell in 0 until cells) {
                        assertEquals(cellOf.count { it < cell }, into.start[cell], story)
                        if (cell > 50 && cell < cells - 5) break
                    }
                    assertEquals(cellOf.count { it < cells - 1 }, into.start[cells - 1], story)
                    assertEquals(n, into.start[cells], story)
                }
            }
        }
    }
}
