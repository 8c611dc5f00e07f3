package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.population.SphereColumns
import daphnis.core.space.Images
import kotlin.math.abs

/**
 * How a [Grid] divides space for one class of sizes: for the axis of rows (0), the middle axis (1) and the slow axis
 * (2), the number of cells, their width, and how far beside its path a sphere has to search for one of this class.
 * Arrays are indexed by these three; [axes] gives which of x, y, z each is.
 */
internal class GridLayout : CellAxes() {
    /** Radii of this class are no larger. */
    var largest = 0.0
        private set

    /** Numbers of the first cell and of the first row among those of all classes. */
    var firstCell = 0
    var firstRow = 0

    /** Numbers of cells and of rows in memory. */
    val cellCount: Int get() = cells[0] * cells[1] * cells[2]
    val rowCount: Int get() = cells[1] * cells[2]

    /**
     * x, y or z as the row axis, the middle axis, the slow axis. Rows lie along the axis along which images slide,
     * otherwise along x.
     */
    val axes = intArrayOf(0, 2, 1)

    /**
     * Numbers of cells in memory. Along a periodic axis of whose box only a part has cells in memory, these are the
     * cells from [first] on, counted round the box, of the [count] that the whole box would have. Elsewhere [first] is
     * 0 and [count] the same number.
     */
    val cells = IntArray(3)
    val first = IntArray(3)

    /**
     * Largest radius and reach of other spheres together, with room for rounding, and for images that approach; has to be
     * added to a sphere's path and radius.
     */
    val margin = DoubleArray(3)

    /** Whether images across the slow axis slide along the rows. */
    var slides = false
        private set

    /**
     * Least and most cells along a row by which the image row one box up the slow axis is displaced during the step.
     */
    var slideLow = 0.0
        private set
    var slideHigh = 0.0
        private set

    /** Whether rows flow along themselves, with neighbours that flow nearly as fast. */
    var haveFlow = false
        private set

    /** The part of [margin] that does not come from the reach of other spheres. */
    val ownMargin = DoubleArray(3)

    private val span = DoubleArray(3)
    private var spheres = 0

    /**
     * For [number] spheres with radii up to [largest], in the extent [space] of all spheres.
     */
    fun prepare(
        number: Int,
        largest: Double,
        boundary: BoundaryConditions,
        images: Images,
        duration: Double,
        reach: DoubleArray,
        space: GridExtent,
    ) {
        spheres = number
        this.largest = largest
        val shear = boundary.shear
        axes[0] = shear?.slideAxis ?: 0
        axes[2] = shear?.normalAxis ?: 1
        axes[1] = 3 - axes[0] - axes[2]
        for (k in 0..2) {
            low[k] = space.from[axes[k]]
            length[k] = space.size[axes[k]]
            span[k] = space.span[axes[k]]
            layOutAxis(k, boundary, images, reach[axes[k]], duration)
        }
        limitCells()
        settle()
        haveFlow = shear != null && candidates() >= RowBounds.WORTH_IN_FLOW && divideRowsOfFlow(images, duration)
        for (k in 0..2) keepPart(k, space.spanFrom[axes[k]])
        slides = shear != null
        if (slides) {
            val offset = images.shearOffset
            val moved = offset + images.shearVelocity * duration
            slideLow = minOf(offset, moved) * perLength[0] - SLACK
            slideHigh = maxOf(offset, moved) * perLength[0] + SLACK
        }
    }

    /**
     * Divides the axis of rows for what spheres of neighbouring rows can do relative to one another, where [RowBounds]
     * tell how fast each row is: in a wide sheared box all go far along it, but together.
     *
     * @return whether that makes much of a difference
     */
    private fun divideRowsOfFlow(images: Images, duration: Double): Boolean {
        val slid = abs(images.shearVelocity) * duration / length[2]
        val range = 2 * margin[2] * (1 + slid)
        if (range >= margin[0]) return false
        divide(0, range, ROW_CELLS_A_RANGE, MOST_CELLS_ALONG)
        limitCells()
        settle()
        return true
    }

