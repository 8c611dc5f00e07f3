package daphnis.core.engine.bricks

import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity

/**
 * The spheres with which a brick computes, copied: its own first, those of its halo behind them, as they were at the
 * start of the step. The arrays keep their size from step to step.
 */
internal class BrickColumns : SphereColumns {
    override var size = 0
        private set
    private val numbers = Array(SphereQuantity.WIDTH) { DoubleArray(0) }
    override var id = IntArray(0)
        private set

    override fun column(place: Int): DoubleArray = numbers[place]

    /** Removes all spheres and makes room for [count]. */
    fun clear(count: Int) {
        size = 0
        if (id.size >= count) return
        val n = count + count / SPARE
        for (place in numbers.indices) numbers[place] = DoubleArray(n)
        // Assigned last, since its length says how many spheres there is room for: an allocation before it may have
        // failed.
        id = IntArray(n)
    }

    /** Appends the entries [indices] of [spheres], for which there is room. */
    fun add(spheres: SphereColumns, indices: IndexRuns) {
        for (run in 0 until indices.runs) add(spheres, indices.from(run), indices.to(run))
    }

    private fun add(spheres: SphereColumns, from: Int, to: Int) {
        for (place in numbers.indices) spheres.column(place).copyInto(numbers[place], size, from, to)
        spheres.id.copyInto(id, size, from, to)
        size += to - from
    }

    private companion object {
        /** One part in so many is room for more. */
        const val SPARE = 4
    }
}
