package daphnis.core.engine.horizon

import daphnis.core.parallel.RangeLoop

/**
 * Which group of an epoch has which spheres: neighbouring rows of cells, about as many spheres in each group. Spheres
 * that had no cell at the start of the epoch belong to the group in whose rows they are at its middle.
 */
internal class Shares {
    /** Number of groups. */
    var count = 1
        private set

    /** First slot of each group; the last entry is one past the last member. */
    private var first = intArrayOf(0, 0)
    private var groupOfOther = IntArray(0)

    private val members: Int get() = first[count]

    /** Divides the spheres of an epoch, whose cells and lines are laid out, into [groups]. */
    fun divide(groups: Int, cells: EpochCells, spheres: Int, loop: RangeLoop) {
        if (first.size < groups + 1) first = IntArray(groups + 1)
        count = groups
        first[groups] = cells.members
        val rows = cells.count[1] * cells.count[2]
        var row = 0
        for (g in 0 until groups) {
            val target = (cells.members.toLong() * g / groups).toInt()
            while (row < rows && cells.start[row * cells.count[0]] < target) row++
            first[g] = if (g == 0) 0 else cells.start[row * cells.count[0]]
        }
        val others = spheres - cells.members
        if (groupOfOther.size < others) groupOfOther = IntArray(others + others / 2)
        loop.run(others) { _, from, to ->
            for (k in from until to) {
                val row = cells.rowAtMiddle(cells.members + k)
                groupOfOther[k] = if (cells.members == 0) 0 else ownerOfMember(cells.start[row * cells.count[0]])
            }
        }
    }

    /** First member of [group], and one past its last. */
    fun firstOf(group: Int): Int = first[group]

    fun endOf(group: Int): Int = first[group + 1]

    /** The group that has [slot]. */
    fun ownerOf(slot: Int): Int = if (slot < members) ownerOfMember(slot) else groupOfOther[slot - members]

    private fun ownerOfMember(slot: Int): Int {
        var group = if (members == 0) 0 else minOf(slot.toLong() * count / members, count - 1L).toInt()
        while (group > 0 && slot < first[group]) group--
        while (group < count - 1 && slot >= first[group + 1]) group++
        return group
    }
}
