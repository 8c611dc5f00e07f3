package daphnis.core.cluster.bricks

/**
 * Indices in the order in which they were added, kept as runs of consecutive ones: a brick's own spheres are nearly one
 * run. Allocates only when it grows.
 */
internal class IndexRuns {
    private var ends = IntArray(INITIAL)

    /** Number of runs. */
    var runs = 0
        private set

    /** Number of indices. */
    var size = 0
        private set

    /** First index of [run]. */
    fun from(run: Int): Int = ends[2 * run]

    /** One past the last index of [run]. */
    fun to(run: Int): Int = ends[2 * run + 1]

    fun clear() {
        runs = 0
        size = 0
    }

    fun add(index: Int) {
        size++
        if (runs > 0 && ends[2 * runs - 1] == index) {
            ends[2 * runs - 1]++
            return
        }
        if (ends.size == 2 * runs) ends = ends.copyOf(4 * runs)
        ends[2 * runs] = index
        ends[2 * runs + 1] = index + 1
        runs++
    }

    /** Adds all indices [from] until [to], which do not follow those before. */
    fun addAll(from: Int, to: Int) {
        if (from == to) return
        add(from)
        size += to - from - 1
        ends[2 * runs - 1] = to
    }

    private companion object {
        const val INITIAL = 4
    }
}
