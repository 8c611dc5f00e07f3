package daphnis.core

import daphnis.core.force.EnergySums
import daphnis.core.population.MaterialSums
import daphnis.core.population.SpinSums
import daphnis.core.population.SumParts

/** The population of a simulation whose spheres others hold. They take the sums over it; the spheres stay there. */
internal interface RemoteParts : SumParts {
    /** Potential energies of the state whose first moments were asked for last; valid until they are again. */
    val energies: EnergySums

    /** Sums over spins of the same state, valid as long; those of no spheres where none spins. */
    val spins: SpinSums

    /** Sums by material of the state whose second moments were asked for last, valid until they are again. */
    val materials: MaterialSums

    /** Asks for [which] number, of the force at this place among those of the simulation if it is of one. */
    fun number(which: CommonNumber, force: Int): Double
}
