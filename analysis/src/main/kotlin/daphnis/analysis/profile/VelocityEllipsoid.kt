package daphnis.analysis.profile

import kotlin.math.atan2
import kotlin.math.sqrt

/**
 * Principal axes of a velocity dispersion tensor that is symmetric about the plane: two in the plane, one vertical.
 *
 * @property major larger dispersion in the plane, √⟨c₁²⟩; [minor] the smaller, [vertical] the one along z
 * @property orientation angle from the radial direction (x) to the major axis, in radians, counted toward y, in (−π/2,
 *   π/2]
 */
public class VelocityEllipsoid private constructor(
    public val major: Double,
    public val minor: Double,
    public val vertical: Double,
    public val orientation: Double,
) {
    /** √(major² + minor² + vertical²). */
    public val dispersion: Double get() = sqrt(major * major + minor * minor + vertical * vertical)

    public companion object {
        /** From ⟨c_x²⟩, ⟨c_y²⟩, ⟨c_z²⟩ and ⟨c_x c_y⟩. */
        @JvmStatic
        public fun of(xx: Double, yy: Double, zz: Double, xy: Double): VelocityEllipsoid {
            val mean = (xx + yy) / 2
            val half = sqrt((xx - yy) * (xx - yy) / 4 + xy * xy)
            return VelocityEllipsoid(
                sqrt(maxOf(0.0, mean + half)),
                sqrt(maxOf(0.0, mean - half)),
                sqrt(maxOf(0.0, zz)),
                0.5 * atan2(2 * xy, xx - yy),
            )
        }
    }
}
