package daphnis.core.engine.horizon

import daphnis.core.population.SphereColumns

/** The first [size] of [spheres]. */
internal class FirstOf(spheres: SphereColumns, override val size: Int) : SphereColumns by spheres
