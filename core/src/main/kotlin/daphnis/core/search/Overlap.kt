package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
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
        /** Looks at every pair of neighbours, through the faces too where contacts are found through them. Allocates a grid. */
        public fun deepest(population: Population, boundary: BoundaryConditions, time: Double): Overlap {
            val grid = Grid()
            grid.build(population, boundary, time, 0.0, DoubleArray(3))
            val near = CellRuns(grid)
            var first = -1
            var second = -1
            var depth = 0.0
            for (slot in 0 until population.size) {
                val k = grid.order[slot]
                val runs = near.ahead(slot, population.x[k], population.y[k], population.z[k], 0.0, 0.0, 0.0, population.radius[k])
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
    }
}
