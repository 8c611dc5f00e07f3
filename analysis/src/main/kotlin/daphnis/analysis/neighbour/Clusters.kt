package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import daphnis.analysis.insitu.forEachVector
import daphnis.analysis.insitu.ownImages
import daphnis.core.population.Population
import daphnis.core.search.NearPairs

/**
 * Clusters of spheres: sets in which each is linked to another, also through faces and by images that slide. Found by
 * union and find (Tarjan 1975, J. ACM 22, 215) that keeps where each sphere is relative to its cluster's root, so
 * that a cluster which meets an image of itself is seen. A sphere that is linked to none is a cluster of one.
 *
 * @property label number of the cluster of each sphere, by index in the population; clusters are numbered from the
 *   largest down, of equal ones that with the lowest index first; −1 for what is in none
 * @property sizes numbers of members by cluster, descending
 * @property spans whether a cluster is connected with its own images along x, y and z: it has no end there
 * @property isSpanning whether this holds of a cluster along any axis, by cluster
 */
public class Clusters internal constructor(
    public val label: IntArray,
    public val sizes: IntArray,
    public val spans: List<Boolean>,
    public val isSpanning: BooleanArray,
    private val places: Array<DoubleArray>,
) {
    /** Spheres in clusters. */
    public val particles: Int get() = sizes.sum()

    /**
     * Component along [axis], 0 to 2, of the vector from one member of its cluster, the same for all members, to the
     * sphere at [index], by way of links: through faces, too. A length; of a cluster that [isSpanning] to one of the
     * images of the sphere. 0 for what is in no cluster.
     */
    public fun place(index: Int, axis: Int): Double = places[axis][index]

    /** Σ s²/Σ s: the size of the cluster of a sphere, on average; 0 without spheres. */
    public val meanSize: Double
        get() = if (sizes.isEmpty()) 0.0 else sizes.sumOf { it.toDouble() * it } / particles

    public companion object {
        /**
         * Of all spheres of [state], bodies too, that are as near each other as the [criterion] says.
         *
         * @throws IllegalArgumentException for a criterion that reaches farther than 16 edges of a box with images, or
         *   a place that is not finite
         */
        @JvmStatic
        public fun of(state: State, criterion: ClusterCriterion): Clusters {
            val p = state.population
            val ratios = criterion.table(p)
            val swollen = swollen(p, criterion.reach * WIDER)
            val pairs = NearPairs(swollen, state.boundary, state.time)
            val runs = pairs.runs()
            val trees = ClusterTrees(state) { true }
            for (slot in 0 until p.size) {
                pairs.forEach(runs, slot, swollen.radius[pairs.index(slot)]) { i, j, dx, dy, dz ->
                    val reach = ratios.of(i, j) * (p.radius[i] + p.radius[j])
                    if (dx * dx + dy * dy + dz * dz <= reach * reach) trees.join(i, j, dx, dy, dz)
                }
            }
            val largest = (0 until p.size).maxOfOrNull { p.radius[it] } ?: 0.0
            val own = ownImages(state, criterion.reach * 2 * largest)
            for (i in 0 until if (own.isEmpty()) 0 else p.size) {
                val reach = ratios.of(i, i) * 2 * p.radius[i]
                for (v in own) {
                    if (v[0] * v[0] + v[1] * v[1] + v[2] * v[2] <= reach * reach) trees.join(i, i, v[0], v[1], v[2])
                }
            }
            return trees.clusters()
        }

        /** [p] with radii larger by a [factor], which a search takes for contacts. */
        private fun swollen(p: Population, factor: Double): Population {
            val radius = DoubleArray(p.size) { p.radius[it] * factor }
            return Population(p.x, p.y, p.z, p.vx, p.vy, p.vz, radius, p.mass, p.id)
        }

        /** Room for rounding. */
        private const val WIDER = 1 + 1e-9

        /**
         * Of particles whose surfaces are up to [gap] apart, a length ≥ 0; bodies are in none.
         */
        @JvmStatic
        public fun byGap(state: State, gap: Double): Clusters {
            require(gap >= 0 && gap.isFinite()) { "surfaces up to $gap apart; it must be a length >= 0" }
            val p = state.population
            val largest = (0 until p.size).maxOfOrNull { if (state.isParticle(it)) p.radius[it] else 0.0 } ?: 0.0
            val reach = 2 * largest + gap
            val trees = ClusterTrees(state) { state.isParticle(it) }
            forEachVector(state, reach) { i, j, dx, dy, dz ->
                val contact = p.radius[i] + p.radius[j] + gap
                if (dx * dx + dy * dy + dz * dz <= contact * contact) trees.join(i, j, dx, dy, dz)
            }
            return trees.clusters()
        }

        /** Of the particles that are [members], by index, linked where one is on the list of the other. */
        @JvmStatic
        public fun ofNeighbours(state: State, lists: NeighbourLists, members: BooleanArray): Clusters {
            require(members.size == state.population.size && lists.size == members.size) {
                "${members.size} flags and neighbours of ${lists.size} for ${state.population.size} spheres"
            }
            val trees = ClusterTrees(state) { members[it] && state.isParticle(it) }
            for (i in members.indices) {
                if (!members[i]) continue
                for (k in 0 until lists.count(i)) {
                    val j = lists.neighbour(i, k)
                    if (!members[j]) continue
                    trees.join(i, j, lists.component(i, k, 0), lists.component(i, k, 1), lists.component(i, k, 2))
                }
            }
            return trees.clusters()
        }
    }
}
