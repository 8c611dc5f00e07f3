package daphnis.analysis.theory

import kotlin.math.PI
import kotlin.math.sqrt

/**
 * A gas at rest of equal smooth elastic spheres by Enskog's theory, with the contact value of Carnahan & Starling (1969,
 * J. Chem. Phys. 51, 635).
 */
public object EnskogGas {
    /** Filling factor up to which the viscosity is within a tenth of that of simulations. */
    public const val MOST_FILLED: Double = 0.4

    /** η₀ of hard spheres over its first approximation (5/16) √(m kT/π)/σ². */
    private const val SONINE = 1.016

    /**
     * Shear viscosity η, mass/(length · time), of spheres of one [diameter] and [mass] at the filling factor [filling]
     * (Chapman & Cowling 1970, ch. 16.5): η₀ b (1/(bχ) + 4/5 + 0.7614 bχ), b = 4φ.
     *
     * @param thermal kT, the mass of a particle times ⟨c²⟩/3
     */
    @JvmStatic
    public fun viscosity(diameter: Double, mass: Double, filling: Double, thermal: Double): Double {
        val dilute = SONINE * 5.0 / 16 * sqrt(mass * thermal / PI) / (diameter * diameter)
        val void = 1 - filling
        val close = 4 * filling * (1 - filling / 2) / (void * void * void)
        return dilute * 4 * filling * (1 / close + 0.8 + 0.7614 * close)
    }
}
