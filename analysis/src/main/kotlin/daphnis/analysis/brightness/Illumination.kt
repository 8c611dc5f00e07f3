package daphnis.analysis.brightness

import daphnis.analysis.occultation.LineOfSight
import java.math.BigDecimal
import java.math.RoundingMode
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Where a patch is lit from and seen from: parallel light from infinity, and a distant eye above the ring plane.
 *
 * @property eye rays climb along it toward the eye; its azimuth is the direction in the plane in which the eye stands
 * @property lightElevation B₀ of the light above the ring plane in radians, of size [LineOfSight.LOWEST] degrees to
 *   π/2; below 0 for light from below, when the eye sees the unlit face
 * @property phaseAngle α between the directions of light and eye in radians, of size [leastPhase] to [mostPhase]; the
 *   light stands from the eye toward larger azimuths, below 0 toward smaller ones
 */
public class Illumination(
    public val eye: LineOfSight,
    public val lightElevation: Double,
    public val phaseAngle: Double,
) {
    /** Azimuth of the direction in which the light stands, from x toward y, in radians. */
    public val lightAzimuth: Double

    /** Unit vector (x, y, z) toward the eye; [light] toward the light. Equal to the bit at the phase angle 0. */
    internal val toEye: DoubleArray
    internal val light: DoubleArray

    init {
        requireLight(lightElevation)
        val least = leastPhase(eye.elevation, lightElevation)
        val most = mostPhase(eye.elevation, lightElevation)
        require(abs(phaseAngle) >= least - ROUNDING && abs(phaseAngle) <= most + ROUNDING) {
            "phase angle is $phaseAngle; for these elevations its size must be in [$least, $most]"
        }
        lightAzimuth = if (phaseAngle < 0) eye.azimuth - beside(least) else eye.azimuth + beside(least)
        toEye = LineOfSight.direction(eye.elevation, eye.azimuth)
        light = LineOfSight.direction(lightElevation, lightAzimuth)
    }

    /**
     * How far the azimuths of light and eye are apart, Δ: sin²(Δ/2) cos B cos B₀ = sin²(α/2) −
     * sin²((B − B₀)/2), the law of cosines in the form that stays exact at small angles.
     */
    private fun beside(least: Double): Double {
        if (abs(abs(phaseAngle) - least) <= ROUNDING) return 0.0
        val half = StrictMath.sin(abs(phaseAngle) / 2)
        val apart = StrictMath.sin(least / 2)
        val square = (half - apart) * (half + apart) /
            (StrictMath.cos(eye.elevation) * StrictMath.cos(lightElevation))
        return 2 * StrictMath.asin(sqrt(square.coerceIn(0.0, 1.0)))
    }

    public companion object {
        /** From angles in degrees. */
        @JvmStatic
        public fun degrees(
            elevation: Double,
            azimuth: Double,
            lightElevation: Double,
            phaseAngle: Double,
        ): Illumination = Illumination(
            LineOfSight.degrees(elevation, azimuth),
            Math.toRadians(lightElevation),
            Math.toRadians(phaseAngle),
        )

        /** The smallest phase angle of an eye at [elevation] and light at [lightElevation]: both are at one azimuth. */
        @JvmStatic
        public fun leastPhase(elevation: Double, lightElevation: Double): Double = abs(elevation - lightElevation)

        /** The largest: the light is half a turn away. */
        @JvmStatic
        public fun mostPhase(elevation: Double, lightElevation: Double): Double = PI - abs(elevation + lightElevation)

        /**
         * What the phase angle of an eye at [elevation] and light at [lightElevation] must be, if [phaseAngle] cannot
         * be it, in words; null if it can. All in degrees.
         */
        @JvmStatic
        public fun problem(elevation: Double, lightElevation: Double, phaseAngle: Double): String? {
            val least = abs(elevation - lightElevation)
            val most = 2 * RIGHT - abs(elevation + lightElevation)
            if (abs(phaseAngle) >= least - SLACK && abs(phaseAngle) <= most + SLACK) return null
            fun said(degrees: Double) =
                BigDecimal(degrees).setScale(DIGITS, RoundingMode.HALF_EVEN).stripTrailingZeros().toPlainString()
            val apart = "with the eye at ${said(elevation)} and the light at ${said(lightElevation)}"
            return "${said(least)} to ${said(most)} degrees in size $apart"
        }

        /** Whether light may stand at an elevation of so many [degrees]. */
        @JvmStatic
        public fun isElevation(degrees: Double): Boolean = abs(degrees) >= LineOfSight.LOWEST && abs(degrees) <= RIGHT

        /** What is right for it. */
        public const val ELEVATIONS: String = "in ${LineOfSight.LOWEST}..90 degrees, or as far below 0"

        internal fun requireLight(radians: Double) {
            val lowest = Math.toRadians(LineOfSight.LOWEST)
            require(abs(radians) in lowest..PI / 2) {
                "elevation of the light is $radians; its size must be in [$lowest, π/2]"
            }
        }

        /** Radians by which angles from degrees may miss a bound. */
        private const val ROUNDING = 1e-10
        private const val SLACK = 1e-9
        private const val RIGHT = 90.0
        private const val DIGITS = 6
    }
}
