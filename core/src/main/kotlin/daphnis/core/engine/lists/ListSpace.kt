package daphnis.core.engine.lists

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.population.SphereColumns
import daphnis.core.search.StepBounds
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.max
import kotlin.math.sqrt

/**
 * The space in which lists are kept, since they were last built: the box, its division into cells, and all lengths that
 * follow from the sizes of the spheres.
 *
 * Along an axis without images the cells at the two ends go on for ever.
 */
internal class ListSpace {
    val isPeriodic = BooleanArray(AXES)
    val lower = DoubleArray(AXES)

    /** Distance of images along x, y, z; of no use along an axis without them. */
    val length = DoubleArray(AXES)

    /** How many cells there are, and how many in a unit of length. */
    val cells = IntArray(AXES)
    private val perLength = DoubleArray(AXES)

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

    val cellCount: Int get() = cells[0] * cells[1] * cells[2]

    /** Whether [boundary] is still the one for which the space was laid out. */
    fun isOf(boundary: BoundaryConditions): Boolean = accepts(boundary) &&
        (0 until AXES).all {
            isPeriodic[it] == boundary.hasImages(it) &&
                (!isPeriodic[it] || lower[it] == boundary.box.lower(it) && length[it] == boundary.box.length(it))
        }

    /**
     * Lays out the space for [spheres], with shells of [shellInRadii] of the largest.
     *
     * @return false when there cannot be lists
     */
    fun layOut(
        spheres: SphereColumns,
        boundary: BoundaryConditions,
        bounds: StepBounds,
        shellInRadii: Double,
    ): Boolean {
        largestRadius = bounds.largestRadius
        shell = largestRadius * shellInRadii
        reach = 2 * shell + largestRadius * REACH_SLACK
        if (!(bounds.leastRadius * MOST_RATIO >= largestRadius)) return false
        val widest = (2 * largestRadius + reach) * (1 + CELL_SLACK)
        var most = 0.0
        for (axis in 0 until AXES) {
            isPeriodic[axis] = boundary.hasImages(axis)
            var low = Double.POSITIVE_INFINITY
            var high = Double.NEGATIVE_INFINITY
            for (v in spheres.position(axis)) {
                if (v < low) low = v
                if (v > high) high = v
            }
            most = max(most, max(abs(low), abs(high)))
            lower[axis] = if (isPeriodic[axis]) boundary.box.lower(axis) else low
            length[axis] = if (isPeriodic[axis]) boundary.box.length(axis) else high - low
            if (isPeriodic[axis]) most = max(most, max(abs(lower[axis]), abs(lower[axis] + length[axis])))
            val fit = floor(length[axis] / widest)
            if (isPeriodic[axis] && !(fit >= LEAST_CELLS)) return false
            cells[axis] = fit.coerceIn(1.0, MOST_ALONG).toInt()
        }
        farthest = FARTHER * most + FARTHER_RADII * largestRadius
        margin = MARGIN * largestRadius + ROUNDING * farthest
        if (!(margin <= MOST_MARGIN * largestRadius)) return false
        thinOut(spheres.size)
        for (axis in 0 until AXES) perLength[axis] = cells[axis] / max(length[axis], widest)
        return true
    }

    /** Fewer cells than spheres, more or less: empty ones take memory. */
    private fun thinOut(spheres: Int) {
        while (cells[0].toLong() * cells[1] * cells[2] > CELLS_PER_SPHERE * spheres + FEW_CELLS) {
            val axis = (0 until AXES).maxBy { cells[it] }
            cells[axis] = cells[axis] / 2 + 1
        }
    }

    /** The cell along [axis] of the coordinate [at], which may be outside the box. */
    fun cell(at: Double, axis: Int): Int {
        val n = cells[axis]
        var c = (at - lower[axis]) * perLength[axis]
        if (isPeriodic[axis]) {
            if (c < 0 || c >= n) c -= floor(c / n) * n
        } else if (c < 0) {
            return 0
        }
        return if (c >= n) n - 1 else c.toInt()
    }

    companion object {
        const val AXES = 3

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

        /** Whether there can be lists: images that slide, and walls, are for others. */
        fun accepts(boundary: BoundaryConditions): Boolean = boundary.shear == null &&
            (0 until AXES).all { boundary.contactFaces(it) != ContactFaces.WALL }

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
