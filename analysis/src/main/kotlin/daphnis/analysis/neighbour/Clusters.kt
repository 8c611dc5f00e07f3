package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import daphnis.analysis.insitu.forEachVector
import daphnis.core.boundary.prepare
import daphnis.core.space.Images

/**
 * Clusters of particles: sets in which each is linked to another, also through faces and by images that slide. Found by
 * union and find (Tarjan 1975, J. ACM 22, 215) that keeps where each particle is relative to its cluster's root, so
 * that a cluster which meets an image of itself is seen.
 *
 * @property label number of the cluster of each sphere, by index in the population; clusters are numbered from the
 *   largest down, of equal ones that with the lowest index first; −1 for bodies and for what is in none
 * @property sizes numbers of particles of clusters, descending
 * @property spans whether a cluster is connected with its own images along x, y and z: it has no end there
 */
public class Clusters private constructor(
    public val label: IntArray,
    public val sizes: IntArray,
    public val spans: List<Boolean>,
) {
    /** Particles in clusters. */
    public val particles: Int get() = sizes.sum()

    /** Σ s²/Σ s: the size of the cluster of a particle, on average; 0 without particles. */
    public val meanSize: Double
        get() = if (sizes.isEmpty()) 0.0 else sizes.sumOf { it.toDouble() * it } / particles

    public companion object {
        /**
         * Of particles whose surfaces are up to [gap] apart, a length ≥ 0; single particles are clusters of one.
         */
        @JvmStatic
        public fun byGap(state: State, gap: Double): Clusters {
            require(gap >= 0 && gap.isFinite()) { "surfaces up to $gap apart; it must be a length >= 0" }
            val p = state.population
            val largest = (0 until p.size).maxOfOrNull { if (state.isParticle(it)) p.radius[it] else 0.0 } ?: 0.0
            val reach = 2 * largest + gap
            val links = Links(state) { state.isParticle(it) }
            forEachVector(state, reach) { i, j, dx, dy, dz ->
                val contact = p.radius[i] + p.radius[j] + gap
                if (dx * dx + dy * dy + dz * dz <= contact * contact) links.join(i, j, dx, dy, dz)
            }
            return links.clusters()
        }

        /** Of the particles that are [members], by index, linked where one is on the list of the other. */
        @JvmStatic
        public fun ofNeighbours(state: State, lists: NeighbourLists, members: BooleanArray): Clusters {
            require(members.size == state.population.size && lists.size == members.size) {
                "${members.size} flags and neighbours of ${lists.size} for ${state.population.size} spheres"
            }
            val links = Links(state) { members[it] && state.isParticle(it) }
            for (i in members.indices) {
                if (!members[i]) continue
                for (k in 0 until lists.count(i)) {
                    val j = lists.neighbour(i, k)
                    if (!members[j]) continue
                    links.join(i, j, lists.component(i, k, 0), lists.component(i, k, 1), lists.component(i, k, 2))
                }
            }
            return links.clusters()
        }
    }

    /** Trees of the particles that are in any cluster. */
    private class Links(private val state: State, isMember: (Int) -> Boolean) {
        private val n = state.population.size
        private val parent = IntArray(n) { if (isMember(it)) it else -1 }
        private val size = IntArray(n) { 1 }

        /** The vector from each particle to its parent, by axis. */
        private val to = Array(3) { DoubleArray(n) }
        private val images = Images().also { it.prepare(state.boundary, state.time) }
        private val spans = BooleanArray(3)

        fun join(i: Int, j: Int, dx: Double, dy: Double, dz: Double) {
            val a = root(i)
            val b = root(j)
            // From root a to root b, by way of i and j.
            val vx = dx - to[0][i] + to[0][j]
            val vy = dy - to[1][i] + to[1][j]
            val vz = dz - to[2][i] + to[2][j]
            if (a == b) return close(vx, vy, vz)
            val under = if (size[a] < size[b]) a else b
            val over = a + b - under
            val sign = if (under == a) 1 else -1
            parent[under] = over
            size[over] += size[under]
            to[0][under] = sign * vx
            to[1][under] = sign * vy
            to[2][under] = sign * vz
        }

        /** The way around that ends where it began, or at an image of that. */
        private fun close(vx: Double, vy: Double, vz: Double) {
            val v = doubleArrayOf(vx, vy, vz)
            val normal = images.normalAxis
            if (normal >= 0) {
                val turns = Math.rint(v[normal] / state.boundary.box.length(normal))
                v[images.slideAxis] -= turns * images.shearOffset
            }
            for (axis in 0..2) {
                if (!state.boundary.hasImages(axis)) continue
                if (Math.rint(v[axis] / state.boundary.box.length(axis)) != 0.0) spans[axis] = true
            }
        }

        /** The root of [i], which is its parent afterwards. */
        private fun root(i: Int): Int {
            var at = i
            var x = 0.0
            var y = 0.0
            var z = 0.0
            while (parent[at] != at) {
                x += to[0][at]
                y += to[1][at]
                z += to[2][at]
                at = parent[at]
            }
            val root = at
            at = i
            while (parent[at] != root && at != root) {
                val next = parent[at]
                val (dx, dy, dz) = doubleArrayOf(to[0][at], to[1][at], to[2][at])
                parent[at] = root
                to[0][at] = x
                to[1][at] = y
                to[2][at] = z
                x -= dx
                y -= dy
                z -= dz
                at = next
            }
            return root
        }

        fun clusters(): Clusters {
            val first = IntArray(n) { -1 }
            val roots = IntArray(n) { if (parent[it] < 0) -1 else root(it) }
            for (i in n - 1 downTo 0) if (roots[i] >= 0) first[roots[i]] = i
            val all = (0 until n).filter { roots[it] == it }
                .sortedWith(compareByDescending<Int> { size[it] }.thenBy { first[it] })
            val number = IntArray(n) { -1 }
            for ((k, root) in all.withIndex()) number[root] = k
            return Clusters(
                IntArray(n) { if (roots[it] < 0) -1 else number[roots[it]] },
                IntArray(all.size) { size[all[it]] },
                spans.toList(),
            )
        }
    }
}
