package daphnis.analysis.occultation

import kotlin.math.PI

/**
 * The direction of the light that comes through a patch.
 *
 * @property elevation B, angle between the rays and the ring plane in radians, in [[LOWEST] degrees, π/2]
 * @property azimuth A, direction in the plane in which the rays climb, from x toward y, in radians
 */
public class LineOfSight @JvmOverloads constructor(public val elevation: Double, public val azimuth: Double = 0.0) {
    init {
        requireElevation(elevation)
        require(azimuth.isFinite()) { "azimuth is $azimuth; it must be finite" }
    }

    public companion object {
        /**
         * The lowest elevation in degrees. There a shadow is 573 times as long as its sphere is wide; below, the time
         * that shadows take grows beyond bounds.
         */
        public const val LOWEST: Double = 0.1

        internal fun requireElevation(radians: Double) {
            require(radians >= Math.toRadians(LOWEST) && radians <= PI / 2) {
                "elevation is $radians; it must be in [${Math.toRadians(LOWEST)}, π/2], from $LOWEST degrees on"
            }
        }

        /** The unit vector (x, y, z) in the direction of [elevation] and [azimuth], the same bits on every machine. */
        internal fun direction(elevation: Double, azimuth: Double): DoubleArray {
            val flat = StrictMath.cos(elevation)
            return doubleArrayOf(
                flat * StrictMath.cos(azimuth),
                flat * StrictMath.sin(azimuth),
                StrictMath.sin(elevation),
            )
        }

        /** The same from angles in degrees; 90 is π/2 to the last bit. */
        @JvmStatic
        public fun degrees(elevation: Double, azimuth: Double): LineOfSight =
            LineOfSight(Math.toRadians(elevation), Math.toRadians(azimuth))

        /** All pairs of [elevations] and [azimuths] in degrees, the azimuths of the first elevation first. */
        @JvmStatic
        public fun grid(elevations: DoubleArray, azimuths: DoubleArray): List<LineOfSight> =
            elevations.flatMap { elevation -> azimuths.map { degrees(elevation, it) } }
    }
}
