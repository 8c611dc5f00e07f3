package daphnis.core.engine.lists

import daphnis.core.growth.IntList
import daphnis.core.parallel.RangeLoop
import daphnis.core.search.CellAxes.Companion.AXES

/**
 * Gives many spheres new lists at one time, on several threads. What changes for a sphere is within two layers of cells
 * of where it is then: its cells, its list and those of its neighbours. So slabs of cells that are [THICK] layers thick
 * are taken side by side if there is another one between any two of them.
 */
internal class ListRenewal(private val field: ListField, private val loop: RangeLoop) {
    private val slabs = ArrayList<IntList>()

    /** Lists that were made anew since the start. */
    var renewed = 0L
        private set

    /** Gives the spheres of [slots], wherever they are at [time], new lists. */
    fun renewAlone(slots: IntList, time: Double) {
        renewed += slots.size
        for (k in 0 until slots.size) field.lists.refresh(slots[k], time)
    }

    /** The same for spheres that have not gone farther than their shells and skins. */
    fun renew(slots: IntList, time: Double) {
        val count = field.space.count
        val axis = (0 until AXES).maxBy { count[it] }
        // As many slabs as there is room for, and evenly many where the first is beside the last.
        val slabs = maxOf(1, count[axis] / THICK).let { if (it == 1) 1 else it / 2 * 2 }
        if (slots.size < FEW || slabs == 1) return renewAlone(slots, time)
        renewed += slots.size
        while (this.slabs.size < slabs) this.slabs.add(IntList())
        for (slab in this.slabs) slab.clear()
        for (k in 0 until slots.size) {
            val layer = field.lists.layerOf(slots[k], axis, time)
            this.slabs[(layer.toLong() * slabs / count[axis]).toInt()].add(slots[k])
        }
        for (first in 0..1) {
            loop.run(slabs / 2, 1) { _, from, to ->
                for (s in from until to) renewSlab(first + 2 * s, time)
            }
        }
    }

    private fun renewSlab(slab: Int, time: Double) {
        for (k in 0 until slabs[slab].size) field.lists.refresh(slabs[slab][k], time)
    }

    private companion object {
        const val THICK = 6

        /** So few are not worth waking a thread. */
        const val FEW = 64
    }
}
