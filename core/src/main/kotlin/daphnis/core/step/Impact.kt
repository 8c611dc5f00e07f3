package daphnis.core.step

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows
import daphnis.core.queue.Schedule
import daphnis.core.wall.WallContact

/**
 * What an engine does with a potential collision whose time has come: it moves the two spheres to the moment of contact
 * and changes their velocities, counts, records, drops what the two had queued, checks the limits and the bounds of the
 * step, and queues what the two can touch now. Each worker has its own object.
 *
 * Engines differ in two things after a collision, and override the functions for them. An epoch follows all impacts too
 * ([changed]), and needs no bound ([outrun]). Bricks have a [Witness].
 *
 * | engine | [slotOf] a place | [search] from a place |
 * |---|---|---|
 * | serial, bricks | the place itself | always goes on |
 * | thread pool | the place itself | ends when the collision may have come too late |
 * | horizon | the slot whose row was made there | ends when the epoch does |
 * | islands | the slot that was copied there | ends when the island needs a sphere that it may not have |
 *
 * @param rows the rows of the colliding spheres, addressed by place: those of the step, or a worker's copies
 * @param schedule where potential collisions are queued, by place
 * @param witness says which collisions count here and follows all; null where all count
 */
internal open class Impact(
    protected val prepared: PreparedStep,
    protected val rows: StepRows,
    protected val schedule: Schedule,
    private val witness: Witness? = null,
) {
    /** Follows the impacts of spheres, some of which belong to another part of the step, which counts theirs. */
    interface Witness {
        /** A new attempt at the step begins. */
        fun begin()

        /** Whether this part of the step counts and records the collision of [first] with [second] of [rows]. */
        fun isCounted(rows: StepRows, first: Int, second: Int): Boolean

        /** Told of every impact, also of one that changes nothing; [second] is negative for a wall. */
        fun changed(rows: StepRows, first: Int, second: Int, time: Double)
    }

    /** How an impact ended. */
    enum class End {
        DONE,

        /** One of the two went beyond the bound: the step is to be redone, see [PreparedStep.enlarge]. */
        OUTRUN,

        /** A [search] ended the attempt. */
        VOID,
    }

    val candidates: Candidates = prepared.candidates()

    /** What has been counted since [begin]. */
    val counted = CollisionCounters()
    private val outcome = CollisionOutcome()
    private var record: CollisionRecord? = null

    /** Begins a new attempt at a step, whose collisions are written to [record]; null when they are not wanted. */
    open fun begin(record: CollisionRecord?) {
        this.record = record
        record?.clear()
        counted.clear()
        witness?.begin()
    }

    private fun isCounted(first: Int, second: Int) = witness?.isCounted(rows, first, second) ?: true

    /**
     * Processes the collision of [first] with [second], a wall's partner number when negative, at [time].
     *
     * @throws CollapseException or IllegalArgumentException when the step is beyond its limits, see [StepLimits]
     */
    fun process(time: Double, first: Int, second: Int, image: Int): End {
        val isWall = second < 0
        var gone = NOBODY
        if (isWall) {
            bounce(time, first, second)
        } else {
            gone = collide(time, first, second, image)
        }
        witness?.changed(rows, first, second, time)
        changed(first, second)
        schedule.removeAllOf(first)
        if (!isWall) schedule.removeAllOf(second)
        prepared.limits.checkProgress(rows, first, second, time)
        prepared.limits.checkWork(counted.collisions + counted.wallCollisions + counted.edgeEvents)
        val isOutrun = first != gone && prepared.isOutrun(rows, first) ||
            !isWall && second != gone && prepared.isOutrun(rows, second)
        if (isOutrun && !outrun(first, second)) return End.OUTRUN
        // The pair itself is searched once, from the first sphere; the second leaves it out.
        if (gone == first) return if (goOn(second, NOBODY)) End.DONE else End.VOID
        val isDone = goOn(first, NOBODY) && (isWall || second == gone || goOn(second, slotOf(first)))
        return if (isDone) End.DONE else End.VOID
    }

    private fun bounce(time: Double, first: Int, wall: Int) {
        val walls = prepared.walls
        walls.reflect(rows, first, WallContact.number(wall), time, outcome)
        if (!isCounted(first, first)) return
        counted.wallCollisions++
        if (walls.areDriven) record?.add(time, wall, rows.id[first], outcome)
    }

    /** @return which of the two is no more */
    private fun collide(time: Double, first: Int, second: Int, image: Int): Int {
        if (!prepared.step.law.collide(rows, first, second, image, prepared.images, time, outcome)) return NOBODY
        if (isCounted(first, second)) count(time, first, second)
        return outcome.gone
    }

    private fun count(time: Double, first: Int, second: Int) {
        if (outcome.edge == CollisionOutcome.CONTACT) counted.collisions++ else counted.edgeEvents++
        if (outcome.guarded) counted.guardActivations++
        if (outcome.isMerger) counted.mergers++
        record?.add(time, rows, first, second, outcome)
    }

    private fun goOn(place: Int, except: Int): Boolean {
        prepared.bounds.include(slotOf(place), rows, place)
        return search(place, except)
    }

    /** Told of every impact, also of one that changes nothing; [second] is negative for a wall. */
    protected open fun changed(first: Int, second: Int): Unit = Unit

    /**
     * Told that [first] or [second] went beyond the bound.
     *
     * @return whether the step can go on all the same, since the bound has been enlarged and no search relied on it
     */
    protected open fun outrun(first: Int, second: Int): Boolean = false

    /** The slot of the step whose sphere is at [place] of the rows. */
    protected open fun slotOf(place: Int): Int = place

    /**
     * Queues what the sphere at [place] can touch now, except slot [except].
     *
     * @return false to end the attempt at the step or island, see [End.VOID]
     */
    protected open fun search(place: Int, except: Int): Boolean {
        candidates.around(rows, place, except, schedule)
        return true
    }

    private companion object {
        const val NOBODY = -1
    }
}
