package daphnis.core.hill

import kotlin.math.sqrt

/**
 * The epicyclic elements of a particle in Hill's frame (x radially outward, y along the orbit, z vertical), and the
 * conversion between them and position and velocity:
 *
 * ```
 *   x = X − e cos φ      y = Y + 2 e sin φ      z = i cos ζ
 *   X = 4x + 2 v_y/Ω     Y = y − 2 v_x/Ω        Ẋ = 0, Ẏ = −(3/2) Ω X, φ̇ = Ω, ζ̇ = Ω × vertical factor
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
    /** Position x y z and velocity v_x v_y v_z in a frame of angular speed [omega]. */
    @JvmOverloads
    public fun state(omega: Double, verticalFactor: Double = 1.0): DoubleArray {
        val s = StrictMath.sin(phase)
        val c = StrictMath.cos(phase)
        return doubleArrayOf(
            guidingX - e * c,
            guidingY + 2 * e * s,
            i * StrictMath.cos(verticalPhase),
            omega * (e * s),
            omega * (-1.5 * guidingX + 2 * e * c),
            -omega * verticalFactor * i * StrictMath.sin(verticalPhase),
        )
    }

    /** The elements after [time], on the free path. */
    @JvmOverloads
    public fun after(time: Double, omega: Double, verticalFactor: Double = 1.0): Epicycle = Epicycle(
        guidingX,
        guidingY - 1.5 * omega * guidingX * time,
        e,
        phase + omega * time,
        i,
        verticalPhase + omega * verticalFactor * time,
    )

    public companion object {
        /**
         * The elements of a particle at ([x], [y], [z]) with velocity ([vx], [vy], [vz]) in a frame of angular speed
         * [omega]. Allocates.
         */
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
        ): Epicycle {
            val gx = guidingX(x, vy, omega)
            val gy = guidingY(y, vx, omega)
            val cosine = gx - x
            val sine = vx / omega
            val w = vz / (omega * verticalFactor)
            return Epicycle(
                gx,
                gy,
                sqrt(cosine * cosine + sine * sine),
                StrictMath.atan2(sine, cosine),
                sqrt(z * z + w * w),
                StrictMath.atan2(-w, z),
            )
        }

        /** X = 4x + 2 v_y/Ω. */
        @JvmStatic
        public fun guidingX(x: Double, vy: Double, omega: Double): Double = 4 * x + 2 * vy / omega

        /** Y = y − 2 v_x/Ω. */
        @JvmStatic
        public fun guidingY(y: Double, vx: Double, omega: Double): Double = y - 2 * vx / omega
    }
}
