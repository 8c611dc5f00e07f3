package daphnis.core.swap

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.collision.CollisionCounters
import daphnis.core.population.Partition
import daphnis.core.population.Population
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource
import kotlin.math.sqrt

/**
 * Detailed balance: on a frozen row of places, swaps alone visit all arrangements that have room equally often.
 *
 * Eight spheres of three sizes in places at a distance of 1. Large ones do not fit beside large or middle ones, or beside a
 * wall.
 */
class SwapBalanceTest {
    enum class Row(val around: BoundaryConditions, val isRing: Boolean, val larges: Int) {
        RING(Periodic(Box.centred(8.0, 3.0, 3.0)), true, 2),
        DISCS(Periodic(Box.flat(8.0, 3.0)), true, 2),

        /** Walls across all axes, of which only those across x are near. */
        WALLED(Walls(Box.centred(8.0, 3.0, 3.0), 1.0, booleanArrayOf(true, true, true)), false, 1),
    }

    private fun Row.hasRoom(radii: List<Double>): Boolean {
        val first = if (isRing) radii.first() else WALL
        val last = if (isRing) radii.last() else WALL
        return (listOf(last) + radii + first).zipWithNext { a, b -> a + b <= 1 }.all { it }
    }

    private fun arrangements(left: Map<Double, Int>): List<List<Double>> = if (left.isEmpty()) {
        listOf(emptyList())
    } else {
        left.keys.flatMap { r ->
            val rest = if (left[r] == 1) left - r else left + (r to left[r]!! - 1)
            arrangements(rest).map { listOf(r) + it }
        }
    }

    /** Which of [all] can be reached from the first by swaps. */
    private fun reached(all: Set<List<Double>>): Set<List<Double>> {
        val seen = linkedSetOf(all.first())
        val open = ArrayDeque(seen)
        while (open.isNotEmpty()) {
            val here = open.removeFirst()
            for (i in here.indices) {
                for (j in 0 until i) {
                    val there = here.toMutableList().also { it[i] = here[j] }.also { it[j] = here[i] }
                    if (there in all && seen.add(there)) open += there
                }
            }
        }
        return seen
    }

    private fun at(radii: List<Double>, row: Row): Population {
        val n = radii.size
        val still = DoubleArray(n)
        // Ids with gaps, in an order that is not that of places.
        val ids = IntArray(n) { 3 * ((5 * it + 2) % n) + 1 }
        val x = DoubleArray(n) { row.around.box.lowerX + it + 0.5 }
        val r = radii.toDoubleArray()
        val mass = DoubleArray(n) { r[it] * r[it] * r[it] }
        return Population(x, DoubleArray(n), DoubleArray(n), still, still.copyOf(), still.copyOf(), r, mass, ids)
    }

    @ParameterizedTest
    @EnumSource
    fun `all arrangements with room are visited equally often`(row: Row) {
        val counts = mapOf(SMALL to 6 - row.larges, MIDDLE to 2, LARGE to row.larges)
        val permitted = arrangements(counts).filter { row.hasRoom(it) }
        assertEquals(permitted.toSet(), reached(permitted.toSet()))
        for (seed in 1L..3L) {
            val population = at(permitted.first(), row)
            val swaps = SwapMoves(SwapRule(1.0, seed))
            val counters = CollisionCounters()
            val visits = permitted.associateWithTo(HashMap()) { 0 }
            repeat(SAMPLES) {
                swaps.carryOut(population, row.around, Partition.Whole, it * APART, (it + 1) * APART, counters)
                visits.merge(population.radius.toList(), 1, Int::plus)
            }
            assertEquals(permitted.toSet(), visits.keys)
            val expected = SAMPLES.toDouble() / permitted.size
            val chi = visits.values.sumOf { (it - expected) * (it - expected) / expected }
            val freedom = permitted.size - 1.0
            assertEquals(freedom, chi, 4 * sqrt(2 * freedom)) { "$row, seed $seed" }
            assertTrue(counters.swaps in 1 until counters.swapAttempts)
            // Of all draws those of two that differ; a sphere and itself are among the others.
            val differ = 1 - counts.values.sumOf { it * it / 64.0 }
            val draws = SAMPLES * APART * 8
            assertEquals(differ * draws, counters.swapAttempts.toDouble(), 4 * sqrt(differ * (1 - differ) * draws))
        }
    }

    private companion object {
        const val SMALL = 0.3
        const val MIDDLE = 0.45
        const val LARGE = 0.6

        /** As much room as at a wall half a distance away. */
        const val WALL = 0.5

        const val SAMPLES = 10_000

        /** Draws per sphere between two looks, after which the arrangement is another one. */
        const val APART = 40.0
    }
}