    private fun layOutAxis(k: Int, boundary: BoundaryConditions, images: Images, reach: Double, duration: Double) {
        val axis = axes[k]
        isPeriodic[k] = boundary.hasImages(axis)
        margin[k] = (largest + reach) * (1 + SLACK) + ImageRange.rounding(low[k], low[k] + length[k])
        val approach = images.approachAlong(axis)
        if (isPeriodic[k] && approach != 0.0) {
            margin[k] = ImageRange.marginWithApproach(margin[k], length[k], approach * duration)
        }
        ownMargin[k] = margin[k] - reach
        // The largest distance that a pair can bridge.
        val range = 2 * margin[k]
        require(!isPeriodic[k] || range < length[k] * ImageRange.boxes(boundary, axis, duration)) {
            ImageRange.refusal(axis)
        }
        val perRange = if (k == 0) ROW_CELLS_A_RANGE else CELLS_A_RANGE
        if (range > 0) divide(k, range, perRange, MOST_CELLS_ALONG) else count[k] = 1
    }

    /** Keeps only the cells from that of [from] to that of [from] + [span] in memory, and one at either end. */
    private fun keepPart(k: Int, from: Double) {
        first[k] = 0
        cells[k] = count[k]
        if (span[k] == length[k]) return
        val least = cellToward(from, k) - 1
        val most = cellToward(from + span[k], k) + 1
        if (most - least >= count[k] - 1) return
        first[k] = Math.floorMod(least, count[k])
        cells[k] = most - least + 1
    }

    /** How many of the cells along axis [k] are kept in memory, at most. */
    private fun kept(k: Int): Double = if (span[k] == length[k]) {
        count[k].toDouble()
    } else {
        minOf(count[k].toDouble(), count[k] * (span[k] / length[k]) + ENDS)
    }

    /**
     * Spheres far away in an open box must not cost memory: there are never more than a few cells per sphere. Wider
     * cells are always right.
     */
    private fun limitCells() {
        val most = maxOf(MOST_CELLS_A_SPHERE * spheres.toDouble(), LEAST_CELLS)
        while (true) {
            val total = kept(0) * kept(1) * kept(2)
            if (total <= most) return
            val k = if (count[0] >= count[1] && count[0] >= count[2]) {
                0
            } else if (count[1] >= count[2]) {
                1
            } else {
                2
            }
            count[k] = maxOf(1, (count[k] * maxOf(most / total, 0.5)).toInt())
        }
    }

    /** About how many spheres are in the cells that are searched for one of them, if they are spread evenly. */
    fun candidates(): Double {
        var share = 1.0
        for (k in 0..2) if (span[k] > 0) share *= minOf(1.0, (2 * margin[k] + width[k]) / span[k])
        return spheres * share
    }

    /** Positions along axis [k] of the three. */
    fun coordinate(population: SphereColumns, k: Int): DoubleArray = when (axes[k]) {
        0 -> population.x
        1 -> population.y
        else -> population.z
    }

    /**
     * Where cell [c] along axis [k], counted on beyond the faces of a periodic axis, is among those in memory; [cells]
     * or more when it is not.
     */
    fun inMemory(c: Int, k: Int): Int {
        val place = c - first[k]
        val period = count[k]
        // Nearly always within a box of the first cell, and a division takes longer than all else here.
        return if (place >= 0) {
            if (place < period) place else place % period
        } else {
            if (place >= -period) place + period else Math.floorMod(place, period)
        }
    }

    /** The one of the numbers along x, y, z that belongs to axis [k] of the three. */
    fun pick(k: Int, x: Double, y: Double, z: Double): Double = when (axes[k]) {
        0 -> x
        1 -> y
        else -> z
    }

    companion object {
        /**
         * Cells in the length that a pair can bridge. Finer rows fit the path more closely; more rows cost more than
         * they save.
         */
        private const val ROW_CELLS_A_RANGE = 4.0
        private const val CELLS_A_RANGE = 1.0
        private const val MOST_CELLS_ALONG = 1e6
        private const val MOST_CELLS_A_SPHERE = 8
        private const val LEAST_CELLS = 64.0

        /** Cells at the ends of a part of a box. */
        private const val ENDS = 4.0

        private const val SLACK = ImageRange.SLACK
    }
}
