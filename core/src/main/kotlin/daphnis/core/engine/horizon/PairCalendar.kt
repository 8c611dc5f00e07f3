package daphnis.core.engine.horizon

import daphnis.core.growth.GrowingTable

/**
 * The pairs that may touch, filed under the step before which they cannot. An entry holds as long as neither sphere has
 * got a new line; that shows by the versions of the two. Stale entries count until the next epoch.
 */
internal class PairCalendar(private val lines: Lines) : GrowingTable() {
    private var heads = IntArray(0)
    private var counts = IntArray(0)
    private var data = IntArray(0)

    override fun resize(room: Int) {
        data = data.copyOf(room * WIDTH)
    }

    /** Forgets all, for an epoch of [steps] steps. */
    fun begin(steps: Int) {
        if (heads.size < steps) {
            counts = IntArray(steps)
            heads = IntArray(steps)
        }
        heads.fill(NONE)
        counts.fill(0)
        clear()
    }

    /**
     * Files slots [i] and [j], at the image [code] of the second line, under [step]. It holds as long as their lines
     * have the versions [version] and [other].
     */
    fun file(step: Int, i: Int, j: Int, code: Int, version: Int, other: Int) {
        val e = append()
        val p = e * WIDTH
        data[p] = i
        data[p + 1] = j
        data[p + 2] = code
        data[p + 3] = version
        data[p + 4] = other
        data[p + 5] = heads[step]
        heads[step] = e
        counts[step]++
    }

    /** Entries filed under [step], stale ones included. */
    fun count(step: Int): Int = counts[step]

    /**
     * Calls [use] for each pair that is filed under [step] and holds. Pairs may be filed under later steps meanwhile.
     */
    inline fun forEachDue(step: Int, use: (i: Int, j: Int, code: Int) -> Unit) {
        var e = first(step)
        while (e != NONE) {
            val p = e * WIDTH
            if (holds(p)) use(entry(p), entry(p + 1), entry(p + 2))
            e = entry(p + 5)
        }
    }

    fun first(step: Int): Int = heads[step]

    fun entry(p: Int): Int = data[p]

    fun holds(p: Int): Boolean = lines.version[data[p]] == data[p + 3] && lines.version[data[p + 1]] == data[p + 4]

    companion object {
        const val NONE = -1
        const val WIDTH = 6
    }
}

/** Whether these of an epoch of so many [spheres] have so many entries that it should end: they take memory. */
internal fun List<PairCalendar>.areFull(spheres: Int): Boolean =
    sumOf { it.size.toLong() } > MOST_ENTRIES * spheres + FEW_ENTRIES

private const val MOST_ENTRIES = 16L
private const val FEW_ENTRIES = 4096
