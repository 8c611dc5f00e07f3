package daphnis.analysis.theory

import daphnis.core.space.Space
import kotlin.math.PI
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * Where a gas of equal smooth inelastic spheres or discs that cools by itself is unstable: the velocity of a shear mode
 * decays by viscosity at the rate η k²/ρ, thermal speeds fall at ζ/2. So modes with k below k_c = √(ζρ/2η) grow beside
 * the thermal speed, and vortices form in a box longer than L_c = 2π/k_c; below that they cannot. ζ and η are those of
 * Enskog's equation to first order (Garzó & Dufty 1999, Phys. Rev. E 59, 5895; Garzó 2005, Phys. Rev. E 72, 021106; in
 * d dimensions Lutsko 2005, Phys. Rev. E 72, 021306), with the contact value of Carnahan & Starling, for discs that of
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
        val gas = GranularCoefficients(restitution, filling, d)
        return 2 * PI * dilute / (number * sqrt(gas.cooling / (2 * gas.viscosity)))
    }
}
