package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import kotlin.math.sqrt

/**
 * The deepest overlap in a population.
 *
 * @property first id of one sphere, −1 when nobody overlaps; likewise [second]
 * @property depth (r₁ + r₂ − distance) / (r₁ + r₂); 0 when nobody overlaps
 */
public class Overlap private constructor(public val first: Int, public val second: Int, public val depth: Double) {
    public companion object {
        /**
         * Looks at every pair of neighbours, through the faces too where contacts are found through them. Allocates a
         * grid. Of pairs equally deep it names the first in the order of the grid, for any number of [threads], which
         * end before it returns.
         */
        public fun deepest(
            population: Population,
            boundary: BoundaryConditions,
            time: Double,
            threads: Int = 1,
        ): Overlap = if (threads == 1 || population.size < LEAST_FOR_THREADS) {
            deepest(population, boundary, time, InlineLoop)
        } else {
            FixedPool(threads).use { deepest(population, boundary, time, ParallelLoop(it, LoopStrategy.DYNAMIC)) }
        }

        internal fun deepest(
            population: Population,
            boundary: BoundaryConditions,
            time: Double,
            loop: RangeLoop,
        ): Overlap {
            val grid = Grid()
            grid.build(population, boundary, time, 0.0, DoubleArray(3), loop)
            val searches = Array(loop.workers) { CellRuns(grid) }
            var deepest = Overlap(-1, -1, 0.0)
            var slot = Int.MAX_VALUE
            loop.run(population.size) { worker, from, to ->
                val found = deepest(population, grid, searches[worker], from, to)
                synchronized(grid) {
                    if (found.depth > deepest.depth || found.depth == deepest.depth && from < slot) {
                        deepest = found
                        slot = from
                    }
                }
            }
            return deepest
        }

        /** Of the pairs that the spheres in the slots [from] until [to] look for. */
        private fun deepest(population: Population, grid: Grid, near: CellRuns, from: Int, to: Int): Overlap {
            var first = -1
            var second = -1
            var depth = 0.0
            for (slot in from until to) {
                val k = grid.order[slot]
                val runs = near.ahead(
                    slot,
                    population.x[k],
                    population.y[k],
                    population.z[k],
                    0.0,
                    0.0,
                    0.0,
                    population.radius[k],
                )
                for (r in 0 until runs) {
                    for (other in near.from[r] until near.to[r]) {
                        if (other == slot) continue
                        val found = depth(population, grid, k, grid.order[other], near.image[r])
                        if (found <= depth) continue
                        depth = found
                        first = population.id[k]
                        second = population.id[grid.order[other]]
                    }
                }
            }
            return Overlap(minOf(first, second), maxOf(first, second), depth)
        }

        private fun depth(population: Population, grid: Grid, a: Int, b: Int, image: Int): Double {
            val dx = population.x[b] - population.x[a] + grid.images.shift(image, 0)
            val dy = population.y[b] - population.y[a] + grid.images.shift(image, 1)
            val dz = population.z[b] - population.z[a] + grid.images.shift(image, 2)
            val s = population.radius[a] + population.radius[b]
            return (s - sqrt(dx * dx + dy * dy + dz * dz)) / s
        }

        /** Below some milliseconds of work the threads are not worth their start. */
        private const val LEAST_FOR_THREADS = 20_000
    }
}
