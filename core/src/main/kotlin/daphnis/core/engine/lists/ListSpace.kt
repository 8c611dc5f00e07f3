package daphnis.core.engine.lists

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.population.SphereColumns
import daphnis.core.search.CellAxes
import daphnis.core.search.StepBounds
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.max
import kotlin.math.sqrt

/**
 * The space in which lists are kept, since they were last built: the box, its division into cells, and all lengths that
 * follow from the sizes of the spheres.
 */
internal class ListSpace : CellAxes() {
    var largestRadius = 0.0
        private set

    /** How far a sphere may go from where its list was made. */
    var shell = 0.0
        private set

    /** Surfaces with references nearer than this may touch. */
    var reach = 0.0
        private set

    /**
     * By how much spheres are taken to be larger where it is said when they cannot touch. It has ample room for the
     * rounding of positions, in as many steps as lists are kept.
     */
    var margin = 0.0
        private set

    /** Coordinates beyond this would need a larger [margin]. */
    var farthest = 0.0
        private set

    /** Velocities of images are no greater; 0 where these are at rest. */
    var fastestImage = 0.0
        private set

    /** Whether [boundary] is still the one for which the space was laid out, and images are at rest. */
    fun isOf(boundary: BoundaryConditions): Boolean = accepts(boundary) &&
        boundary.approach == 0.0 &&
        (0 until AXES).all {
            isPeriodic[it] == boundary.hasImages(it) &&
                (!isPeriodic[it] || low[it] == boundary.box.lower(it) && length[it] == boundary.box.length(it))
        }

    /**
     * Lays out the space for [spheres], with shells of [shellInRadii] of the largest. Where images approach, it is good
     * for one step of [duration].
     *
     * @return false when there cannot be lists
     */
    fun layOut(
        spheres: SphereColumns,
        boundary: BoundaryConditions,
        bounds: StepBounds,
        shellInRadii: Double,
        duration: Double,
    ): Boolean {
        largestRadius = bounds.largestRadius
        shell = largestRadius * shellInRadii
        reach = 2 * shell + largestRadius * REACH_SLACK + approached(boundary, duration)
        if (!(bounds.leastRadius * MOST_RATIO >= largestRadius)) return false
        val widest = (2 * largestRadius + reach) * (1 + CELL_SLACK)
        var most = 0.0
        for (axis in 0 until AXES) {
            isPeriodic[axis] = boundary.hasImages(axis)
            var lowest = Double.POSITIVE_INFINITY
            var highest = Double.NEGATIVE_INFINITY
            for (v in spheres.position(axis)) {
                if (v < lowest) lowest = v
                if (v > highest) highest = v
            }
            most = max(most, max(abs(lowest), abs(highest)))
            low[axis] = if (isPeriodic[axis]) boundary.box.lower(axis) else lowest
            length[axis] = if (isPeriodic[axis]) boundary.box.length(axis) else highest - lowest
            if (isPeriodic[axis]) most = max(most, max(abs(low[axis]), abs(low[axis] + length[axis])))
            val fit = floor(length[axis] / widest)
            if (isPeriodic[axis] && !(fit >= LEAST_CELLS)) return false
            count[axis] = fit.coerceIn(1.0, MOST_ALONG).toInt()
        }
        farthest = FARTHER * most + FARTHER_RADII * largestRadius
        margin = MARGIN * largestRadius + ROUNDING * farthest
        if (!(margin <= MOST_MARGIN * largestRadius)) return false
        // Fewer cells than spheres, more or less: empty ones take memory.
        thin(CELLS_PER_SPHERE * spheres.size + FEW_CELLS) { it / 2 + 1 }
        settle()
        return true
    }

    /** Whether a sphere is too far away at the coordinate [at] along [axis]. */
    fun isTooFar(at: Double, axis: Int): Boolean = !(abs(at) <= farthest) ||
        fastestImage > 0 &&
        isPeriodic[axis] &&
        !(abs(at - low[axis] - length[axis] / 2) <= NEARER * length[axis])

    /** By how much the distance between two spheres may be wrong if the second is taken to be at an image at rest. */
    private fun approached(boundary: BoundaryConditions, duration: Double): Double {
        var squares = 0.0
        for (axis in 0 until AXES) {
            if (boundary.hasImages(axis)) squares += boundary.box.length(axis) * boundary.box.length(axis)
        }
        fastestImage = if (boundary.approach == 0.0) 0.0 else MOST_AWAY * abs(boundary.approach) * sqrt(squares)
        return fastestImage * duration
    }

    companion object {
        /** The largest radius over the least. */
        const val MOST_RATIO = 3.0
        private const val LEAST_CELLS = 3
        private const val MOST_ALONG = 1024.0
        private const val CELLS_PER_SPHERE = 4L
        private const val FEW_CELLS = 64
        private const val CELL_SLACK = 1e-6

        /** In units of the largest radius. */
        private const val REACH_SLACK = 1e-5
        private const val MARGIN = 1e-9
        private const val MOST_MARGIN = 1e-7

        /** In units of the farthest coordinate: some thousand roundings. */
        private const val ROUNDING = 1e-12
        private const val FARTHER = 4.0
        private const val FARTHER_RADII = 64.0

        /**
         * How far from the middle of the box, in boxes, spheres may go where images approach: two are less than two and
         * a half boxes apart then, so that they are near at images no farther away than [MOST_AWAY].
         */
        private const val NEARER = 1.25
        private const val MOST_AWAY = 3.0

        /** Whether there can be lists: images that slide, and walls, are for others. */
        fun accepts(boundary: BoundaryConditions): Boolean = boundary.shear == null &&
            boundary.walls.isEmpty

        /** The part of the volume that [spheres] fill; along an axis without images, of that in which they are. */
        fun fillingFactor(spheres: SphereColumns, boundary: BoundaryConditions): Double {
            var filled = 0.0
            for (r in spheres.radius) filled += 4.0 / 3.0 * Math.PI * r * r * r
            var volume = 1.0
            for (axis in 0 until AXES) {
                volume *= if (boundary.hasImages(axis)) {
                    boundary.box.length(axis)
                } else {
                    spheres.position(axis).let { it.max() - it.min() } + 2 * spheres.radius[0]
                }
            }
            return filled / volume
        }

        /** The length of the vector of the fastest components. */
        fun fastest(bounds: StepBounds): Double {
            val v = bounds.fastest
            return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
        }
    }
}
