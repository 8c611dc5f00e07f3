package daphnis.core.engine.lists

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.space.Images

/**
 * Those in the list of a sphere that may touch it on their present paths, with the terms of
 * [daphnis.core.collision.contactTime] for spheres a little larger than they are.
 */
internal class Approaching(private val rows: StepRows, private val lists: NeighbourLists, private val images: Images) {
    /** Places in [NeighbourLists.entries] of those that were found, and their b, c and b² − ac. */
    var entries = IntArray(0)
        private set
    var b = DoubleArray(0)
        private set
    var c = DoubleArray(0)
        private set
    var discriminant = DoubleArray(0)
        private set

    /** Makes room for a list as long as any. */
    fun reserve() {
        if (entries.size >= lists.stride) return
        b = DoubleArray(lists.stride)
        c = DoubleArray(lists.stride)
        discriminant = DoubleArray(lists.stride)
        // Last, since its length says for how many there is room.
        entries = IntArray(lists.stride)
    }

    /**
     * Looks through the list of [i] from time [now] on.
     *
     * @param margin by how much spheres are taken to be larger
     * @param receding b from which on two recede for certain
     * @return how many were found
     */
    fun find(i: Int, now: Double, margin: Double, receding: Double): Int {
        val state = rows.state
        val list = lists.entries
        val codes = lists.codes
        val found = entries
        val foundB = b
        val foundC = c
        val foundDiscriminant = discriminant
        val p = i * STRIDE
        val vx = state[p + VX]
        val vy = state[p + VX + 1]
        val vz = state[p + VX + 2]
        val elapsed = now - state[p + TIME]
        val x = state[p] + vx * elapsed
        val y = state[p + 1] + vy * elapsed
        val z = state[p + 2] + vz * elapsed
        val radius = state[p + RADIUS] + margin
        val approaches = images.approach != 0.0
        val from = i * lists.stride + 1
        val to = from + list[from - 1]
        var count = 0
        for (k in from until to) {
            val e = list[k]
            val q = (e and NeighbourLists.SPHERE) * STRIDE
            val past = now - state[q + TIME]
            var wx = state[q + VX]
            var wy = state[q + VX + 1]
            var wz = state[q + VX + 2]
            var dx = state[q] + wx * past - x
            var dy = state[q + 1] + wy * past - y
            var dz = state[q + 2] + wz * past - z
            if (e < 0) {
                val code = codes[k]
                dx += images.shift(code, 0)
                dy += images.shift(code, 1)
                dz += images.shift(code, 2)
                if (approaches) {
                    val px = images.slide(code, 0)
                    val py = images.slide(code, 1)
                    val pz = images.slide(code, 2)
                    dx += px * now
                    dy += py * now
                    dz += pz * now
                    wx += px
                    wy += py
                    wz += pz
                }
            }
            val ux = wx - vx
            val uy = wy - vy
            val uz = wz - vz
            val s = radius + state[q + RADIUS]
            val b = dx * ux + dy * uy + dz * uz
            val c = dx * dx + dy * dy + dz * dz - s * s
            val discriminant = b * b - (ux * ux + uy * uy + uz * uz) * c
            foundB[count] = b
            foundC[count] = c
            foundDiscriminant[count] = discriminant
            found[count] = k
            // One more if b is small enough and the discriminant is not negative. A branch would be wrong too often.
            val isKept = (b - receding).toRawBits() and discriminant.toRawBits().inv()
            count += (isKept ushr SIGN).toInt()
        }
        return count
    }

    private companion object {
        const val SIGN = 63
    }
}
