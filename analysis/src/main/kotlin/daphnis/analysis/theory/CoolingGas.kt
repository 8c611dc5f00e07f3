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
    public fun fourthCumulant(restitution: Double): Double {
        val e2 = restitution * restitution
        return 16 * (1 - restitution) * (1 - 2 * e2) / (81 - 17 * restitution + 30 * e2 * (1 - restitution))
    }

    /**
     * ζ = −d ln T/dt, per unit of time: (4/3) √π n σ² χ √T (1 − α²)(1 + 3a₂/16).
     *
     * @param temperature T = ⟨c²⟩/3
     */
    @JvmStatic
    public fun coolingRate(diameter: Double, restitution: Double, filling: Double, temperature: Double): Double =
        GranularCoefficients(restitution, filling).cooling * 96 / 5 * filling * sqrt(temperature / PI) / diameter

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
    ): Double = EnskogGas.first(diameter, mass, thermal) * GranularCoefficients(restitution, filling).viscosity

    /** Bulk viscosity, mass/(length · time). */
    @JvmStatic
    public fun bulkViscosity(
        diameter: Double,
        mass: Double,
        restitution: Double,
        filling: Double,
        thermal: Double,
    ): Double = EnskogGas.first(diameter, mass, thermal) * GranularCoefficients(restitution, filling).bulkViscosity

    /** Heat conductivity over Boltzmann's constant, 1/(length · time), see [EnskogGas.conductivity]. */
    @JvmStatic
    public fun conductivity(
        diameter: Double,
        mass: Double,
        restitution: Double,
        filling: Double,
        thermal: Double,
    ): Double = EnskogGas.first(diameter, mass, thermal) * 15 / (4 * mass) *
        GranularCoefficients(restitution, filling).conductivity

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
            GranularCoefficients(restitution, filling).densityConductivity
    }
}

/** Coefficients over those of the dilute elastic gas in first approximation, of Garzó & Dufty's section IV. */
private class GranularCoefficients(private val alpha: Double, private val filling: Double) {
    private val chi = HardSpheres.carnahanStarlingContact(filling)

    /** d ln χ/d ln φ. */
    private val steepness = 3 * filling / (1 - filling) - filling / (2 - filling)

    /** c* = 2 a₂. */
    private val c = 2 * CoolingGas.fourthCumulant(alpha)
    private val close = filling * chi * (1 + alpha)

    /** ζ over the rate n kT/η₀. */
    val cooling = 5.0 / 12 * chi * (1 - alpha * alpha) * (1 + 3 * c / 32)
    val bulkViscosity = 128 / (5 * PI) * filling * close * (1 - c / 32)
    val viscosity: Double
        get() {
            val relaxation = chi * (1 - (1 - alpha) * (1 - alpha) / 4) * (1 - c / 64)
            val carried = (1 - 0.4 * close * (1 - 3 * alpha)) / (relaxation - cooling / 2)
            return carried * (1 + 0.8 * close) + 0.6 * bulkViscosity
        }

    private val heatRelaxation = (1 + alpha) / 3 * chi * (1 + 33.0 / 16 * (1 - alpha) + (19 - 3 * alpha) / 1024 * c)
    private val carriedHeat = 2.0 / 3 * (1 + c + 0.6 * close * (1 + alpha) * (2 * alpha - 1 + c * (1 + alpha) / 2)) /
        (heatRelaxation - 2 * cooling)
    val conductivity = carriedHeat * (1 + 1.2 * close) + 256 / (25 * PI) * filling * close * (1 + 7 * c / 32)
    val densityConductivity: Double
        get() {
            // p* (1 + d ln p*/d ln φ), with p* = 1 + 2 (1 + α) φ χ.
            val pressure = 1 + 2 * close * (2 + steepness)
            val lost = alpha * (1 - alpha)
            val carried = (1 + steepness) * cooling * carriedHeat + pressure * c / 3 -
                0.8 * close * (1 + steepness / 2) * (lost + (4.0 / 3 + lost) * c / 4)
            return 2 * carried / (2 * heatRelaxation - 3 * cooling) * (1 + 1.2 * close)
        }
}
