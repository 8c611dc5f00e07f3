package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.onThreads
import daphnis.core.population.Population
import kotlin.math.sqrt

/**
 * The deepest overlap in a population.
 *
 * @property first id of one sphere, −1 when none overlap; likewise [second]
 * @property depth (r₁ + r₂ − distance) / (r₁ + r₂); 0 when none overlap
 */
public class Overlap private constructor(public val first: Int, public val second: Int, public val depth: Double) {
    public companion object {
        /**
         * Checks every pair of neighbours, through the faces too where contacts are found through them. Allocates a
         * grid. Of equally deep pairs it returns the first in the order of the grid, for any number of [threads], which
         * are told to end before it returns, and not waited for.
         */
        @JvmStatic
        @JvmOverloads
        public fun deepest(
            population: Population,
            boundary: BoundaryConditions,
            time: Double,
            threads: Int = 1,
        ): Overlap = onThreads(threads, population.size) { deepest(population, boundary, time, it) }

        /** @throws IllegalArgumentException when two spheres overlap by more than [TOLERANCE] */
        internal fun requireNone(population: Population, boundary: BoundaryConditions, time: Double) {
            val overlap = deepest(population, boundary, time)
            require(overlap.depth <= TOLERANCE) {
                "spheres ${overlap.first} and ${overlap.second} overlap by ${overlap.depth} of the sum of their " +
                    "radii; spheres must not overlap at the start"
            }
        }

        internal fun deepest(
            population: Population,
            boundary: BoundaryConditions,
            time: Double,
            loop: RangeLoop,
        ): Overlap {
            val pairs = NearPairs(population, boundary, time, loop)
            val runs = Array(loop.workers) { pairs.runs() }
            var deepest = Overlap(-1, -1, 0.0)
            var slot = Int.MAX_VALUE
            loop.run(population.size) { worker, from, to ->
                val found = deepest(population, pairs, runs[worker], from, to)
                synchronized(pairs) {
                    if (found.depth > deepest.depth || found.depth == deepest.depth && from < slot) {
                        deepest = found
                        slot = from
                    }
                }
            }
            return deepest
        }

        /** The deepest of the pairs found from the slots [from] until [to]. */
        private fun deepest(population: Population, pairs: NearPairs, runs: CellRuns, from: Int, to: Int): Overlap {
            var first = -1
            var second = -1
            var depth = 0.0
            val radius = population.radius
            for (slot in from until to) {
                pairs.forEach(runs, slot, radius[pairs.index(slot)]) { k, j, dx, dy, dz ->
                    val s = radius[k] + radius[j]
                    val found = (s - sqrt(dx * dx + dy * dy + dz * dz)) / s
                    if (found > depth) {
                        depth = found
                        first = population.id[k]
                        second = population.id[j]
                    }
                }
            }
            return Overlap(minOf(first, second), maxOf(first, second), depth)
        }

        /** Depth up to which spheres count as touching at the start. */
        internal const val TOLERANCE = 1e-9
    }
}
