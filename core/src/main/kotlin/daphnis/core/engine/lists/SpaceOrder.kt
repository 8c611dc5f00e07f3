package daphnis.core.engine.lists

import daphnis.core.population.SphereColumns
import daphnis.core.search.CellAxes

/** An order in which spheres near each other come one soon after the other: Morton's curve through small cubes. */
internal class SpaceOrder {
    private var keys = LongArray(0)

    /** Index by slot; the first entries count. */
    var order = IntArray(0)
        private set

    fun sort(spheres: SphereColumns, space: ListSpace) {
        val n = spheres.size
        reserve(n)
        // Cubes as long as the longest axis over 2^10.
        val edge = (0 until CellAxes.AXES).maxOf { space.length[it] } / CUBES
        for (k in 0 until n) {
            var key = 0L
            for (axis in 0 until CellAxes.AXES) {
                val c = (spheres.position(axis)[k] - space.low[axis]) / edge
                key = key or (spread(c.coerceIn(0.0, CUBES - 1.0).toLong()) shl axis)
            }
            keys[k] = (key shl Int.SIZE_BITS) or k.toLong()
        }
        keys.sort(0, n)
        for (k in 0 until n) order[k] = keys[k].toInt()
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
