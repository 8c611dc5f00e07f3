package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.parallel.Extremes
import daphnis.core.parallel.RangeLoop
import daphnis.core.parallel.forEachPiece
import daphnis.core.population.MeanFlow
import daphnis.core.population.SphereColumns
import daphnis.core.population.isFinite

/**
 * What has to be known of all spheres before a step: extremes, so those of parts of a population together are the same
 * in any order. Arrays are indexed by x, y, z.
 */
internal class StepBounds {
    /** Looks at spheres along with [measure]. */
    fun interface AlongPieces {
        /**
         * Looks at the spheres [from] until [to], on [worker].
         *
         * @return whether all their numbers are finite, as far as is known; others look for themselves after false
         */
        fun look(worker: Int, from: Int, to: Int): Boolean
    }

    private val speeds = List(AXES) { Extremes() }
    private val places = List(AXES) { Extremes() }
    private val radii = Extremes()
    private val againstFlow = Extremes()

    /** Greatest speed along each axis; 0 without spheres. */
    val fastest = DoubleArray(AXES)

    /** The greatest speed relative to the mean flow along it, where images slide in one; 0 without spheres. */
    var peculiar = 0.0
        private set

    /** Least and greatest position along each axis that was measured; +∞ and −∞ without spheres. */
    val lowest = DoubleArray(AXES)
    val highest = DoubleArray(AXES)

    /** Least radius; +∞ without spheres. */
    var leastRadius = Double.POSITIVE_INFINITY
        private set

    /** Largest radius; 0 without spheres. */
    var largestRadius = 0.0
        private set

    /** See [Reach]. */
    var headroom = 0.0

    val isEmpty: Boolean get() = leastRadius == Double.POSITIVE_INFINITY

    /** Whether all numbers of the spheres that were measured are finite. */
    @Volatile
    var areFinite = true
        private set

    /**
     * Measures [spheres], their positions along periodic axes only unless [everywhere]. All but positions along other
     * axes is meaningless unless [areFinite].
     *
     * @param along also called with each piece of some thousand spheres, which are in the cache afterwards
     */
    fun measure(
        spheres: SphereColumns,
        boundary: BoundaryConditions,
        everywhere: Boolean,
        loop: RangeLoop,
        along: AlongPieces? = null,
    ) {
        areFinite = true
        for (axis in 0 until AXES) {
            speeds[axis].clear()
            places[axis].clear()
        }
        radii.clear()
        againstFlow.clear()
        val flow = boundary.slidingFlow
        loop.runLight(spheres.size) { worker, from, to ->
            forEachPiece(from, to) { first, end ->
                val isFinite = along?.look(worker, first, end) == true || spheres.isFinite(first, end)
                if (!isFinite) areFinite = false
                for (axis in 0 until AXES) {
                    speeds[axis].include(spheres.velocity(axis), first, end)
                    if (everywhere || boundary.hasImages(axis)) places[axis].include(spheres.position(axis), first, end)
                }
                radii.include(spheres.radius, first, end)
                if (flow != null) {
                    val v = spheres.velocity(flow.flowAxis)
                    againstFlow.include(v, flow.rate, spheres.position(flow.normalAxis), first, end)
                }
            }
        }
        for (axis in 0 until AXES) {
            fastest[axis] = speeds[axis].magnitude
            lowest[axis] = places[axis].least
            highest[axis] = places[axis].greatest
        }
        peculiar = againstFlow.magnitude
        leastRadius = radii.least
        largestRadius = radii.magnitude
    }

    /** Everything as numbers of which the greatest count, for [take]. */
    fun numbers(): DoubleArray = fastest + DoubleArray(AXES) { -lowest[it] } + highest +
        doubleArrayOf(-leastRadius, largestRadius, headroom, peculiar)

    /** Takes over the [numbers] of all parts, of which the greatest were found. */
    fun take(numbers: DoubleArray) {
        for (axis in 0 until AXES) {
            fastest[axis] = numbers[axis]
            lowest[axis] = -numbers[AXES + axis]
            highest[axis] = numbers[2 * AXES + axis]
        }
        leastRadius = -numbers[3 * AXES]
        largestRadius = numbers[3 * AXES + 1]
        headroom = numbers[3 * AXES + 2]
        peculiar = numbers[3 * AXES + 3]
    }

    private companion object {
        const val AXES = 3
    }
}

/** The mean flow, where images slide in it. */
internal val BoundaryConditions.slidingFlow: MeanFlow? get() = if (shear == null) null else meanFlow
