package daphnis.core.force

import daphnis.core.growth.GrowingTable
import daphnis.core.growth.IntList
import daphnis.core.population.SphereColumns

/**
 * An octree over a population for sums of gravity (Barnes & Hut 1986, Nature 324, 446). Spheres are sorted along a
 * Morton curve, spheres with one key by id, so the tree and every sum in it are the same whatever order the arrays are
 * in. Nodes are in depth-first order: the first child of node n is n + 1, and the node after its subtree is [skip]. The
 * rows of this table are nodes.
 *
 * ```
 *   0 root        skip 9
 *   ├─ 1          skip 4        a walk goes n → n + 1 to open a node,
 *   │  ├─ 2 leaf  skip 3                  n → skip[n] to take it as it is
 *   │  └─ 3 leaf  skip 4
 *   └─ 4 …
 * ```
 */
internal class GravityTree : GrowingTable() {
    /** Index among the spheres by place on the curve. */
    var order = IntArray(0)
        private set

    /** Positions and masses by place on the curve. */
    val x get() = columns[0]
    val y get() = columns[1]
    val z get() = columns[2]
    val mass get() = columns[3]
    private var columns = Array(4) { DoubleArray(0) }

    /** Node after the subtree of a node. */
    var skip = IntArray(0)
        private set

    /** Places of the spheres of a node: from until to. */
    var from = IntArray(0)
        private set
    var to = IntArray(0)
        private set

    /**
     * Centre of mass x y z, mass, and least x y z, greatest x y z of its spheres' centres: [WIDTH] numbers per node.
     */
    var node = DoubleArray(0)
        private set

    /** Nodes that are leaves. */
    val leaves = IntList()

    private var keys = LongArray(0)
    private var spareKeys = LongArray(0)
    private var spareOrder = IntArray(0)
    private val counts = IntArray(1 shl DIGIT)

    fun build(population: SphereColumns) {
        val n = population.size
        makeRoom(n)
        computeKeys(population)
        sort(n, population.id)
        for (place in 0 until n) {
            val k = order[place]
            x[place] = population.x[k]
            y[place] = population.y[k]
            z[place] = population.z[k]
            mass[place] = population.mass[k]
        }
        clear()
        leaves.clear()
        if (n > 0) divide(0, n, TOP_SHIFT)
    }

    /** Whether one of the first [count] spheres is in [leaf]. */
    fun hasAny(leaf: Int, count: Int): Boolean {
        for (place in from[leaf] until to[leaf]) if (order[place] < count) return true
        return false
    }

    private fun makeRoom(n: Int) {
        if (mass.size >= n) return
        order = IntArray(n)
        spareOrder = IntArray(n)
        keys = LongArray(n)
        spareKeys = LongArray(n)
        columns = Array(4) { DoubleArray(n) }
    }

    private fun computeKeys(p: SphereColumns) {
        val n = p.size
        val low = DoubleArray(3)
        var extent = 0.0
        for ((axis, a) in arrayOf(p.x, p.y, p.z).withIndex()) {
            var least = Double.POSITIVE_INFINITY
            var most = Double.NEGATIVE_INFINITY
            for (k in 0 until n) {
                least = Math.min(least, a[k])
                most = Math.max(most, a[k])
            }
            low[axis] = least
            extent = Math.max(extent, most - least)
        }
        val scale = if (extent > 0) CELLS / extent else 0.0
        for (k in 0 until n) {
            order[k] = k
            keys[k] =
                spread(p.x[k] - low[0], scale) or (spread(p.y[k] - low[1], scale) shl 1) or
                (spread(p.z[k] - low[2], scale) shl 2)
        }
    }

    /** The cell number with two empty bits after each bit. */
    private fun spread(offset: Double, scale: Double): Long {
        var v = minOf((offset * scale).toLong(), CELLS.toLong() - 1)
        v = (v or (v shl 32)) and 0x1f00000000ffffL
        v = (v or (v shl 16)) and 0x1f0000ff0000ffL
        v = (v or (v shl 8)) and 0x100f00f00f00f00fL
        v = (v or (v shl 4)) and 0x10c30c30c30c30c3L
        return (v or (v shl 2)) and 0x1249249249249249L
    }

