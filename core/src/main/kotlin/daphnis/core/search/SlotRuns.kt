package daphnis.core.search

import daphnis.core.growth.GrowingTable
import daphnis.core.space.Images

/** Runs of slots, each with the image of its spheres. The arrays grow and keep their size. */
public abstract class SlotRuns internal constructor() : GrowingTable() {
    /** First slot of each run. */
    public var from: IntArray = IntArray(0)
        private set

    /** One past the last slot of each run. */
    public var to: IntArray = IntArray(0)
        private set

    /** Image of the spheres in each run, see [Images]. */
    public var image: IntArray = IntArray(0)
        private set

    override fun resize(room: Int) {
        from = from.copyOf(room)
        to = to.copyOf(room)
        image = image.copyOf(room)
    }

    /** Adds the run of the slots [first] until [end], unless it is empty. */
    protected fun addRun(first: Int, end: Int, code: Int) {
        if (first >= end) return
        val k = append()
        from[k] = first
        to[k] = end
        image[k] = code
    }
}
