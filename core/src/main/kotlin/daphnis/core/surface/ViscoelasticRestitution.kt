package daphnis.core.surface

import kotlin.math.sqrt

/**
 * Viscoelastic spheres: Hertz's force and a dissipative one that is proportional to the rate of the deformation,
 *
 * m_eff ξ″ = −ρ (ξ^(3/2) + (3/2) A √ξ ξ′), ρ ∝ √R_eff,
 *
 * until the force vanishes (Brilliantov et al. 1996, Phys. Rev. E 53, 5382; Ramírez et al. 1999, Phys. Rev. E 60, 4465;
 * Schwager & Pöschel 2008, Phys. Rev. E 78, 051304). ε is a function of s = (3/2) A (ρ/m_eff)^(2/5) v^(1/5) alone, here
 * as the Padé approximant of Müller & Pöschel 2011, Phys. Rev. E 84, 021302. It exceeds that of the equation by at most
 * 3e-4 where ε ≥ 0.8, by 0.003 where ε ≥ 0.5 and by 0.009 anywhere. ε → 1 as v → 0.
 *
 * Two spheres with [radius] and [mass] each that meet with [speed] have ε = [coefficient]; others of the same material
 * have the s that follows from their radii and masses. So large spheres of one density are more elastic: s ∝ R^-1.
 *
 * @property speed in cm/s
 * @property radius in units of length
 * @property mass in units of mass
 * @property cmPerSecond how many cm/s one unit of speed of the scenario is
 */
public class ViscoelasticRestitution @JvmOverloads constructor(
    public val coefficient: Double,
    public val speed: Double,
    public val radius: Double,
    public val mass: Double,
    public val cmPerSecond: Double = 1.0,
) : ContactLaw {
    init {
        require(coefficient > 0 && coefficient <= 1) {
            "coefficient of restitution is $coefficient; it must be in (0, 1]"
        }
        require(speed > 0 && speed.isFinite()) { "its speed is $speed cm/s; it must be > 0" }
        require(radius > 0 && radius.isFinite()) { "its radius is $radius; it must be > 0" }
        require(mass > 0 && mass.isFinite()) { "its mass is $mass; it must be > 0" }
        require(cmPerSecond > 0 && cmPerSecond.isFinite()) { "one unit of speed is $cmPerSecond cm/s; it must be > 0" }
    }

    /** s of the two spheres that [coefficient] is of. */
    private val reference = dissipation(coefficient)

    override val isRough: Boolean get() = false

    override fun restitution(contact: SurfaceContact): Double {
        val v = contact.normalSpeed * cmPerSecond / speed
        val size = 2 * contact.effectiveRadius / radius
        val inertia = 2 * contact.reducedMass / mass
        return 1.0 / (1.0 + loss(reference * StrictMath.pow(v * size / (inertia * inertia), FIFTH)))
    }

    private companion object {
        const val FIFTH = 0.2

        /** No impact has more; further powers of it would be infinite. */
        const val MOST = 1e60

        /** 1/ε − 1 as a function of s. */
        fun loss(dissipation: Double): Double {
            val s = minOf(dissipation, MOST)
            val root = sqrt(s)
            return s * (1.15345 + 0.577977 * root + 0.532178 * s) / (1.0 + 0.501086 * root)
        }

        /** The inverse of [loss] at 1/ε − 1. */
        fun dissipation(coefficient: Double): Double {
            val wanted = 1.0 / coefficient - 1.0
            var low = 0.0
            var high = 1.0
            while (high < MOST && loss(high) < wanted) high *= 2
            while (true) {
                val middle = (low + high) / 2
                if (middle <= low || middle >= high) return low
                if (loss(middle) < wanted) low = middle else high = middle
            }
        }
    }
}
