package daphnis.core.force

import daphnis.core.force.GravityTree.Companion.LEAST
import daphnis.core.force.GravityTree.Companion.MASS
import daphnis.core.force.GravityTree.Companion.MOST
import daphnis.core.force.GravityTree.Companion.WIDTH
import kotlin.math.sqrt

/**
 * One walk through a [tree] for all spheres of a leaf (Barnes 1990, J. Comput. Phys. 87, 161): [begin], [collect] for
 * each image, [sum]. Collects what attracts the leaf, single spheres and nodes taken as one mass, in two lists: what is
 * so near to the whole leaf that nothing is cut, and what the [cut] weights pair by pair. Then sums the lists for each
 * sphere. Each thread has its own walk.
 */
internal class GravityWalk(
    private val tree: GravityTree,
    private val openingAngle: Double,
    softening: Double,
    private val cut: GravityCut,
) {
    private val whole = Attractors()
    private val cutOff = Attractors()
    private val softening2 = softening * softening
    private val theta2 = openingAngle * openingAngle
    private val range2 = cut.range * cut.range
    private val inner2 = cut.inner * cut.inner
    private val fading = 1 / (range2 - inner2)
    private val fadingPotential = FadingPotential(range2, inner2, softening2)
    private val lift = fadingPotential.lift
    private val countsX = cut.counts(0)
    private val countsY = cut.counts(1)
    private val countsZ = cut.counts(2)
    private var leaf = 0

    // For the sphere being summed: acceleration, Σ a_y Δx and minus the potential, divided by G.
    private var fx = 0.0
    private var fy = 0.0
    private var fz = 0.0
    private var fyx = 0.0
    private var depth = 0.0

    fun begin(leaf: Int) {
        this.leaf = leaf
        whole.clear()
        cutOff.clear()
    }

    /**
     * Adds what attracts the leaf from the image of everything that is displaced by ([dx], [dy], [dz]); all zero for
     * the original.
     */
    fun collect(dx: Double, dy: Double, dz: Double) {
        // A node that holds the leaf itself is never taken as one mass: the mass of a single sphere would lie beside
        // that sphere by round-off.
        val isOriginal = dx == 0.0 && dy == 0.0 && dz == 0.0
        val first = tree.from[leaf]
        val node = tree.node
        val skip = tree.skip
        // Nodes before this one are so near that no part of them is cut.
        var wholeUntil = if (cut.isPresent) 0 else tree.size
        var n = 0
        while (n < tree.size) {
            if (n >= wholeUntil) {
                if (nearest2(n, dx, dy, dz) >= range2) {
                    n = skip[n]
                    continue
                }
                if (farthest2(n, dx, dy, dz) <= inner2) wholeUntil = skip[n]
            }
            val isWhole = n < wholeUntil
            val into = if (isWhole) whole else cutOff
            val p = n * WIDTH
            val size = sizeOf(p)
            val isOwn = isOriginal && tree.from[n] <= first && first < tree.to[n]
            if (!isOwn && (isWhole || size <= cut.largestNode) && size * size < theta2 * distance2(p, dx, dy, dz)) {
                into.add(node[p] + dx, node[p + 1] + dy, node[p + 2] + dz, node[p + MASS])
                n = skip[n]
            } else if (skip[n] == n + 1) {
                for (k in tree.from[n] until tree.to[n]) {
                    into.add(
                        tree.x[k] + dx,
                        tree.y[k] + dy,
                        tree.z[k] + dz,
                        tree.mass[k],
                    )
                }
                n++
            } else {
                n++
            }
        }
    }

    private fun sizeOf(p: Int): Double {
        val node = tree.node
        return Math.max(
            Math.max(node[p + MOST] - node[p + LEAST], node[p + MOST + 1] - node[p + LEAST + 1]),
            node[p + MOST + 2] - node[p + LEAST + 2],
        )
    }

    /** Square of the distance of the centre of mass in row [p] from the leaf's box. */
    private fun distance2(p: Int, dx: Double, dy: Double, dz: Double): Double {
        val node = tree.node
        val own = leaf * WIDTH
        val ax = gap(node[own + LEAST], node[own + MOST], node[p] + dx)
        val ay = gap(node[own + LEAST + 1], node[own + MOST + 1], node[p + 1] + dy)
        val az = gap(node[own + LEAST + 2], node[own + MOST + 2], node[p + 2] + dz)
        return ax * ax + ay * ay + az * az
    }

    /** Distance of [a] from the interval. */
    private fun gap(least: Double, most: Double, a: Double): Double = if (a < least) {
        least - a
    } else if (a > most) {
        a - most
    } else {
        0.0
    }

    /**
     * Square of the least distance, along the axes that count, between a sphere of the leaf and one of the image of
     * node [n].
     */
    private fun nearest2(n: Int, dx: Double, dy: Double, dz: Double): Double =
        countsX * near2(n, 0, dx) + countsY * near2(n, 1, dy) + countsZ * near2(n, 2, dz)

    private fun near2(n: Int, axis: Int, shift: Double): Double {
        val node = tree.node
        val p = n * WIDTH + axis
        val own = leaf * WIDTH + axis
        val apart = Math.max(node[p + LEAST] + shift - node[own + MOST], node[own + LEAST] - (node[p + MOST] + shift))
        return if (apart > 0.0) apart * apart else 0.0
    }

    /** The same for the greatest distance. */
    private fun farthest2(n: Int, dx: Double, dy: Double, dz: Double): Double =
        countsX * far2(n, 0, dx) + countsY * far2(n, 1, dy) + countsZ * far2(n, 2, dz)

    private fun far2(n: Int, axis: Int, shift: Double): Double {
        val node = tree.node
        val p = n * WIDTH + axis
        val own = leaf * WIDTH + axis
        val apart = Math.max(node[p + MOST] + shift - node[own + LEAST], node[own + MOST] - (node[p + LEAST] + shift))
        return apart * apart
    }

    /**
     * Writes the acceleration of every sphere of the leaf that is among the first [count], Σ a_y Δx and the potential,
     * by index.
     */
    fun sum(
        count: Int,
        constant: Double,
        ax: DoubleArray,
        ay: DoubleArray,
        az: DoubleArray,
        stress: DoubleArray,
        potential: DoubleArray,
    ) {
        for (place in tree.from[leaf] until tree.to[leaf]) {
            val index = tree.order[place]
            if (index >= count) continue
            sumWhole(tree.x[place], tree.y[place], tree.z[place])
            addCutOff(tree.x[place], tree.y[place], tree.z[place])
            ax[index] = constant * fx
            ay[index] = constant * fy
            az[index] = constant * fz
            stress[index] = constant * fyx
            potential[index] = -constant * depth
        }
    }

    private fun sumWhole(x: Double, y: Double, z: Double) {
        val sx = whole.x
        val sy = whole.y
        val sz = whole.z
        val sm = whole.mass
        var fx = 0.0
        var fy = 0.0
        var fz = 0.0
        var fyx = 0.0
        var depth = 0.0
        for (k in 0 until whole.size) {
            val dx = sx[k] - x
            val dy = sy[k] - y
            val dz = sz[k] - z
            val d2 = dx * dx + dy * dy + dz * dz
            // The sphere itself is in the list.
            if (d2 == 0.0) continue
            val s2 = d2 + softening2
            val f = sm[k] / (s2 * sqrt(s2))
            depth += f * s2 - sm[k] * lift
            fx += f * dx
            fy += f * dy
            fz += f * dz
            fyx += f * dy * dx
        }
        this.fx = fx
        this.fy = fy
        this.fz = fz
        this.fyx = fyx
        this.depth = depth
    }

    private fun addCutOff(x: Double, y: Double, z: Double) {
        val sx = cutOff.x
        val sy = cutOff.y
        val sz = cutOff.z
        val sm = cutOff.mass
        var fx = fx
        var fy = fy
        var fz = fz
        var fyx = fyx
        var depth = depth
        for (k in 0 until cutOff.size) {
            val dx = sx[k] - x
            val dy = sy[k] - y
            val dz = sz[k] - z
            val rho2 = countsX * dx * dx + countsY * dy * dy + countsZ * dz * dz
            val d2 = dx * dx + dy * dy + dz * dz
            if (rho2 >= range2 || d2 == 0.0) continue
            val t = (range2 - rho2) * fading
            val weight = if (t >= 1.0) 1.0 else t * t * (3.0 - 2.0 * t)
            val s2 = d2 + softening2
            val f = weight * sm[k] / (s2 * sqrt(s2))
            depth += if (t >= 1.0) f * s2 - sm[k] * lift else sm[k] * fadingPotential.depth(rho2)
            fx += f * dx
            fy += f * dy
            fz += f * dz
            fyx += f * dy * dx
        }
        this.fx = fx
        this.fy = fy
        this.fz = fz
        this.fyx = fyx
        this.depth = depth
    }
}
