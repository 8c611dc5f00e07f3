package daphnis.core.hill

import daphnis.core.orbit.OrbitalFrequencies
import kotlin.math.sqrt

/**
 * The epicyclic elements of a particle in Hill's frame (x radially outward, y along the orbit, z vertical), and the
 * conversion between them and position and velocity:
 *
 * ```
 *   x = X − e cos φ             y = Y + 2 (Ω/κ) e sin φ      z = i cos ζ
 *   X = (4x + 2 v_y/Ω) (Ω/κ)²   Y = y − 2 v_x Ω/κ²           Ẋ = 0, Ẏ = −(2 − ½ (κ/Ω)²) Ω X, φ̇ = κ, ζ̇ = ν
 * ```
 *
 * [e] and [i] are amplitudes, in units of length: eccentricity and inclination times the semi-major axis. (Hénon &
 * Petit 1986, Celest. Mech. 38, 67; Hill 1878.) Functions are those of StrictMath, so that the same elements give the
 * same state on every machine.
 *
 * @property guidingX radial position of the guiding centre, X
 * @property guidingY azimuthal position of the guiding centre, Y
 * @property phase φ, radians; 0 when e is 0
 * @property verticalPhase ζ, radians
 */
public class Epicycle @JvmOverloads constructor(
    public val guidingX: Double,
    public val guidingY: Double,
    public val e: Double,
    public val phase: Double,
    public val i: Double = 0.0,
    public val verticalPhase: Double = 0.0,
) {
    /** Position x y z and velocity v_x v_y v_z among orbits of these [frequencies]. */
    public fun state(frequencies: OrbitalFrequencies): DoubleArray {
        val omega = frequencies.omega
        val s = StrictMath.sin(phase)
        val c = StrictMath.cos(phase)
        return doubleArrayOf(
            guidingX - e * c,
            guidingY + 2 / frequencies.radialFactor * e * s,
            i * StrictMath.cos(verticalPhase),
            frequencies.kappa * (e * s),
            omega * (-frequencies.shearFactor * guidingX + 2 * e * c),
            -omega * frequencies.verticalFactor * i * StrictMath.sin(verticalPhase),
        )
    }

    /** Around a point mass, in a frame of angular speed [omega]; or with another [verticalFactor]. */
    @JvmOverloads
    public fun state(omega: Double, verticalFactor: Double = 1.0): DoubleArray =
        state(OrbitalFrequencies(omega, verticalFactor = verticalFactor))

    /** The elements after [time], on the free path. */
    public fun after(time: Double, frequencies: OrbitalFrequencies): Epicycle = Epicycle(
        guidingX,
        guidingY - frequencies.shearRate * guidingX * time,
        e,
        phase + frequencies.kappa * time,
        i,
        verticalPhase + frequencies.nu * time,
    )

    /** The same orbit on a circle of this [circumference], which y is along: Y is at most half of it from 0. */
    public fun onCircle(circumference: Double): Epicycle =
        Epicycle(guidingX, guidingY - circumference * Math.rint(guidingY / circumference), e, phase, i, verticalPhase)

    /** Around a point mass, in a frame of angular speed [omega]; or with another [verticalFactor]. */
    @JvmOverloads
    public fun after(time: Double, omega: Double, verticalFactor: Double = 1.0): Epicycle =
        after(time, OrbitalFrequencies(omega, verticalFactor = verticalFactor))

    public companion object {
        /**
         * The elements of a particle at ([x], [y], [z]) with velocity ([vx], [vy], [vz]) among orbits of these
         * [frequencies]. Allocates.
         */
        @JvmStatic
        public fun of(
            x: Double,
            y: Double,
            z: Double,
            vx: Double,
            vy: Double,
            vz: Double,
            frequencies: OrbitalFrequencies,
        ): Epicycle {
            val gx = frequencies.guidingX(x, vy)
            val gy = frequencies.guidingY(y, vx)
            val cosine = gx - x
            val sine = vx / frequencies.kappa
            val w = vz / frequencies.nu
            return Epicycle(
                gx,
                gy,
                sqrt(cosine * cosine + sine * sine),
                StrictMath.atan2(sine, cosine),
                sqrt(z * z + w * w),
                StrictMath.atan2(-w, z),
            )
        }

        /** Around a point mass, in a frame of angular speed [omega]; or with another [verticalFactor]. */
        @JvmStatic
        @JvmOverloads
        public fun of(
            x: Double,
            y: Double,
            z: Double,
            vx: Double,
            vy: Double,
            vz: Double,
            omega: Double,
            verticalFactor: Double = 1.0,
        ): Epicycle = of(x, y, z, vx, vy, vz, OrbitalFrequencies(omega, verticalFactor = verticalFactor))

        /** X = 4x + 2 v_y/Ω, around a point mass. */
        @JvmStatic
        public fun guidingX(x: Double, vy: Double, omega: Double): Double = OrbitalFrequencies(omega).guidingX(x, vy)

        /** Y = y − 2 v_x/Ω, around a point mass. */
        @JvmStatic
        public fun guidingY(y: Double, vx: Double, omega: Double): Double = OrbitalFrequencies(omega).guidingY(y, vx)
    }
}
