package daphnis.analysis.insitu

import daphnis.core.population.Population
import daphnis.core.search.NearPairs
import daphnis.core.search.SearchStructure

/**
 * The pairs of [state] that are near one another; if [inPlane], as if all spheres lay at one height. So a search in the
 * plane does not have to reach as far as the box, or a single sphere, is high.
 */
internal fun nearPairs(state: State, inPlane: Boolean): NearPairs {
    val p = if (inPlane) flat(state.population) else state.population
    return NearPairs(p, state.boundary, state.time, structure = SearchStructure.GRID)
}

/** The spheres of [p] all at the height of the first, in the same order. */
private fun flat(p: Population): Population = if (p.size == 0) {
    p
} else {
    Population(p.x, p.y, DoubleArray(p.size) { p.z[0] }, p.vx, p.vy, p.vz, p.radius, p.mass, p.id)
}
