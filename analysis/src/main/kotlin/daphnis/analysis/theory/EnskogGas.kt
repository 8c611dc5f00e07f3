package daphnis.analysis.theory

import kotlin.math.PI
import kotlin.math.sqrt

/**
 * A gas at rest of equal smooth elastic spheres by Enskog's theory (Chapman & Cowling 1970, ch. 16), with the contact
 * value χ of Carnahan & Starling (1969, J. Chem. Phys. 51, 635). Spheres have one `diameter` and `mass` and fill the
 * share `filling` of space; `thermal` is kT, the mass of a particle times ⟨c²⟩/3.
 *
 * Collisions that are correlated are left out (Alder, Gass & Wainwright 1970, J. Chem. Phys. 53, 3813): up to a filling
 * factor of 0.4 viscosities are within a tenth of those of simulations, and spheres diffuse up to a third faster.
 */
public object EnskogGas {
    /** Filling factor up to which what is said above holds: 0.4, and what whole numbers of spheres add to it. */
    public const val MOST_FILLED: Double = 0.4005

    // Values of a dilute gas over their first approximations.
    private const val SONINE = 1.016
    private const val SONINE_OF_HEAT = 1.02513
    private const val SONINE_OF_DIFFUSION = 1.01896

    /** Shear viscosity η, mass/(length · time): η₀ b (1/(bχ) + 4/5 + 0.7614 bχ), b = 4φ. */
    @JvmStatic
    public fun viscosity(diameter: Double, mass: Double, filling: Double, thermal: Double): Double {
        val dilute = SONINE * first(diameter, mass, thermal)
        val close = 4 * filling * HardSpheres.carnahanStarlingContact(filling)
        return dilute * 4 * filling * (1 / close + 0.8 + 0.7614 * close)
    }

    /** Bulk viscosity, mass/(length · time): (16/5π) b² χ times the first approximation of η₀. */
    @JvmStatic
    public fun bulkViscosity(diameter: Double, mass: Double, filling: Double, thermal: Double): Double {
        val contact = HardSpheres.carnahanStarlingContact(filling)
        return first(diameter, mass, thermal) * 16 / (5 * PI) * 16 * filling * filling * contact
    }

    /**
     * Heat conductivity λ over Boltzmann's constant, 1/(length · time): the heat flux is −λ/k times the gradient of
     * kT. λ₀ b (1/(bχ) + 6/5 + 0.7574 bχ), with λ₀ = 1.02513 · (15/4) k η₀/m.
     */
    @JvmStatic
    public fun conductivity(diameter: Double, mass: Double, filling: Double, thermal: Double): Double {
        val dilute = SONINE_OF_HEAT * 15.0 / 4 * first(diameter, mass, thermal) / mass
        val close = 4 * filling * HardSpheres.carnahanStarlingContact(filling)
        return dilute * 4 * filling * (1 / close + 1.2 + 0.7574 * close)
    }

    /** Self-diffusion D, length²/time: 1.01896 · (3/8) √(kT/(π m))/(n σ² χ). */
    @JvmStatic
    public fun diffusion(diameter: Double, mass: Double, filling: Double, thermal: Double): Double {
        val contact = HardSpheres.carnahanStarlingContact(filling)
        return SONINE_OF_DIFFUSION * PI / 16 * sqrt(thermal / (PI * mass)) * diameter / (filling * contact)
    }

    /** Collisions of a sphere in a unit of time: 4 √(π kT/m) n σ² χ. */
    @JvmStatic
    public fun collisionRate(diameter: Double, mass: Double, filling: Double, thermal: Double): Double {
        val contact = HardSpheres.carnahanStarlingContact(filling)
        return 24 * sqrt(thermal / (PI * mass)) * filling * contact / diameter
    }

    /** (5/16) √(m kT/π)/σ²: the first approximation of the viscosity of a dilute gas. */
    internal fun first(diameter: Double, mass: Double, thermal: Double): Double =
        5.0 / 16 * sqrt(mass * thermal / PI) / (diameter * diameter)
}
