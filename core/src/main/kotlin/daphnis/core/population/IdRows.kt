package daphnis.core.population

import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop

/**
 * Mass, position and velocity of each sphere in the order of the ids, [WIDTH] numbers a sphere: one line of the cache.
 * The arrays of a population are read along memory and each sphere is written at once to its place, which costs a third
 * of a walk by id through seven arrays. Mass is 0 where there is no sphere.
 */
internal class IdRows {
    private val slots = IdSlots()

    /** The numbers, by place · [WIDTH] + column. */
    var rows = DoubleArray(0)
        private set

    /** Number of places. */
    val count: Int get() = slots.count

    /** Least and greatest position along the axis given to [gather]. */
    var least = 0.0
        private set
    var greatest = 0.0
        private set

    // Written before the loop, read by its workers.
    private var population: Population? = null
    private var axis = 0
    private val scatter = RangeBody { _, from, to -> scatter(from, to) }

    /** Takes over [population], by the threads of [loop]. */
    fun gather(population: Population, axis: Int, loop: RangeLoop) {
        slots.prepare(population)
        val needed = slots.count * WIDTH
        if (rows.size < needed) rows = DoubleArray(needed)
        if (slots.count > population.size) rows.fill(0.0, 0, needed)
        this.population = population
        this.axis = axis
        least = Double.POSITIVE_INFINITY
        greatest = Double.NEGATIVE_INFINITY
        loop.run(population.size, body = scatter)
        this.population = null
    }

    /** The first place of the ids from [leastId] on. */
    fun from(leastId: Int): Int = slots.from(leastId)

    private fun scatter(from: Int, to: Int) {
        val p = population!!
        val rows = rows
        val along = if (axis == 0) {
            p.x
        } else if (axis == 1) {
            p.y
        } else {
            p.z
        }
        var low = Double.POSITIVE_INFINITY
        var high = Double.NEGATIVE_INFINITY
        for (k in from until to) {
            val r = slots.of(p.id[k]) * WIDTH
            rows[r + MASS] = p.mass[k]
            rows[r + POSITION] = p.x[k]
            rows[r + POSITION + 1] = p.y[k]
            rows[r + POSITION + 2] = p.z[k]
            rows[r + VELOCITY] = p.vx[k]
            rows[r + VELOCITY + 1] = p.vy[k]
            rows[r + VELOCITY + 2] = p.vz[k]
            if (along[k] < low) low = along[k]
            if (along[k] > high) high = along[k]
        }
        synchronized(this) {
            if (low < least) least = low
            if (high > greatest) greatest = high
        }
    }

    companion object {
        const val WIDTH = 8
        const val MASS = 0
        const val POSITION = 1
        const val VELOCITY = 4
    }
}
