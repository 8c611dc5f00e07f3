package daphnis.analysis.occultation

import kotlin.math.PI

/**
 * The direction of the light that comes through a patch.
 *
 * @property elevation B, angle between the rays and the ring plane in radians, in (0, π/2]
 * @property azimuth A, direction in the plane in which the rays climb, from x toward y, in radians
 */
public class LineOfSight @JvmOverloads constructor(public val elevation: Double, public val azimuth: Double = 0.0) {
    init {
        require(elevation > 0 && elevation <= PI / 2) { "elevation is $elevation; it must be in (0, π/2]" }
        require(azimuth.isFinite()) { "azimuth is $azimuth; it must be finite" }
    }

    public companion object {
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
