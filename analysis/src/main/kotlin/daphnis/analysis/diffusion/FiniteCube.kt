package daphnis.analysis.diffusion

import kotlin.math.PI

/**
 * How much slower particles diffuse in a periodic cube than in an infinite gas at rest, because the flow around each
 * one meets its own images (Yeh & Hummer 2004, J. Phys. Chem. B 108, 15873; Dünweg & Kremer 1993, J. Chem. Phys. 99,
 * 6983).
 */
public object FiniteCube {
    /** Of a simple cubic lattice of images. */
    private const val LATTICE = 2.837297

    /**
     * What is to be added to D in a cube of edge [edge]: 2.837297 kT/(6π η L).
     *
     * @param thermal kT, the mass of a particle times ⟨c²⟩/3
     * @param viscosity shear viscosity η, mass/(length · time), such as that of [daphnis.analysis.theory.EnskogGas]
     */
    @JvmStatic
    public fun correction(thermal: Double, viscosity: Double, edge: Double): Double =
        LATTICE * thermal / (6 * PI * viscosity * edge)
}
