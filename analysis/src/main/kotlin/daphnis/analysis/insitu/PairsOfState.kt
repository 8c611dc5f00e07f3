package daphnis.analysis.insitu

import daphnis.core.population.Population
import daphnis.core.search.NearPairs
import daphnis.core.search.SearchStructure

/**
 * Calls [action] for each pair of particles of [state] that are up to [reach] apart, and for some that are farther
 * apart; if [inPlane], as if all spheres lay at one height. So a search in the plane does not have to reach as far as
 * the box, or a single sphere, is high. Through the faces too, where contacts are found through them.
 *
 * @param action takes the indices in the population and the squared distance
 * @return how many pairs of spheres were looked at: the work
 */
internal inline fun forEachPair(
    state: State,
    reach: Double,
    inPlane: Boolean,
    action: (first: Int, second: Int, square: Double) -> Unit,
): Long {
    val p = if (inPlane) flat(state.population) else state.population
    val pairs = NearPairs(p, state.boundary, state.time, structure = SearchStructure.GRID)
    val runs = pairs.runs()
    val bodies = state.firstBody != Int.MAX_VALUE
    var looked = 0L
    for (slot in 0 until p.size) {
        if (bodies && !state.isParticle(pairs.index(slot))) continue
        // A sphere of that size touches every sphere that is near enough.
        pairs.forEach(runs, slot, reach) { i, j, dx, dy, dz ->
            looked++
            if (!bodies || state.isParticle(j)) action(i, j, dx * dx + dy * dy + dz * dz)
        }
    }
    return looked
}

/** The spheres of [p] all at the height of the first, in the same order. */
private fun flat(p: Population): Population = if (p.size == 0) {
    p
} else {
    Population(p.x, p.y, DoubleArray(p.size) { p.z[0] }, p.vx, p.vy, p.vz, p.radius, p.mass, p.id)
}

/**
 * Calls [action] with the vector from the first to the second of each pair of particles of [state] that are up to
 * [reach] apart, and of some that are farther apart; of discs in their plane.
 */
internal inline fun forEachVector(
    state: State,
    reach: Double,
    action: (first: Int, second: Int, dx: Double, dy: Double, dz: Double) -> Unit,
) {
    val pairs = NearPairs(state.population, state.boundary, state.time, structure = SearchStructure.GRID)
    val runs = pairs.runs()
    val bodies = state.firstBody != Int.MAX_VALUE
    for (slot in 0 until state.population.size) {
        if (bodies && !state.isParticle(pairs.index(slot))) continue
        pairs.forEach(runs, slot, reach) { i, j, dx, dy, dz ->
            if (!bodies || state.isParticle(j)) action(i, j, dx, dy, dz)
        }
    }
}
