package daphnis.core

import daphnis.core.force.EnergySums
import daphnis.core.population.SumParts

/** The population of a simulation whose spheres others hold. They take the sums over it; the spheres stay there. */
internal interface RemoteParts : SumParts {
    /** Potential energies of the state whose first moments were asked for last; valid until they are again. */
    val energies: EnergySums
}
