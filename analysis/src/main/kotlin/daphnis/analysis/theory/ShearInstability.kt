package daphnis.analysis.theory

import daphnis.core.space.Space
import kotlin.math.PI
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * Where a gas of equal smooth inelastic spheres or discs that cools by itself is unstable: the velocity of a shear mode
 * decays by viscosity at the rate η k²/ρ, thermal speeds fall at ζ/2. So modes with k below k_c = √(ζρ/2η) grow beside
 * the thermal speed, and vortices form in a box longer than L_c = 2π/k_c; below that they cannot. ζ and η are those of
 * Enskog's equation to first order (Garzó & Dufty 1999, Phys. Rev. E 59, 5895; Garzó 2005, Phys. Rev. E 72, 021106; in d
 * dimensions Lutsko 2005, Phys. Rev. E 72, 021306), with the contact value of Carnahan & Starling, for discs that of
 * Henderson. For coefficients of restitution from 0.6 and filling factors up to 0.4, of discs 0.5.
 */
public object ShearInstability {
    /** Least coefficient of restitution, and largest filling factor for which numbers are given. */
    public const val LEAST_RESTITUTION: Double = 0.6
    public const val MOST_FILLED: Double = 0.4

    /**
     * L_c over the diameter; infinite for elastic ones.
     *
     * @param restitution ε of all impacts
     * @param filling filling factor, of discs area fraction
     */
    @JvmStatic
    public fun criticalLength(restitution: Double, filling: Double, space: Space): Double {
        require(restitution > 0 && restitution <= 1) { "the coefficient of restitution is $restitution" }
        require(filling > 0 && filling < 1) { "the filling factor is $filling" }
        val d = space.dimensions
        val number = filling / space.volume(0.5)
        // η₀ σ^{d−1}/√(mT), and n η₀ of the frequency nT/η₀.
        val half = if (d == 2) 1.0 else sqrt(PI) / 2
        val dilute = (d + 2) / 8.0 * half * PI.pow(-(d - 1) / 2.0)
        val ratio = coolingRate(restitution, filling, d) / (2 * viscosity(restitution, filling, d))
        return 2 * PI * dilute / (number * sqrt(ratio))
    }

    /** ζ in units of nT/η₀. */
    private fun coolingRate(e: Double, filling: Double, d: Int) =
        (d + 2) / (4.0 * d) * contact(filling, d) * (1 - e * e) * (1 + 3.0 / 32 * excess(e, d))

    /** η in units of η₀, that of a dilute elastic gas. */
    private fun viscosity(e: Double, filling: Double, d: Int): Double {
        val close = filling * contact(filling, d)
        val c = excess(e, d)
        val frequency = 3.0 / (4 * d) * contact(filling, d) * (1 - e + 2.0 / 3 * d) * (1 + e) * (1 - c / 64)
        val two = 2.0.pow(d - 2)
        val carried = (1 - two / (d + 2) * (1 + e) * (1 - 3 * e) * close) / (frequency - coolingRate(e, filling, d) / 2)
        val bulk = (if (d == 2) 8 / PI else 128 / (5 * PI)) * filling * close * (1 + e) * (1 - c / 32)
        return carried * (1 + 2 * two / (d + 2) * close * (1 + e)) + d / (d + 2.0) * bulk
    }

    /** Twice a₂ of the velocities. */
    private fun excess(e: Double, d: Int) =
        32 * (1 - e) * (1 - 2 * e * e) / (9 + 24 * d - e * (41 - 8 * d) + 30 * (1 - e) * e * e)

    private fun contact(filling: Double, d: Int): Double {
        val void = 1 - filling
        return if (d == 2) (1 - 7 * filling / 16) / (void * void) else (1 - filling / 2) / (void * void * void)
    }
}
