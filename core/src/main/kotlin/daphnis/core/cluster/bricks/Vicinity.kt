package daphnis.core.cluster.bricks

import daphnis.core.cluster.bricks.Cuts.Companion.AXES

/**
 * Finds which bricks a sphere concerns: its owner and those whose halo it is in. Holds the answer to one question at a
 * time, so each node has its own.
 *
 * @param home the brick near which most of the spheres are that it is asked for
 */
internal class Vicinity(private val territory: Territory, private val home: Int) {
    private var widths = HaloWidths.none(territory.size)

    // Within these planes a sphere is in the home's territory and in no halo.
    private val innerLow = DoubleArray(AXES)
    private val innerHigh = DoubleArray(AXES)

    // Along each axis the parts near the sphere and their distances.
    private val near = Array(AXES) { IntArray(territory.parts(it)) }
    private val distance = Array(AXES) { DoubleArray(territory.parts(it)) }
    private val count = IntArray(AXES) { 1 }

    /** The owner of the sphere. */
    var owner = 0
        private set

    /** The other bricks in whose halo it is: the first [size] entries. */
    val others = IntArray(territory.size)
    var size = 0
        private set

    /** Takes over [widths]. */
    fun prepare(widths: HaloWidths) {
        this.widths = widths
        for (axis in 0 until AXES) {
            innerLow[axis] = territory.lower(axis, home) + widths.widest(axis)
            innerHigh[axis] = territory.upper(axis, home) - widths.widest(axis)
        }
    }

    /** Answers for a sphere of radius [r] at ([x], [y], [z]). */
    fun look(x: Double, y: Double, z: Double, r: Double) {
        size = 0
        owner = home
        if (isInner(0, x, r) && isInner(1, y, r) && isInner(2, z, r)) return
        owner = territory.ownerOf(x, y, z)
        if (territory.cuts.isCut(0)) findParts(0, x, r)
        if (territory.cuts.isCut(1)) findParts(1, y, r)
        if (territory.cuts.isCut(2)) findParts(2, z, r)
        for (c in 0 until count[2]) {
            for (b in 0 until count[1]) {
                for (a in 0 until count[0]) addIfNear(a, b, c, r)
            }
        }
    }

    private fun isInner(axis: Int, x: Double, r: Double): Boolean = x - r > innerLow[axis] && x + r < innerHigh[axis]

    private fun findParts(axis: Int, x: Double, r: Double) {
        val most = widths.widest(axis) + r
        var found = 0
        for (part in 0 until territory.parts(axis)) {
            val d = territory.distance(axis, part, x)
            if (d > most) continue
            near[axis][found] = part
            distance[axis][found++] = d
        }
        count[axis] = found
    }

    private fun addIfNear(a: Int, b: Int, c: Int, r: Double) {
        val brick = territory.brick(near[0][a], near[1][b], near[2][c])
        if (brick == owner) return
        val isNear = distance[0][a] <= widths.width(0, brick) + r &&
            distance[1][b] <= widths.width(1, brick) + r &&
            distance[2][c] <= widths.width(2, brick) + r
        if (isNear) others[size++] = brick
    }
}
