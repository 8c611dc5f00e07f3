package daphnis.core.search

import daphnis.core.boundary.Images

/** Runs of slots, each with the image of its spheres. The arrays grow and keep their size. */
public abstract class SlotRuns internal constructor() {
    /** First slot of each run. */
    public var from: IntArray = IntArray(INITIAL)
        private set

    /** One past the last slot of each run. */
    public var to: IntArray = IntArray(INITIAL)
        private set

    /** Image of the spheres in each run, see [Images]. */
    public var image: IntArray = IntArray(INITIAL)
        private set

    /** Number of runs. */
    protected var count: Int = 0

    /** Adds the run of the slots [first] until [end], unless it is empty. */
    protected fun addRun(first: Int, end: Int, code: Int) {
        if (first >= end) return
        if (count == from.size) grow()
        from[count] = first
        to[count] = end
        image[count] = code
        count++
    }

    private fun grow() {
        to = to.copyOf(count * 2)
        image = image.copyOf(count * 2)
        // Last, since its length says how many there is room for: an allocation before it may have failed.
        from = from.copyOf(count * 2)
    }

    private companion object {
        const val INITIAL = 64
    }
}
