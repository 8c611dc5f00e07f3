package daphnis.core.engine.threadpool

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.population.Population
import daphnis.core.queue.EventStore
import daphnis.core.search.Grid
import kotlin.math.abs

/**
 * The paper's busy cells: the neighbourhoods of the collisions that are being processed, and of earlier ones that had
 * to be passed over. Processing a collision writes its two spheres and reads every sphere in the cells that these could
 * search. Two collisions are **safe** together when neither writes what the other reads.
 *
 * A neighbourhood is kept as the places of its two spheres at the start of the step, which also determine the cells; it
 * reaches [extent] along each axis. There are few neighbourhoods at a time, so a list of them is quicker than flags on
 * cells. Guarded by the lock of [SafeQueue].
 */
internal class BusyCells(private val rows: StepRows, private val grid: Grid) {
    /** How far along x, y, z a sphere that is read can be from one that is written, both at the start of the step. */
    private val extent = DoubleArray(3)
    private var several = false
    private val length = DoubleArray(3)
    private var normalAxis = -1
    private var slideAxis = -1
    private lateinit var population: Population

    /** The collisions that are busy, in no order. */
    private val pairs = EventStore()

    fun prepare(population: Population) {
        this.population = population
        pairs.clear()
        normalAxis = grid.images.normalAxis
        slideAxis = grid.images.slideAxis
        several = grid.classes > 1
        for (axis in 0..2) {
            extent[axis] = grid.sight(axis)
            length[axis] = grid.images.period(axis)
        }
    }

    fun add(a: Int, b: Int, t: Double) {
        pairs.add(t, a, b, 0)
    }

    /** Removes the collision of [a] with [b], which is there. */
    fun remove(a: Int, b: Int) {
        var k = 0
        while (pairs.first(k) != a || pairs.second(k) != b) k++
        val last = pairs.size - 1
        pairs.copy(last, k)
        pairs.truncate(last)
    }

    /**
     * Whether the collision of [a] with [b] at [t] is safe together with all that are busy. Simultaneous collisions are
     * done one after the other, in their order.
     */
    fun areFree(a: Int, b: Int, t: Double): Boolean {
        for (k in 0 until pairs.size) {
            val first = pairs.first(k)
            val second = pairs.second(k)
            if (t == pairs.time(k)) return false
            if (isNear(a, first) || isNear(a, second)) return false
            if (b >= 0 && (isNear(b, first) || isNear(b, second))) return false
        }
        return true
    }

    /** Whether any busy collision comes before [t]. */
    fun hasBefore(t: Double): Boolean {
        for (k in 0 until pairs.size) if (pairs.time(k) < t) return true
        return false
    }

    private fun isNear(a: Int, b: Int): Boolean {
        if (b < 0) return false
        if (several) {
            val radius = rows.state[a * STRIDE + RADIUS] * grid.swelling
            val other = rows.state[b * STRIDE + RADIUS] * grid.swelling
            for (axis in 0..2) extent[axis] = grid.sight(axis, radius, other)
        }
        val i = rows.origin[a]
        val j = rows.origin[b]
        for (axis in 0..2) {
            val x = population.position(axis)
            val direct = abs(x[i] - x[j])
            val through = if (length[axis] > 0) abs(length[axis] - direct) else Double.POSITIVE_INFINITY
            // Images across the sheared faces may be anywhere along the slide.
            if (axis == slideAxis && acrossSlidingFaces(i, j)) continue
            if (direct > extent[axis] && through > extent[axis]) return false
        }
        return true
    }

    private fun acrossSlidingFaces(i: Int, j: Int): Boolean {
        val x = population.position(normalAxis)
        return abs(length[normalAxis] - abs(x[i] - x[j])) <= extent[normalAxis]
    }
}
