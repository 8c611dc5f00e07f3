package daphnis.analysis.theory

import kotlin.math.sqrt

/**
 * Stresses in uniform shear flow of a dilute gas of equal smooth spheres, or discs, in the steady state: Boltzmann's
 * equation in Grad's approximation, linear in the stress (Santos, Garzó & Dufty 2004, Phys. Rev. E 69, 061303). In
 * units of n kT over the viscosity of the elastic gas, the stress decays with the rate β + ζ = (3/4d)(1 + α)(1 − α +
 * 2d/3) and the energy with ζ = (d + 2)(1 − α²)/4d, as in [CoolingGas] (Garzó & Dufty 1999, Phys. Rev. E 59, 5895) with
 * Maxwellian velocities; the balance of P_xy, P_yy and the trace in a flow along x, varying along y, then leaves
 * P_yy = p β/(β + ζ) and the others. P_yy = P_zz is what this approximation has; terms of second order make P_yy less.
 *
 * All are over the pressure p, a third of the trace of P, of discs half of it. Of spheres of filling factor 0.01 they
 * are within 0.03 of runs with α from 0.8 on (docs/validation.md).
 *
 * @param restitution α, in (0, 1]
 * @param dimensions 3, or 2 for discs
 */
public class DiluteShear @JvmOverloads constructor(restitution: Double, dimensions: Int = 3) {
    init {
        require(restitution > 0 && restitution <= 1) { "the restitution is $restitution; it must be in (0, 1]" }
        require(dimensions == 2 || dimensions == 3) { "$dimensions dimensions; there must be 2 or 3" }
    }

    private val d = dimensions.toDouble()
    private val decay = 3 / (4 * d) * (1 + restitution) * (1 - restitution + 2 * d / 3)
    private val losses = (d + 2) / (4 * d) * (1 - restitution * restitution)

    /** P_xx/p, along the flow. */
    public val alongFlow: Double get() = 1 + (d - 1) * losses / decay

    /** P_yy/p, across it, and of spheres P_zz/p. */
    public val acrossFlow: Double get() = 1 - losses / decay

    /** |P_xy|/p. */
    public val shearStress: Double get() = sqrt(d / 2 * losses * (decay - losses)) / decay
}
