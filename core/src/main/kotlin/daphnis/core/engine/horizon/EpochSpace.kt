package daphnis.core.engine.horizon

import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns

/** The spheres of an epoch as lines, and where they are. All of its workers share it. */
internal class EpochSpace(private val loop: RangeLoop) {
    val frame = EpochFrame()
    val lines = Lines(frame)

    /** The lines as they were when the step began; in use only where there are several groups. */
    val before = Lines(frame)
    val cells = EpochCells(frame, lines, loop)
    val roamers = Roamers(frame, lines)

    /** Roamers that are larger than any member. */
    val giants = Roamers(frame, lines)
    val shares = Shares()
    val limits = EpochLimits()

    /** Whether the epoch cannot go on, or is too much work. */
    val isOver: Boolean get() = lines.isLost || limits.isExceeded

    /** Number of spheres. */
    var spheres = 0
        private set

    /** Which of them are there, where they come and go; null where all are. */
    private var visits: Visits? = null

    /** Whether the sphere in [slot] is not there in this step. */
    fun isAway(slot: Int): Boolean = visits?.isHere(slot) == false

    /** Takes over the [visits] of an epoch that begins. */
    fun open(visits: Visits?) {
        this.visits = visits
    }

    /** From now on there are the first [count] of [all], those of them that [visits] say. */
    fun admit(all: SphereColumns, count: Int, visits: Visits, newLines: NewLines) {
        lines.grow(count)
        cells.admit(spheres, count)
        for (k in 0 until visits.left.size) newLines.outdate(visits.left[k])
        for (k in 0 until visits.entered.size) lines.forget(visits.entered[k])
        // A sphere that is larger than all were when the epoch began is seen as one that has grown.
        for (slot in spheres until count) lines.putRadius(slot, minOf(all.radius[slot], frame.largestRadius))
        spheres = count
    }

    /** Whether several groups process collisions. */
    val isShared: Boolean get() = loop.workers > 1

    /** The sphere in [slot], whose line is new, has no cell. See [Roamers.add] about [isFinal]. */
    fun addRoamer(slot: Int, isFinal: Boolean) {
        (if (isGiant(slot)) giants else roamers).add(slot, isFinal)
    }

    /** Whether the sphere in [slot] is larger than any member. */
    fun isGiant(slot: Int): Boolean = lines.radius(slot) > frame.memberRadius

    /** The step begins with the lines that there are. */
    fun settle(spheres: Int) {
        this.spheres = spheres
        if (isShared) loop.run(spheres) { _, from, to -> before.copyRange(lines, from, to) }
    }

    /** The step begins with the line in [slot], or that is known to all now. */
    fun settleLine(slot: Int) {
        if (isShared) before.copy(slot, lines, slot)
    }
}
