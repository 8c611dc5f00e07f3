package daphnis.core.engine.horizon

/**
 * Settles the lines that a group of spheres has got within an epoch: gives them versions, and looks whether the cells
 * of their spheres still hold them.
 *
 * @param newRoamers takes the spheres that have become roamers while groups work side by side
 * @param number the number of the group, by which versions differ from those of others
 * @param numbers how many groups there are
 */
internal class NewLines(
    private val space: EpochSpace,
    private val sight: Sight,
    private val newRoamers: Roamers,
    private val number: Int,
    private val numbers: Int,
) {
    private val lines = space.lines
    private val cells = space.cells
    private var lastVersion = 0

    /** Begins an epoch. */
    fun begin() {
        lastVersion = 0
    }

    /** Numbers for the versions of [count] new lines. @return the first */
    fun takeVersions(count: Int): Int {
        val first = lastVersion + 1
        lastVersion += count
        return first
    }

    /**
     * Gives the line in [slot], which is new from time [from] on, the [version] that was taken for it. Threads may call
     * this for different slots.
     *
     * @return whether the cell of its sphere holds it, or the epoch cannot go on; if not, [roam] is to follow
     */
    fun settleInCell(slot: Int, from: Double, version: Int): Boolean {
        lines.version[slot] = version * numbers + number
        if (lines.isLost) return true
        if (!cells.hasCell(slot)) return false
        lines.moveBack(slot, cells.imageAtCell(slot))
        return cells.holds(slot, from)
    }

    /** What is filed of the sphere in [slot] holds no longer. */
    fun outdate(slot: Int) {
        lines.version[slot] = takeVersions(1) * numbers + number
    }

    /** The sphere in [slot] has left its cell, or had none. See [Roamers.add] about [isFinal]. */
    fun roam(slot: Int, isFinal: Boolean) {
        lines.moveBack(slot, cells.imageInBox(lines, slot))
        if (sight.group == Sight.ALL) space.addRoamer(slot, isFinal) else newRoamers.add(slot)
    }
}
