package daphnis.analysis.diffusion

import kotlin.math.PI

/**
 * How much slower particles diffuse in a periodic cube than in an infinite gas at rest, because the flow around each
 * one meets its own images (Yeh & Hummer 2004, J. Phys. Chem. B 108, 15873; Dünweg & Kremer 1993, J. Chem. Phys. 99,
 * 6983). There a particle stays while the flow spreads, as in a liquid. In a gas it goes away as fast as the flow does,
 * and the memory it has of it falls as (4π(D + ν)t)^{−3/2} (Ernst, Hauge & van Leeuwen 1970, Phys. Rev. Lett. 25,
 * 1254), so that η + ρD is in the place of η.
 */
public object FiniteCube {
    /** Of a simple cubic lattice of images. */
    private const val LATTICE = 2.837297

    /**
     * What is to be added to D in a cube of edge [edge]: 2.837297 kT/(6π (η + ρD) L).
     *
     * @param thermal kT, the mass of a particle times ⟨c²⟩/3
     * @param viscosity shear viscosity η, mass/(length · time), such as that of [daphnis.analysis.theory.EnskogGas]
     * @param density ρ, mass/length³
     * @param diffusion D as it is in the cube, length²/time
     */
    @JvmStatic
    public fun correction(
        thermal: Double,
        viscosity: Double,
        density: Double,
        diffusion: Double,
        edge: Double,
    ): Double = LATTICE * thermal / (6 * PI * (viscosity + density * diffusion) * edge)
}
