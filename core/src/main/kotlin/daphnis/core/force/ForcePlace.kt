package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.input.UnitsSpec
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.Population

/**
 * Where a force of a scenario acts: what the scenario says besides it.
 *
 * @property index in the scenario's list of forces
 * @property seed of the scenario
 * @property boundary with what the forces before it add
 * @property orbits in Hill's frame; null without a frame
 * @property planet GM of that frame's planet, length³/time²; null where it is not known
 * @property distance of the frame from the planet, a length; null where it is not known
 * @property bodies how many of the spheres are bodies, with the ids from [firstBody] on
 */
public class ForcePlace(
    public val index: Int,
    public val seed: Long,
    public val units: UnitsSpec,
    public val boundary: BoundaryConditions,
    public val orbits: OrbitalFrequencies?,
    public val planet: Double?,
    public val distance: Double?,
    public val bodies: Int,
    public val firstBody: Int,
    public val check: ValueCheck,
) {
    /** What messages call the force. */
    public val key: String = "forces[$index]"

    /** A seed of its own, which no other force of the run has, nor one of a run whose seed is near. */
    public val ownSeed: Long get() = seed + (index + 1) * APART

    /** Whether the sphere with [id] is a body. */
    public fun isBody(id: Int): Boolean = firstBody != Int.MAX_VALUE && id >= firstBody

    /** Indices of the spheres of [population] that are no bodies. */
    public fun particles(population: Population): List<Int> =
        (0 until population.size).filter { !isBody(population.id[it]) }

    /** G: that which is [given], or Newton's; checked. */
    public fun constant(given: Double?): Double {
        if (given != null) {
            check.that("$key.constant", given, given >= 0) { "must be at least 0" }
            return given
        }
        val constant = units.gravitationalConstant
            ?: check.fail("$key.constant", "is missing; give it, or units.lengthInMetres, from which it follows")
        check.must("units", constant.isFinite()) { "make Newton's constant $constant; it must be finite" }
        return constant
    }

    private companion object {
        /** Odd. */
        const val APART = -0x61c8864680b583ebL
    }
}
