package daphnis.core.cluster.bricks

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.cluster.bricks.Cuts.Companion.AXES

/**
 * Which brick owns which part of space: a pure function of position and [cuts]. Bricks are numbered along x first, then
 * y, then z. Positions are those at the start of a step, in the box. Immutable, so any thread may ask.
 *
 * Space is not cut along an axis along which images slide. So the distance of a sphere from a territory does not change
 * by the slide, and a whole turn of the images is nothing special.
 *
 * @param epoch counts the territories of a run
 */
internal class Territory(val cuts: Cuts, boundary: BoundaryConditions, val epoch: Int) {
    private val counts = IntArray(AXES) { cuts.parts(it) }
    private val length = DoubleArray(AXES) { if (boundary.hasImages(it)) boundary.box.length(it) else 0.0 }
    private val lower = Array(AXES) { axis -> DoubleArray(counts[axis]) { cuts.lower(axis, it) } }
    private val upper = Array(AXES) { axis -> DoubleArray(counts[axis]) { upperEnd(axis, it) } }

    /** Number of bricks. */
    val size: Int = counts[0] * counts[1] * counts[2]

    init {
        val shear = boundary.shear
        require(shear == null || counts[shear.slideAxis] == 1) { "images slide along a cut axis" }
    }

    private fun upperEnd(axis: Int, part: Int): Double {
        if (part < counts[axis] - 1) return cuts.lower(axis, part + 1)
        if (length[axis] == 0.0 || counts[axis] == 1) return Double.POSITIVE_INFINITY
        return cuts.lower(axis, 0) + length[axis]
    }

    /** Length of the box along a periodic [axis]; 0 along others. */
    fun length(axis: Int): Double = length[axis]

    /** Number of parts along [axis]; 1 when it is not cut. */
    fun parts(axis: Int): Int = counts[axis]

    /** The brick of the parts [x], [y], [z] along the axes. */
    fun brick(x: Int, y: Int, z: Int): Int = (z * counts[1] + y) * counts[0] + x

    /** The part along [axis] in which [brick] lies. */
    fun part(axis: Int, brick: Int): Int = when (axis) {
        0 -> brick % counts[0]
        1 -> brick / counts[0] % counts[1]
        else -> brick / counts[0] / counts[1]
    }

    /** The owner of a sphere at ([x], [y], [z]). */
    fun ownerOf(x: Double, y: Double, z: Double): Int = brick(cuts.partOf(0, x), cuts.partOf(1, y), cuts.partOf(2, z))

    /** How far the position [x], or its nearest image, is from [part] along [axis]; 0 inside. */
    fun distance(axis: Int, part: Int, x: Double): Double {
        if (counts[axis] == 1) return 0.0
        val l = length[axis]
        val own = outside(axis, part, x)
        return if (l == 0.0) own else minOf(own, outside(axis, part, x + l), outside(axis, part, x - l))
    }

    private fun outside(axis: Int, part: Int, x: Double): Double =
        maxOf(0.0, lower[axis][part] - x, x - upper[axis][part])

    /** Lower end of [brick] along [axis]; −∞ where there is none. */
    fun lower(axis: Int, brick: Int): Double = lower[axis][part(axis, brick)]

    /** Upper end of [brick] along [axis], beyond the upper face where it goes on across it; +∞ where there is none. */
    fun upper(axis: Int, brick: Int): Double = upper[axis][part(axis, brick)]

    /** The middle of [brick] along each axis; NaN along those that are not cut or have no images. */
    fun middle(brick: Int): DoubleArray = DoubleArray(AXES) {
        val isPart = counts[it] > 1 && length[it] > 0
        if (isPart) (lower(it, brick) + upper(it, brick)) / 2 else Double.NaN
    }
}
