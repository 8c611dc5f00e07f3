package daphnis.core.engine.bricks

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.engine.bricks.Cuts.Companion.AXES
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns
import daphnis.core.search.GridExtent
import daphnis.core.step.CollisionStep
import daphnis.core.step.PreparedStep
import kotlin.math.abs

/**
 * Decides when space is divided anew, into how many bricks, and where: in the first steps, every [STEPS] steps after
 * that, and when the number of spheres has changed much, or the boundary.
 *
 * @param whole the step for all spheres
 * @param division what was asked for; null to choose what should be quickest on [threads] threads
 */
internal class TerritoryPlan(
    private val whole: PreparedStep,
    private val margins: HaloMargins,
    private val threads: Int,
    private val division: BrickDivision?,
) {
    /** The large ones among the spheres of the step. */
    val bodies = Bodies()

    /** Where the spheres of the step are. */
    val extent = GridExtent()

    /** The present territory; null when one brick is quickest. */
    var territory: Territory? = null
        private set
    private var boundary: BoundaryConditions? = null
    private var spheres = 0
    private var steps = 0
    private var due = 0
    private var interval = 1
    private var epoch = 0
    private var meanRadius = 0.0

    /** Whether [step] is to be taken serially, because one brick was found to be quickest not long ago. */
    fun rests(step: CollisionStep): Boolean {
        if (territory != null || boundary == null || isDue(step)) return false
        steps++
        return true
    }

    private fun isDue(step: CollisionStep): Boolean =
        steps >= due || boundary !== step.boundary || abs(step.population.size - spheres) > spheres / FEW

    /**
     * Looks at the step, which [whole] has measured, and decides on its [territory].
     *
     * @throws IllegalArgumentException when spheres are too far apart, see [GridExtent.requireComputable]
     */
    fun prepare(loop: RangeLoop) {
        val step = whole.step
        val population = step.population
        extent.measure(population, step.boundary, NOWHERE, loop)
        extent.requireComputable(whole.reach.largestRadius)
        val isDue = isDue(step)
        steps++
        if (isDue) meanRadius = meanRadius(population)
        bodies.find(population, whole.reach.largestRadius, meanRadius, loop)
        if (!isDue) return
        margins.diameter = 2 * meanRadius
        territory = choose(population, step.boundary)
        if (boundary !== step.boundary) interval = 1
        due = steps - 1 + interval
        interval = minOf(interval * MORE, STEPS)
        // Last, so that a plan that has failed is made anew.
        spheres = population.size
        boundary = step.boundary
    }

    private fun choose(population: SphereColumns, boundary: BoundaryConditions): Territory? {
        val places = CutPlaces(population, boundary)
        val division = division ?: cost(places, boundary).best()
        if (this.division == null && division.bricks == 1) return null
        val clearance = DoubleArray(AXES) { 2 * whole.reach.bound[it] + bodies.ordinary + 2 * margins.least }
        return Territory(places.choose(division, bodies, clearance), boundary, ++epoch)
    }

    private fun cost(places: CutPlaces, boundary: BoundaryConditions): BrickCost {
        val shares = DoubleArray(AXES) { axis ->
            val width = 2 * (whole.reach.bound[axis] + bodies.ordinary) + margins.least
            if (places.canCut(axis) && extent.size[axis] > 0) width / extent.size[axis] else 0.0
        }
        val periodic = BooleanArray(AXES) { boundary.hasImages(it) }
        return BrickCost(places.count, threads, margins.collisionsPerSphere, shares, periodic)
    }

    private fun meanRadius(spheres: SphereColumns): Double {
        var sum = 0.0
        for (k in 0 until spheres.size) sum += spheres.radius[k]
        return if (spheres.size == 0) 0.0 else sum / spheres.size
    }

    private companion object {
        val NOWHERE = DoubleArray(AXES) { Double.NaN }
        const val STEPS = 64
        const val MORE = 4

        /** When more than one of so many spheres was removed or added, space is divided anew. */
        const val FEW = 8
    }
}
