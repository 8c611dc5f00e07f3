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

    /**
     * The elements after a change of velocity by ([vx], [vy], [vz]) at the present place. ν must be > 0. The vertical
     * phase is such that no digit is lost when a quarter turn is added and taken off, as it is for a node.
     */
    public fun kicked(vx: Double, vy: Double, vz: Double, frequencies: OrbitalFrequencies): Epicycle {
        val square = frequencies.radialFactor * frequencies.radialFactor
        val outwards = 2 * vy / (frequencies.omega * square)
        val cosine = e * StrictMath.cos(phase) + outwards
        val sine = e * StrictMath.sin(phase) + vx / frequencies.kappa
        val z = i * StrictMath.cos(verticalPhase)
        val w = i * StrictMath.sin(verticalPhase) - vz / frequencies.nu
        return Epicycle(
            guidingX + outwards,
            guidingY - 2 * vx / (frequencies.omega * square),
            sqrt(cosine * cosine + sine * sine),
            StrictMath.atan2(sine, cosine),
            sqrt(z * z + w * w),
            if (z == 0.0 && w == 0.0) 0.0 else StrictMath.atan2(w, z) + QUARTER - QUARTER,
        )
    }

    /** Hill's energy over mass, (length/time)²: kinetic, tidal and centrifugal; constant on the free path. */
    public fun energy(frequencies: OrbitalFrequencies): Double {
        val swing = frequencies.kappa * e
        val vertical = frequencies.nu * i
        val drift = frequencies.omega * frequencies.radialFactor * guidingX
        // −(2Ω² − κ²/2) X² + (2Ω − κ²/2Ω)² X²/2 of the circle.
        return 0.5 * (swing * swing + vertical * vertical) - 0.25 * frequencies.shearFactor * drift * drift
    }

    /** The [ELEMENTS] numbers of it, in the order of the constructor. */
    internal fun elements() = doubleArrayOf(guidingX, guidingY, e, phase, i, verticalPhase)

    /** Around a point mass, in a frame of angular speed [omega]; or with another [verticalFactor]. */
    @JvmOverloads
    public fun after(time: Double, omega: Double, verticalFactor: Double = 1.0): Epicycle =
        after(time, OrbitalFrequencies(omega, verticalFactor = verticalFactor))

    public companion object {
        /** How many numbers an epicycle is. */
        internal const val ELEMENTS = 6
        private const val QUARTER = Math.PI / 2

        /** What [elements] has given, and maybe more numbers behind it. */
        internal fun ofElements(of: DoubleArray) = Epicycle(of[0], of[1], of[2], of[3], of[4], of[5])

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
