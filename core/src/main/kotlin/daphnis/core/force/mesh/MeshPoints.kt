package daphnis.core.force.mesh

import kotlin.math.floor
import kotlin.math.sqrt

/**
 * Where the points of a mesh are. Along x and y they divide the box; along z there are as many planes as the spheres
 * need, [hz] apart.
 *
 * @property reach radius of the clouds
 * @property nx points along x
 * @property ny points along y
 * @property nz planes, an even number, since two of them are the parts of one complex plane;
 *   as many below the middle as above: plane j is at (j + ½ − nz/2) · hz
 */
internal data class MeshPoints(
    val nx: Int,
    val ny: Int,
    val nz: Int,
    val lx: Double,
    val ly: Double,
    val hz: Double,
    val reach: Double,
) {
    val hx: Double = lx / nx
    val hy: Double = ly / ny

    /** Points per length along x, y and z. */
    val perX: Double = nx / lx
    val perY: Double = ny / ly
    val perZ: Double = 1 / hz

    companion object {
        /** The radius of a cloud in spacings along x and y: error and number of pairs follow from it. */
        private const val RATIO = 3.5

        /** The same along z, where the error would be greatest. */
        private const val RATIO_Z = 4.0

        /** A cloud has at least so many softening lengths, so that the mesh need not know of it. */
        private const val SOFTENINGS = 32.0
        private const val MOST_PLANES = 96
        private const val FEWEST = 8
        private const val MOST = 3 * 4096

        /**
         * For [count] spheres between [lowest] and [highest] in a box [lx] by [ly]: about one point per sphere in a
         * plane, or points [spacing] apart where that is above 0.
         */
        fun choose(
            count: Int,
            lx: Double,
            ly: Double,
            lowest: Double,
            highest: Double,
            spacing: Double,
            softening: Double,
        ): MeshPoints {
            val height = maxOf(highest, -lowest)
            // Clouds have to be wide enough for the softening, and planes must not be too many.
            val least = maxOf(SOFTENINGS * softening, RATIO_Z * 2 * height / MOST_PLANES)
            val h = maxOf(if (spacing > 0) spacing else sqrt(lx * ly / count), least / RATIO)
            val nx = length(lx / h)
            val ny = length(ly / h)
            val reach = maxOf(RATIO * maxOf(lx / nx, ly / ny), least)
            val hz = reach / RATIO_Z
            // Four planes for each sphere: as far above the highest as below the lowest.
            return MeshPoints(nx, ny, 2 * floor(height / hz - 0.5).toInt() + 6, lx, ly, hz, reach)
        }

        private fun length(wanted: Double): Int =
            BatchTransform.lengthFrom(minOf(maxOf(wanted, FEWEST.toDouble()), MOST.toDouble()))
    }
}
