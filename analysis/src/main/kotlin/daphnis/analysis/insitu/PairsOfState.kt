package daphnis.analysis.insitu

import daphnis.core.boundary.prepare
import daphnis.core.population.Population
import daphnis.core.search.NearPairs
import daphnis.core.search.SearchStructure
import daphnis.core.space.Images
import kotlin.math.abs
import kotlin.math.ceil

/**
 * Calls [action] for each pair of particles of [state] that are up to [reach] apart, and for some that are farther
 * apart; if [inPlane], as if all spheres lay at one height. So a search in the plane does not have to reach as far as
 * the box, or a single sphere, is high. Through the faces too, where contacts are found through them: in a box thinner
 * than twice the reach with each of several images. A particle is not paired with its own images.
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
 * [reach] apart, and of some that are farther apart; of discs in their plane. In a box thinner than the reach a particle
 * has images of others, and its own, as neighbours: each pair and image is given once, whatever the edges.
 *
 * @throws IllegalArgumentException for a reach of more than [MOST_EDGES] edges of a box with images
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
    val own = ownImages(state, reach)
    for (i in 0 until if (own.isEmpty()) 0 else state.population.size) {
        if (bodies && !state.isParticle(i)) continue
        for (v in own) action(i, i, v[0], v[1], v[2])
    }
}

/** The vectors up to [reach] long from a sphere to its own images, of each and its opposite one. */
internal fun ownImages(state: State, reach: Double): List<DoubleArray> {
    val images = Images().also { it.prepare(state.boundary, state.time) }
    val most = IntArray(3) { axis ->
        val edge = images.period(axis)
        require(edge == 0.0 || reach <= MOST_EDGES * edge) {
            "neighbours up to $reach away; along ${"xyz"[axis]} the box repeats every $edge"
        }
        // Along sliding faces an image may be a box nearer for each box across.
        if (edge == 0.0) 0 else (reach / edge).toInt()
    }
    if (images.normalAxis >= 0) {
        val across = images.normalAxis
        val slid = abs(images.shearOffset) / images.period(images.slideAxis)
        most[images.slideAxis] += ceil(most[across] * slid).toInt()
    }
    val all = ArrayList<DoubleArray>()
    for (x in 0..most[0]) {
        for (y in (if (x == 0) 0 else -most[1])..most[1]) {
            for (z in (if (x == 0 && y == 0) 1 else -most[2])..most[2]) {
                val code = Images.code(x, y, z)
                val v = DoubleArray(3) { images.shift(code, it) }
                if (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] <= reach * reach) all += v
            }
        }
    }
    return all
}

/** As far as images are sought, in edges of the box. */
private const val MOST_EDGES = 16
