package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.space.Images

/**
 * How far gravity reaches where the box repeats: around each particle, by the distance ρ along the periodic axes alone
 * (a cylinder in a flat sheet, a sphere in a box that repeats along x, y and z), so that every particle sees the same
 * sheet around itself. Nothing is cut along axes that do not repeat.
 *
 * ```
 *   weight of a pair   1 ──────╮              w = t² (3 − 2t),  t = (range² − ρ²) / (range² − inner²)
 *                               ╲
 *                      0         ╰────▶ ρ
 *                         0  inner  range
 * ```
 *
 * The weight is the same from either side of a pair, so momentum is conserved. It fades, so that a node of the tree
 * near the cut, weighted by the place of its centre of mass, is not in or out as a whole.
 *
 * @param images the range is ([images] + ½) of the shortest periodic edge: the circle that fits into 2·[images] + 1
 *   boxes
 */
internal class GravityCut(private val boundary: BoundaryConditions, images: Int) {
    private val periodic = BooleanArray(3) { boundary.hasImages(it) }

    /** Whether anything repeats, and with it whether anything is cut. */
    val isPresent: Boolean = periodic.any { it }

    /** Where gravity ends; infinite when nothing repeats. */
    val range: Double =
        (0..2).filter { periodic[it] }.minOfOrNull { boundary.box.length(it) }?.let { it * (images + 0.5) }
            ?: Double.POSITIVE_INFINITY

    /** Where it begins to fade. */
    val inner: Double = range * INNER_PART

    /** The largest node that may be taken as one mass where gravity fades. */
    val largestNode: Double = if (isPresent) (range - inner) / NODES_ACROSS else Double.POSITIVE_INFINITY

    private val boxes = IntArray(3) { if (periodic[it]) farthest(it) else 0 }
    private val center = IntArray(3)

    /**
     * Codes of the images that may hold a sphere in range of another one; those across sliding faces are as [choose]
     * found them.
     */
    val codes = IntArray(boxes.fold(1) { n, most -> n * (2 * most + 1) })

    /** 1 for an axis that contributes to the distance, else 0. */
    fun counts(axis: Int): Double = if (periodic[axis]) 1.0 else 0.0

    /**
     * How many boxes apart along [axis] two particles in range of one another can be; images that slide are displaced
     * by up to half an edge.
     */
    private fun farthest(axis: Int): Int {
        val off = if (boundary.shear?.slideAxis == axis) 1.5 else 1.0
        return Math.ceil(range / boundary.box.length(axis) + off).toInt() - 1
    }

    /**
     * Takes over the present places of the images; each row across sliding faces starts from the image nearest along
     * the slide.
     */
    fun choose(images: Images) {
        var n = 0
        for (x in -boxes[0]..boxes[0]) {
            for (y in -boxes[1]..boxes[1]) {
                for (z in -boxes[2]..boxes[2]) {
                    lookAcross(images, x, y, z)
                    codes[n++] = Images.code(x + center[0], y + center[1], z + center[2])
                }
            }
        }
    }

    private fun lookAcross(images: Images, x: Int, y: Int, z: Int) {
        val shear = boundary.shear ?: return
        val across = if (shear.normalAxis == 0) {
            x
        } else if (shear.normalAxis == 1) {
            y
        } else {
            z
        }
        center[shear.slideAxis] = -Math.rint(across * images.shearOffset / boundary.box.length(shear.slideAxis)).toInt()
    }

    private companion object {
        const val INNER_PART = 0.5
        const val NODES_ACROSS = 2
    }
}
