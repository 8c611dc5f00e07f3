package daphnis.core.swap

/**
 * How often spheres swap places, which equilibrates dense mixtures whose spheres hardly leave their cages: at the end
 * of a step two of all spheres are drawn, and if they differ and both have room where the other one is, they exchange
 * places (Ninarello, Berthier & Coslovich 2017, Phys. Rev. X 7, 021039; beside molecular dynamics Berthier, Flenner,
 * Fullerton, Scalliet & Singh 2019, J. Stat. Mech. 064004). Any two are drawn as often whatever the state is, so the
 * equilibrium of hard spheres stays as it is.
 *
 * A place keeps its position, id and count of boxes crossed, so displacements by id have no jumps; radius, mass, material,
 * velocity and spin go from one to the other. So no sum over the spheres changes, to the bit.
 *
 * Immutable.
 *
 * @property rate pairs drawn per sphere and unit of time, > 0; pairs of two that have radius, mass and material in common
 *   are among them, and nothing happens to them
 * @property seed with the time decides which are drawn
 * @throws IllegalArgumentException for a rate that is not positive and finite
 */
public class SwapRule @JvmOverloads constructor(public val rate: Double, public val seed: Long = 0) {
    init {
        require(rate > 0 && rate.isFinite()) { "spheres swap places at a rate of $rate; it must be > 0 and finite" }
    }
}
