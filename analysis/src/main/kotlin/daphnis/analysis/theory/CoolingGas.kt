package daphnis.analysis.theory

import kotlin.math.PI
import kotlin.math.sqrt

/**
 * A homogeneous gas of equal smooth spheres that collisions cool, by Enskog's equation in the first Sonine
 * approximation (Garzó & Dufty 1999, Phys. Rev. E 59, 5895), with the contact value χ of Carnahan & Starling. For one
 * coefficient of restitution α, in gases without clusters, and filling factors below 0.4 or so. For elastic spheres the
 * viscosity is 1.6 % below that of [EnskogGas] in the dilute limit, the conductivity 2.5 %.
 *
 * `thermal` is kT, the mass of a particle times ⟨c²⟩/3.
 */
public object CoolingGas {
    /** Least restitution at which conductivities of first approximation were seen to hold in the dilute gas. */
    public const val LEAST_RESTITUTION: Double = 0.7

    /** a₂ of the velocities of the state that cools, to first order (van Noije & Ernst 1998, Granular Matter 1, 57). */
    @JvmStatic
    public fun fourthCumulant(restitution: Double): Double = coolingCumulant(restitution, 3)

    /**
     * ζ = −d ln T/dt, per unit of time: (4/3) √π n σ² χ √T (1 − α²)(1 + 3a₂/16).
     *
     * @param temperature T = ⟨c²⟩/3
     */
    @JvmStatic
    public fun coolingRate(diameter: Double, restitution: Double, filling: Double, temperature: Double): Double =
        GranularCoefficients(restitution, filling, 3).cooling * 96 / 5 * filling * sqrt(temperature / PI) / diameter

    /** Haff's law (1983, J. Fluid Mech. 134, 401): T = [start]/(1 + [rate] t/2)² at [time] t, if ζ at 0 is [rate]. */
    @JvmStatic
    public fun temperature(start: Double, rate: Double, time: Double): Double {
        val s = 1 + rate * time / 2
        return start / (s * s)
    }

    /** Shear viscosity η, mass/(length · time). */
    @JvmStatic
    public fun viscosity(
        diameter: Double,
        mass: Double,
        restitution: Double,
        filling: Double,
        thermal: Double,
    ): Double = EnskogGas.first(diameter, mass, thermal) * GranularCoefficients(restitution, filling, 3).viscosity

    /** Bulk viscosity, mass/(length · time). */
    @JvmStatic
    public fun bulkViscosity(
        diameter: Double,
        mass: Double,
        restitution: Double,
        filling: Double,
        thermal: Double,
    ): Double = EnskogGas.first(diameter, mass, thermal) * GranularCoefficients(restitution, filling, 3).bulkViscosity

    /** Heat conductivity over Boltzmann's constant, 1/(length · time), see [EnskogGas.conductivity]. */
    @JvmStatic
    public fun conductivity(
        diameter: Double,
        mass: Double,
        restitution: Double,
        filling: Double,
        thermal: Double,
    ): Double = EnskogGas.first(diameter, mass, thermal) * 15 / (4 * mass) *
        GranularConduction(restitution, filling).conductivity

    /**
     * μ of the heat flux −μ ∇n that a gradient of the number density n drives, mass · length⁴/time³; 0 for elastic
     * spheres.
     */
    @JvmStatic
    public fun densityConductivity(
        diameter: Double,
        mass: Double,
        restitution: Double,
        filling: Double,
        thermal: Double,
    ): Double {
        val density = 6 * filling / (PI * diameter * diameter * diameter)
        return EnskogGas.first(diameter, mass, thermal) * 15 / (4 * mass) * thermal / density *
            GranularConduction(restitution, filling).densityConductivity
    }
}
