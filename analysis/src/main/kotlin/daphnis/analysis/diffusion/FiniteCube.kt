package daphnis.analysis.diffusion

import kotlin.math.PI
import kotlin.math.sqrt

/**
 * How much slower particles diffuse in a periodic cube than in an infinite gas at rest, because the flow around each
 * one meets its own images (Yeh & Hummer 2004, J. Phys. Chem. B 108, 15873; Dünweg & Kremer 1993, J. Chem. Phys. 99,
 * 6983).
 */
public object FiniteCube {
    /** Of a simple cubic lattice of images. */
    private const val LATTICE = 2.837297

    /** η₀ of hard spheres over its first approximation (5/16) √(m kT/π)/σ². */
    private const val SONINE = 1.016

    /** Filling factor up to which Enskog's viscosity is within a tenth of that of simulations. */
    public const val MOST_FILLED: Double = 0.4

    /**
     * What is to be added to D in a cube of edge [edge]: 2.837297 kT/(6π η L).
     *
     * @param thermal kT, the mass of a particle times ⟨c²⟩/3
     * @param viscosity shear viscosity η, mass/(length · time)
     */
    @JvmStatic
    public fun correction(thermal: Double, viscosity: Double, edge: Double): Double =
        LATTICE * thermal / (6 * PI * viscosity * edge)

    /**
     * Shear viscosity of a gas of elastic spheres of one [diameter] and [mass] at the filling factor [filling], by
     * Enskog's theory with the contact value of Carnahan and Starling (Chapman & Cowling 1970, ch. 16.5):
     * η₀ b (1/(bχ) + 4/5 + 0.7614 bχ), b = 4φ.
     *
     * @param thermal kT, as above
     */
    @JvmStatic
    public fun enskogViscosity(diameter: Double, mass: Double, filling: Double, thermal: Double): Double {
        val dilute = SONINE * 5.0 / 16 * sqrt(mass * thermal / PI) / (diameter * diameter)
        val void = 1 - filling
        val close = 4 * filling * (1 - filling / 2) / (void * void * void)
        return dilute * 4 * filling * (1 / close + 0.8 + 0.7614 * close)
    }
}