    /** Radix sort, then those of one key by id. */
    private fun sort(n: Int, ids: IntArray) {
        var shift = 0
        while (shift < KEY_BITS) {
            counts.fill(0)
            for (k in 0 until n) counts[digit(keys[k], shift)]++
            if (n > 0 && counts[digit(keys[0], shift)] < n) {
                var sum = 0
                for (d in counts.indices) sum += counts[d].also { counts[d] = sum }
                for (k in 0 until n) {
                    val place = counts[digit(keys[k], shift)]++
                    spareKeys[place] = keys[k]
                    spareOrder[place] = order[k]
                }
                keys = spareKeys.also { spareKeys = keys }
                order = spareOrder.also { spareOrder = order }
            }
            shift += DIGIT
        }
        for (k in 1 until n) {
            var place = k
            while (place > 0 && keys[place - 1] == keys[place] && ids[order[place - 1]] > ids[order[place]]) {
                order[place] = order[place - 1].also { order[place - 1] = order[place] }
                place--
            }
        }
    }

    private fun digit(key: Long, shift: Int): Int = (key ushr shift).toInt() and ((1 shl DIGIT) - 1)

    private fun divide(first: Int, end: Int, topShift: Int): Int {
        var shift = topShift
        // Levels on which all spheres are in one octant have no node of their own.
        while (shift >= 0 && octant(keys[first], shift) == octant(keys[end - 1], shift)) shift -= 3
        val n = newNode(first, end)
        if (end - first <= LEAF || shift < 0) {
            leaves.add(n)
            sumSpheres(n)
        } else {
            begin(n)
            var k = first
            while (k < end) {
                val octant = octant(keys[k], shift)
                var last = k + 1
                while (last < end && octant(keys[last], shift) == octant) last++
                addChild(n, divide(k, last, shift - 3))
                k = last
            }
            finish(n)
        }
        skip[n] = size
        return n
    }

    private fun octant(key: Long, shift: Int): Int = (key ushr shift).toInt() and 7

    private fun newNode(first: Int, end: Int): Int {
        val n = append()
        from[n] = first
        to[n] = end
        return n
    }

    override fun resize(room: Int) {
        skip = skip.copyOf(room)
        from = from.copyOf(room)
        to = to.copyOf(room)
        node = node.copyOf(room * WIDTH)
    }

    private fun begin(n: Int) {
        val p = n * WIDTH
        for (e in 0..MASS) node[p + e] = 0.0
        for (axis in 0..2) {
            node[p + LEAST + axis] = Double.POSITIVE_INFINITY
            node[p + MOST + axis] = Double.NEGATIVE_INFINITY
        }
    }

    private fun sumSpheres(n: Int) {
        begin(n)
        val p = n * WIDTH
        for (k in from[n] until to[n]) {
            val m = mass[k]
            node[p + MASS] += m
            for (axis in 0..2) {
                val a = columns[axis][k]
                node[p + axis] += m * a
                node[p + LEAST + axis] = Math.min(node[p + LEAST + axis], a)
                node[p + MOST + axis] = Math.max(node[p + MOST + axis], a)
            }
        }
        finish(n)
    }

    private fun addChild(n: Int, child: Int) {
        val p = n * WIDTH
        val q = child * WIDTH
        node[p + MASS] += node[q + MASS]
        for (axis in 0..2) {
            node[p + axis] += node[q + MASS] * node[q + axis]
            node[p + LEAST + axis] = Math.min(node[p + LEAST + axis], node[q + LEAST + axis])
            node[p + MOST + axis] = Math.max(node[p + MOST + axis], node[q + MOST + axis])
        }
    }

    private fun finish(n: Int) {
        val p = n * WIDTH
        for (axis in 0..2) node[p + axis] /= node[p + MASS]
    }

    companion object {
        const val WIDTH = 10
        const val MASS = 3
        const val LEAST = 4
        const val MOST = 7

        /** The most spheres in a leaf; those of one leaf share a walk. */
        const val LEAF = 16
        private const val DIGIT = 16
        private const val KEY_BITS = 63
        private const val TOP_SHIFT = 60
        private const val CELLS = (1L shl 21).toDouble()
    }
}
