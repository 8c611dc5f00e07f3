package daphnis.analysis.report

import kotlin.math.hypot
import kotlin.math.sqrt

/**
 * Whether the velocity ellipsoid has a direction in the plane: whether ⟨c_x²⟩ and ⟨c_y²⟩ differ, or ⟨c_x c_y⟩ differs
 * from 0, by more than chance makes them. Of equal axes the direction of the longer one is noise, evenly spread over
 * all angles, and no error tells so.
 */
internal object AxesInPlane {
    /**
     * Errors that both numbers together must be away from 0. An error of a run is that of some dozen degrees of freedom,
     * ν: two of an isotropic gas are beyond d of them by a chance of (1 + d²/ν)^(−ν/2), 0.6 %.
     */
    private const val SIGNIFICANT = 4.0

    /** Whether [motion] of [particles] particles has a direction. */
    fun isSeen(motion: Motion, particles: Int): Boolean {
        val (xx, yy, xy) = listOf("xx", "yy", "xy").map { motion.moment(it) }
        // Where no error is known, that of one state: half the difference and the product of two Gaussian numbers of
        // variance T have the variance T².
        val one = (xx.mean + yy.mean) / 2 / sqrt(particles.toDouble())
        val ofDifference = if (xx.isLevelled && yy.isLevelled) hypot(xx.error, yy.error) / 2 else one
        val ofProduct = if (xy.isLevelled) xy.error else one
        return isSeen((xx.mean - yy.mean) / 2, ofDifference, xy.mean, ofProduct)
    }

    /** For half the difference of the squares and the mean product, each with its error. */
    fun isSeen(difference: Double, ofDifference: Double, product: Double, ofProduct: Double): Boolean =
        hypot(difference / ofDifference, product / ofProduct) > SIGNIFICANT
}
