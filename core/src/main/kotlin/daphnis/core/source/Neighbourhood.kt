package daphnis.core.source

import daphnis.core.boundary.Box
import daphnis.core.growth.GrowingTable
import daphnis.core.space.Images
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor

/**
 * Spheres in and around a part of space, in cells, which can be asked whether there is room for one more. Spheres come
 * and go; each has a number, counted from 0, which is no other's later.
 *
 * @param reach the greatest distance of two centres at which spheres can overlap
 * @param expected how many spheres there will be, about
 */
internal class Neighbourhood(
    lower: DoubleArray,
    upper: DoubleArray,
    private val reach: Double,
    expected: Int,
    images: Images,
    box: Box,
) : GrowingTable() {
    private val period = DoubleArray(AXES) { images.period(it) }
    private val from = DoubleArray(AXES) { if (period[it] > 0) box.lower(it) else lower[it] - reach }
    private val span = DoubleArray(AXES) {
        if (period[it] > 0) period[it] else upper[it] - lower[it] + 2 * reach
    }
    private val cells = IntArray(AXES) { axis -> if (reach > 0) (span[axis] / reach).coerceIn(1.0, 1e6).toInt() else 1 }
    private val heads: IntArray
    private var next = IntArray(0)
    private var spheres = DoubleArray(0)
    private var ids = IntArray(0)
    private var own = BooleanArray(0)

    init {
        while (cells.fold(1.0) { all, it -> all * it } > PER_SPHERE * (expected + FEW)) {
            for (axis in 0 until AXES) cells[axis] = ceil(cells[axis] / 2.0).toInt()
        }
        heads = IntArray(cells[0] * cells[1] * cells[2]) { NONE }
    }

    override fun resize(room: Int) {
        next = next.copyOf(room)
        spheres = spheres.copyOf(SPHERE * room)
        ids = ids.copyOf(room)
        own = own.copyOf(room)
    }

    fun id(number: Int): Int = ids[number]

    fun isOwn(number: Int): Boolean = own[number]

    fun x(number: Int, axis: Int): Double = spheres[SPHERE * number + axis]

    /** Adds a sphere at [at]. @return its number */
    fun add(id: Int, at: DoubleArray, radius: Double, isOwn: Boolean): Int {
        val number = append()
        at.copyInto(spheres, SPHERE * number)
        spheres[SPHERE * number + AXES] = radius
        ids[number] = id
        own[number] = isOwn
        val cell = cellOf(number)
        next[number] = heads[cell]
        heads[cell] = number
        return number
    }

    /** Takes the sphere of [number] away. */
    fun remove(number: Int) {
        val cell = cellOf(number)
        var before = NONE
        var here = heads[cell]
        while (here != number) {
            before = here
            here = next[here]
        }
        if (before == NONE) heads[cell] = next[number] else next[before] = next[number]
    }

    /** Whether a sphere of [radius] at [at] overlaps none. */
    fun isFree(at: DoubleArray, radius: Double): Boolean {
        for (cz in first(2, at)..last(2, at)) {
            for (cy in first(1, at)..last(1, at)) {
                for (cx in first(0, at)..last(0, at)) {
                    var other = heads[index(wrapped(0, cx), wrapped(1, cy), wrapped(2, cz))]
                    while (other != NONE) {
                        if (overlaps(other, at, radius)) return false
                        other = next[other]
                    }
                }
            }
        }
        return true
    }

    private fun overlaps(other: Int, at: DoubleArray, radius: Double): Boolean {
        var squared = 0.0
        for (axis in 0 until AXES) {
            val d = spheres[SPHERE * other + axis] - at[axis]
            val length = period[axis]
            val apart = if (length == 0.0 || abs(d) < length / 2) d else d - length * Math.rint(d / length)
            squared += apart * apart
        }
        val sum = spheres[SPHERE * other + AXES] + radius
        return squared < sum * sum
    }

    private fun cell(axis: Int, x: Double): Int =
        floor((x - from[axis]) / span[axis] * cells[axis]).toInt().coerceIn(0, cells[axis] - 1)

    private fun cellOf(number: Int): Int = index(cell(0, x(number, 0)), cell(1, x(number, 1)), cell(2, x(number, 2)))

    private fun index(x: Int, y: Int, z: Int) = (z * cells[1] + y) * cells[0] + x

    /** The cells along [axis] that can hold a neighbour; with one or two, both neighbours of a cell are the same. */
    private fun first(axis: Int, at: DoubleArray): Int = cell(axis, at[axis]).let {
        if (period[axis] == 0.0) maxOf(it - 1, 0) else it - if (cells[axis] >= 3) 1 else 0
    }

    private fun last(axis: Int, at: DoubleArray): Int = cell(axis, at[axis]).let {
        if (period[axis] == 0.0) minOf(it + 1, cells[axis] - 1) else it + if (cells[axis] >= 2) 1 else 0
    }

    private fun wrapped(axis: Int, cell: Int): Int = Math.floorMod(cell, cells[axis])

    private companion object {
        const val AXES = 3
        const val SPHERE = AXES + 1
        const val NONE = -1
        const val FEW = 16
        const val PER_SPHERE = 8.0
    }
}
