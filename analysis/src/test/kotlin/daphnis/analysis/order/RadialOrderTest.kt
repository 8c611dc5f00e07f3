package daphnis.analysis.order

import daphnis.analysis.insitu.State
import daphnis.analysis.uniform
import daphnis.core.boundary.Box
import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillSheet
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import kotlin.math.sqrt

class RadialOrderTest {
    private val sheet = HillSheet(Box.centred(10.0, 20.0, 2.0), 1.3)

    private fun ids(order: RadialOrder, state: State) = IntArray(order.size) { state.population.id[order.order[it]] }

    private fun slow(state: State, key: (Int) -> Double): IntArray {
        val p = state.population
        return (0 until p.size).sortedWith(compareBy<Int>({ key(it) }, { p.id[it] })).map { p.id[it] }.toIntArray()
    }

    @Test
    fun `ranks are those of a plain sort, by each key, on any number of threads`() {
        val state = uniform(5000, sheet, omega = 1.3) { it.nextGaussian() }
        val p = state.population
        FixedPool(3).use { pool ->
            for (order in listOf(RadialOrder(100.0), RadialOrder(100.0, ParallelLoop(pool, LoopStrategy.CHUNKS)))) {
                assertArrayEquals(slow(state) { p.x[it] }, ids(order.sort(state, RadialKey.X), state))
                assertArrayEquals(
                    slow(state) {
                        Epicycle.guidingX(p.x[it], p.vy[it], 1.3)
                    },
                    ids(order.sort(state, RadialKey.GUIDING_CENTRE), state),
                )
                assertArrayEquals(
                    slow(state) {
                        sqrt((p.x[it] + 100) * (p.x[it] + 100) + p.y[it] * p.y[it])
                    },
                    ids(order.sort(state, RadialKey.DISTANCE), state),
                )
                val ranks = order.ranks()
                for (rank in 0 until order.size) assertEquals(rank, ranks[order.order[rank]])
            }
        }
    }

    @Test
    fun `a population that is nearly in order is put right in one pass, also when its arrays were permuted`() {
        val state = uniform(2000, sheet)
        val order = RadialOrder()
        order.sort(state, RadialKey.X)
        assertFalse(order.wasNearlySorted)
        val p = state.population
        val n = p.size
        fun turned(a: DoubleArray) = DoubleArray(n) { a[n - 1 - it] }
        val moved = DoubleArray(n) { p.x[n - 1 - it] + if (it % 7 == 0) 0.005 else 0.0 }
        val next = Population(
            moved, turned(p.y), turned(p.z), turned(p.vx), turned(p.vy), turned(p.vz), turned(p.radius),
            turned(p.mass), IntArray(n) { p.id[n - 1 - it] },
        )
        val nextState = State(next, sheet, 0.1)
        order.sort(nextState, RadialKey.X)
        assertTrue(order.wasNearlySorted)
        assertArrayEquals(slow(nextState) { next.x[it] }, ids(order, nextState))
    }

    @Test
    fun `equal keys stand by id, negative and zero as numbers do, and nobody and one are no trouble`() {
        val x = doubleArrayOf(1.0, -1.0, 0.0, -0.0, -1e300, 1e300, 1.0, 0.0)
        val n = x.size
        val p =
            Population(
                x, DoubleArray(n), DoubleArray(n), DoubleArray(n), DoubleArray(n), DoubleArray(n),
                DoubleArray(n) {
                    1.0
                },
                DoubleArray(n) { 1.0 }, intArrayOf(5, 4, 7, 3, 2, 1, 0, 6),
            )
        val state = State(p, sheet, 0.0)
        assertArrayEquals(intArrayOf(2, 4, 3, 6, 7, 0, 5, 1), ids(RadialOrder().sort(state, RadialKey.X), state))
        val all = uniform(300, sheet).population
        all.x.fill(2.0)
        assertArrayEquals(
            IntArray(300) {
                it
            },
            ids(RadialOrder().sort(State(all, sheet, 0.0), RadialKey.X), State(all, sheet, 0.0)),
        )
        assertEquals(0, RadialOrder().sort(uniform(0, sheet), RadialKey.X).size)
        assertEquals(1, RadialOrder().sort(uniform(1, sheet), RadialKey.X).size)
    }

    @Test
    fun `keys that need a frame or a distance say so`() {
        assertThrows(IllegalArgumentException::class.java) {
            RadialOrder().sort(uniform(3, sheet), RadialKey.GUIDING_CENTRE)
        }
        assertThrows(IllegalArgumentException::class.java) { RadialOrder().sort(uniform(3, sheet), RadialKey.DISTANCE) }
    }
}
