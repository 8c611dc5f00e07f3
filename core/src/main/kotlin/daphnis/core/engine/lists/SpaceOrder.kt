package daphnis.core.engine.lists

import daphnis.core.population.SphereColumns
import daphnis.core.search.CellAxes

/** An order in which spheres near each other come one soon after the other: Morton's curve through small cubes. */
internal class SpaceOrder {
    private var keys = LongArray(0)

    // The box that is divided.
    private val low = DoubleArray(CellAxes.AXES)
    private val high = DoubleArray(CellAxes.AXES)

    /** Index by slot; the first entries count. */
    var order = IntArray(0)
        private set

    /**
     * Sorts [spheres] into [regions] boxes of [slotsARegion] spheres each, the last with what is left; within each along
     * the curve.
     */
    fun sort(spheres: SphereColumns, space: ListSpace, regions: Int, slotsARegion: Int) {
        val n = spheres.size
        keep(n)
        for (axis in 0 until CellAxes.AXES) {
            low[axis] = space.low[axis]
            high[axis] = space.low[axis] + space.length[axis]
        }
        divide(spheres, 0, n, regions, slotsARegion)
        // Cubes as long as the longest axis over 2^10.
        val edge = (0 until CellAxes.AXES).maxOf { space.length[it] } / CUBES
        for (slot in 0 until n) {
            val k = order[slot]
            var key = 0L
            for (axis in 0 until CellAxes.AXES) {
                val c = (spheres.position(axis)[k] - space.low[axis]) / edge
                key = key or (spread(c.coerceIn(0.0, CUBES - 1.0).toLong()) shl axis)
            }
            keys[slot] = (key shl Int.SIZE_BITS) or k.toLong()
        }
        for (r in 0 until regions) keys.sort(r * slotsARegion, minOf((r + 1) * slotsARegion, n))
        for (k in 0 until n) order[k] = keys[k].toInt()
    }

    /** Cuts the box of the slots [from] until [to] in two across its longest edge, and these, until there are [regions]. */
    private fun divide(spheres: SphereColumns, from: Int, to: Int, regions: Int, slotsARegion: Int) {
        if (regions == 1) return
        val axis = (0 until CellAxes.AXES).maxBy { high[it] - low[it] }
        val half = regions / 2
        val middle = from + half * slotsARegion
        val position = spheres.position(axis)
        select(position, from, to - 1, middle)
        val cut = position[order[middle]]
        val top = high[axis]
        high[axis] = cut
        divide(spheres, from, middle, half, slotsARegion)
        high[axis] = top
        val bottom = low[axis]
        low[axis] = cut
        divide(spheres, middle, to, regions - half, slotsARegion)
        low[axis] = bottom
    }

    /** Orders the slots [first]..[last] so that none before slot [k] is farther along [position] than any from it on. */
    private fun select(position: DoubleArray, first: Int, last: Int, k: Int) {
        var low = first
        var high = last
        while (low < high) {
            val pivot = position[order[(low + high) ushr 1]]
            var i = low
            var j = high
            while (i <= j) {
                while (position[order[i]] < pivot) i++
                while (position[order[j]] > pivot) j--
                if (i <= j) {
                    val swap = order[i]
                    order[i++] = order[j]
                    order[j--] = swap
                }
            }
            if (k <= j) {
                high = j
            } else if (k >= i) {
                low = i
            } else {
                return
            }
        }
    }

    /** The order that the spheres have. */
    fun keep(n: Int) {
        reserve(n)
        for (k in 0 until n) order[k] = k
    }

    private fun reserve(n: Int) {
        if (order.size >= n) return
        keys = LongArray(n)
        order = IntArray(n)
    }

    /** The ten lowest bits of [v], three places apart. */
    private fun spread(v: Long): Long {
        var s = v and 0x3ff
        s = (s or (s shl 16)) and 0x030000ff
        s = (s or (s shl 8)) and 0x0300f00f
        s = (s or (s shl 4)) and 0x030c30c3
        return (s or (s shl 2)) and 0x09249249
    }

    private companion object {
        const val CUBES = 1024.0
    }
}
