package daphnis.analysis.neighbour

import daphnis.analysis.insitu.State
import daphnis.core.boundary.prepare
import daphnis.core.space.Images

/** Trees of the spheres of [state] that are in any cluster. */
internal class ClusterTrees(private val state: State, isMember: (Int) -> Boolean) {
    private val n = state.population.size
    private val parent = IntArray(n) { if (isMember(it)) it else -1 }
    private val size = IntArray(n) { 1 }

    /** The vector from each particle to its parent, by axis. */
    private val to = Array(3) { DoubleArray(n) }
    private val images = Images().also { it.prepare(state.boundary, state.time) }
    private val spans = BooleanArray(3)

    /** Whether the cluster of a root meets an image of itself. */
    private val isEndless = BooleanArray(n)

    /** Links [i] with the image of [j] that is at (dx, dy, dz) from it. */
    fun join(i: Int, j: Int, dx: Double, dy: Double, dz: Double) {
        val a = root(i)
        val b = root(j)
        // From root a to root b, by way of i and j.
        val vx = dx - to[0][i] + to[0][j]
        val vy = dy - to[1][i] + to[1][j]
        val vz = dz - to[2][i] + to[2][j]
        if (a == b) return close(a, vx, vy, vz)
        val under = if (size[a] < size[b]) a else b
        val over = a + b - under
        val sign = if (under == a) 1 else -1
        parent[under] = over
        size[over] += size[under]
        isEndless[over] = isEndless[over] || isEndless[under]
        to[0][under] = sign * vx
        to[1][under] = sign * vy
        to[2][under] = sign * vz
    }

    /** The way around that ends where it began, or at an image of that. */
    private fun close(root: Int, vx: Double, vy: Double, vz: Double) {
        val v = doubleArrayOf(vx, vy, vz)
        val normal = images.normalAxis
        if (normal >= 0) {
            val turns = Math.rint(v[normal] / state.boundary.box.length(normal))
            v[images.slideAxis] -= turns * images.shearOffset
        }
        for (axis in 0..2) {
            if (!state.boundary.hasImages(axis)) continue
            if (Math.rint(v[axis] / state.boundary.box.length(axis)) == 0.0) continue
            spans[axis] = true
            isEndless[root] = true
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
            BooleanArray(all.size) { isEndless[all[it]] },
            // Of each sphere from the root of its cluster, which is its parent by now.
            Array(3) { axis -> DoubleArray(n) { if (roots[it] < 0 || roots[it] == it) 0.0 else -to[axis][it] } },
        )
    }
}
