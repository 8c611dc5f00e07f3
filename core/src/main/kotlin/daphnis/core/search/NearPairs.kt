package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population

/**
 * The pairs of a [population] that are near one another at one moment, through the faces too where contacts are found
 * through them. Allocates a grid. Any number of threads may search, each with its own [runs].
 *
 * @param structure whether sizes are kept apart, which finds fewer pairs that are not near
 */
public class NearPairs @JvmOverloads constructor(
    @PublishedApi internal val population: Population,
    boundary: BoundaryConditions,
    time: Double,
    loop: RangeLoop = InlineLoop,
    structure: SearchStructure = SearchStructure.AUTO,
) {
    /** The same for pairs up to [reach] times the sum of their radii apart. */
    internal constructor(population: Population, boundary: BoundaryConditions, time: Double, reach: Double) :
        this(population, boundary, time) {
        val swollen = SwollenSpheres().take(population, reach * WIDER)
        grid.build(swollen, boundary.at(time), time, 0.0, DoubleArray(AXES))
    }

    @PublishedApi
    internal val grid: Grid = Grid()

    init {
        grid.build(population, boundary.at(time), time, 0.0, DoubleArray(AXES), loop, structure)
    }

    /** The runs for one thread. */
    public fun runs(): CellRuns = CellRuns(grid)

    /** Index in the population of the sphere in [slot]; slots are numbered like spheres, in the order of the grid. */
    public fun index(slot: Int): Int = grid.order[slot]

    /**
     * Calls [action] for each pair of the sphere in [slot] with one that it would touch if its radius were [radius],
     * and for some pairs that are farther apart. Over all slots, each pair and image is given once. A sphere is not
     * paired with its own images.
     *
     * @param action takes the indices in the population of the sphere and of the other one, and the vector to the other
     *   one
     */
    @JvmSynthetic
    public inline fun forEach(
        runs: CellRuns,
        slot: Int,
        radius: Double,
        action: (first: Int, second: Int, dx: Double, dy: Double, dz: Double) -> Unit,
    ) {
        val order = grid.order
        val p = population
        val images = grid.images
        val k = order[slot]
        val count = runs.aheadAt(slot, p.x[k], p.y[k], p.z[k], radius)
        for (r in 0 until count) {
            val image = runs.image[r]
            val sx = images.shift(image, 0)
            val sy = images.shift(image, 1)
            val sz = images.shift(image, 2)
            for (other in runs.from[r] until runs.to[r]) {
                if (other == slot) continue
                val j = order[other]
                action(k, j, p.x[j] - p.x[k] + sx, p.y[j] - p.y[k] + sy, p.z[j] - p.z[k] + sz)
            }
        }
    }

    /** The same for Java, where it is called `forEach` too. */
    @JvmName("forEach")
    public fun each(runs: CellRuns, slot: Int, radius: Double, action: PairAction) {
        forEach(runs, slot, radius) { first, second, dx, dy, dz -> action.take(first, second, dx, dy, dz) }
    }

    private companion object {
        const val AXES = 3

        /** Room for rounding. */
        const val WIDER = 1 + 1e-9
    }
}

/** Takes a pair of spheres that are near each other. */
public fun interface PairAction {
    /** @param first index in the population, like [second]; the vector ([dx], [dy], [dz]) goes from it to the second */
    public fun take(first: Int, second: Int, dx: Double, dy: Double, dz: Double)
}
