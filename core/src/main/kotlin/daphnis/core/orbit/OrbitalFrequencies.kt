package daphnis.core.orbit

import kotlin.math.sqrt

/**
 * The frequencies of nearly circular orbits in a frame that turns with angular speed Ω: κ, with which they swing
 * radially, and ν, with which they swing about the midplane. Around a point mass all three are the same. Around an
 * oblate planet κ < Ω < ν: apses advance, nodes go back.
 *
 * @property omega Ω in radians per unit of time, > 0
 * @property radialFactor κ/Ω, in (0, 2): at 0 orbits would be unstable, at 2 there would be no shear
 * @property verticalFactor ν/Ω, ≥ 0; larger than 1 also to mimic self-gravity (Wisdom & Tremaine 1988, AJ 95, 925, use
 *   3.6), 0 for no force towards the midplane
 */
public class OrbitalFrequencies @JvmOverloads constructor(
    public val omega: Double,
    public val radialFactor: Double = 1.0,
    public val verticalFactor: Double = 1.0,
) {
    init {
        require(omega > 0 && omega.isFinite()) { "angular speed is $omega; it must be > 0" }
        require(radialFactor > 0 && radialFactor < 2) { "radial factor is $radialFactor; it must be > 0 and < 2" }
        require(verticalFactor >= 0 && verticalFactor.isFinite()) {
            "vertical factor is $verticalFactor; it must be at least 0"
        }
    }

    /** κ, in radians per unit of time. */
    public val kappa: Double get() = omega * radialFactor

    /** ν, in radians per unit of time. */
    public val nu: Double get() = omega * verticalFactor

    /** −d ln Ω/d ln R = 2 − ½ (κ/Ω)²: 3/2 around a point mass. */
    public val shearFactor: Double get() = (4 - radialFactor * radialFactor) / 2

    /** −R dΩ/dR, by which circular orbits shear: their v_y is minus this times x. */
    public val shearRate: Double get() = shearFactor * omega

    /** Radial position of the guiding centre, X = (4x + 2 v_y/Ω) (Ω/κ)². */
    public fun guidingX(x: Double, vy: Double): Double = (4 * x + 2 * vy / omega) / (radialFactor * radialFactor)

    /** Azimuthal position of the guiding centre, Y = y − 2 v_x Ω/κ². */
    public fun guidingY(y: Double, vx: Double): Double = y - 2 * vx / (omega * (radialFactor * radialFactor))

    /**
     * Radial distance X − x from the guiding centre, e cos φ. Computed as such, since X − x loses digits far from the
     * middle of the frame.
     */
    public fun inwards(x: Double, vy: Double): Double =
        ((4 - radialFactor * radialFactor) * x + 2 * vy / omega) / (radialFactor * radialFactor)

    /** (G m/3 Ω²)^⅓ of a mass of [strength] G m, which is small against the planet's, length³/time². */
    public fun hillRadius(strength: Double): Double = Math.cbrt(strength / (3 * omega * omega))

    public companion object {
        /**
         * At a [distance] from the centre of a planet with zonal harmonics [j2], [j4], [j6] that refer to its [radius]
         * (Lissauer & Cuzzi 1982, AJ 87, 1051). ν² = 2 Ω² − κ², as outside of all mass.
         *
         * @param gravitationalParameter G times the mass, in length³/time²
         * @throws IllegalArgumentException when there is no stable circular orbit, Ω², κ² or ν² ≤ 0, or a number is not
         *   what it must be
         */
        @JvmStatic
        @JvmOverloads
        public fun around(
            gravitationalParameter: Double,
            distance: Double,
            radius: Double = 0.0,
            j2: Double = 0.0,
            j4: Double = 0.0,
            j6: Double = 0.0,
        ): OrbitalFrequencies {
            require(gravitationalParameter > 0 && distance > 0) {
                "G times the mass is $gravitationalParameter and the distance $distance; both must be > 0"
            }
            require(radius >= 0 && radius.isFinite()) { "the planet's radius is $radius; it must be at least 0" }
            val square = (radius / distance) * (radius / distance)
            val terms = doubleArrayOf(
                1.5 * j2 * square,
                -1.875 * j4 * square * square,
                2.1875 * j6 * square * square * square,
            )
            val orbital = 1 + terms.sum()
            // κ² = a⁻³ d(a⁴ Ω²)/da, term by term.
            val radial = 1 - terms[0] - 3 * terms[1] - 5 * terms[2]
            require(orbital > 0 && radial > 0 && 2 * orbital > radial) {
                "at ${distance / radius} radii of the planet there is no stable circular orbit: Ω², κ² and ν² are " +
                    "$orbital, $radial and ${2 * orbital - radial} times those of a point mass"
            }
            val omega = sqrt(gravitationalParameter / (distance * distance * distance) * orbital)
            return OrbitalFrequencies(omega, sqrt(radial / orbital), sqrt((2 * orbital - radial) / orbital))
        }
    }
}
