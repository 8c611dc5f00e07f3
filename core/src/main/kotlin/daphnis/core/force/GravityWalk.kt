package daphnis.core.force

import daphnis.core.force.GravityTree.Companion.LEAST
import daphnis.core.force.GravityTree.Companion.MASS
import daphnis.core.force.GravityTree.Companion.MOST
import daphnis.core.force.GravityTree.Companion.WIDTH
import kotlin.math.sqrt

/**
 * One walk through a [tree] for all spheres of a leaf (Barnes 1990, J. Comput. Phys. 87, 161): [begin], [collect] for each image, [sum]. Collects what
 * attracts the leaf, spheres and nodes taken as one, in one list, then sums the list for each sphere. Each thread has its own.
 */
internal class GravityWalk(private val tree: GravityTree, private val openingAngle: Double, private val softening: Double, private val stressRange: Double) {
    private var leaf = 0

    // What attracts: position and mass.
    private var sx = DoubleArray(INITIAL)
    private var sy = DoubleArray(INITIAL)
    private var sz = DoubleArray(INITIAL)
    private var sm = DoubleArray(INITIAL)
    private var count = 0

    fun begin(leaf: Int) {
        this.leaf = leaf
        count = 0
    }

    /** Adds what attracts the leaf from the image of everything that is displaced by ([dx], [dy], [dz]); all zero for the original. */
    fun collect(dx: Double, dy: Double, dz: Double) {
        // A node that holds the leaf itself is never taken as one mass: that of a single sphere would stand beside it by a rounding.
        val isOriginal = dx == 0.0 && dy == 0.0 && dz == 0.0
        val first = tree.from[leaf]
        val node = tree.node
        val skip = tree.skip
        val own = leaf * WIDTH
        val theta2 = openingAngle * openingAngle
        var n = 0
        while (n < tree.nodes) {
            val p = n * WIDTH
            val x = node[p] + dx
            val y = node[p + 1] + dy
            val z = node[p + 2] + dz
            val ax = gap(node[own + LEAST], node[own + MOST], x)
            val ay = gap(node[own + LEAST + 1], node[own + MOST + 1], y)
            val az = gap(node[own + LEAST + 2], node[own + MOST + 2], z)
            val size = Math.max(
                Math.max(node[p + MOST] - node[p + LEAST], node[p + MOST + 1] - node[p + LEAST + 1]),
                node[p + MOST + 2] - node[p + LEAST + 2],
            )
            val isOwn = isOriginal && tree.from[n] <= first && first < tree.to[n]
            if (!isOwn && size * size < theta2 * (ax * ax + ay * ay + az * az)) {
                add(x, y, z, node[p + MASS])
                n = skip[n]
            } else if (skip[n] == n + 1) {
                for (k in tree.from[n] until tree.to[n]) add(tree.x[k] + dx, tree.y[k] + dy, tree.z[k] + dz, tree.mass[k])
                n++
            } else {
                n++
            }
        }
    }

    /** Distance of [a] from the interval. */
    private fun gap(least: Double, most: Double, a: Double): Double = if (a < least) {
        least - a
    } else if (a > most) {
        a - most
    } else {
        0.0
    }

    private fun add(x: Double, y: Double, z: Double, mass: Double) {
        if (count == sx.size) {
            sx = sx.copyOf(count * 2)
            sy = sy.copyOf(count * 2)
            sz = sz.copyOf(count * 2)
            sm = sm.copyOf(count * 2)
        }
        sx[count] = x
        sy[count] = y
        sz[count] = z
        sm[count++] = mass
    }

    /** Writes the acceleration of every sphere of the leaf, Σ a_y Δx and the potential, by index in the population. */
    fun sum(constant: Double, ax: DoubleArray, ay: DoubleArray, az: DoubleArray, stress: DoubleArray, potential: DoubleArray) {
        val softening2 = softening * softening
        val range2 = stressRange * stressRange
        for (place in tree.from[leaf] until tree.to[leaf]) {
            val x = tree.x[place]
            val y = tree.y[place]
            val z = tree.z[place]
            var fx = 0.0
            var fy = 0.0
            var fz = 0.0
            var fyx = 0.0
            var depth = 0.0
            for (k in 0 until count) {
                val dx = sx[k] - x
                val dy = sy[k] - y
                val dz = sz[k] - z
                val d2 = dx * dx + dy * dy + dz * dz
                // The sphere itself is in the list.
                if (d2 == 0.0) continue
                val s2 = d2 + softening2
                val f = sm[k] / (s2 * sqrt(s2))
                depth += f * s2
                fx += f * dx
                fy += f * dy
                fz += f * dz
                if (d2 < range2) fyx += f * dy * dx
            }
            val index = tree.order[place]
            ax[index] = constant * fx
            ay[index] = constant * fy
            az[index] = constant * fz
            stress[index] = constant * fyx
            potential[index] = -constant * depth
        }
    }

    private companion object {
        const val INITIAL = 1024
    }
}
