package daphnis.core.engine.threadpool

import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.separation
import daphnis.core.step.CollisionStep
import daphnis.core.step.Impact
import daphnis.core.step.PreparedStep

/**
 * The data which one thread of the pool has to itself, and how it processes a collision. No sphere that may see a
 * colliding sphere is searching at that moment. For a search that comes later, the lock of the queue lies between.
 */
internal class PoolWorker(prepared: PreparedStep, private val last: LastCollisions, val found: Findings = Findings()) :
    Impact(prepared, prepared.rows, found) {
    val taken = Taken()
    val record = CollisionRecord()

    /** Begins a new attempt at a step; its collisions are written to [record] when [step] wants them. */
    fun beginStep(step: CollisionStep) {
        begin(if (step.record == null) null else record)
        found.clear()
    }

    /** Finds what spheres [from] until [to] can hit before any sphere has moved. */
    fun searchStart(from: Int, to: Int) {
        candidates.start(from, to, found)
    }

    /** Processes [taken]; what is to be queued is in [found]. */
    fun processTaken(): End {
        found.clear()
        leaveTrail(taken.first)
        if (taken.second >= 0) leaveTrail(taken.second)
        return process(taken.time, taken.first, taken.second, taken.image)
    }

    /** Keeps the path that [slot] is about to leave; it is not read before the sphere has been in a collision. */
    private fun leaveTrail(slot: Int) {
        rows.state.copyInto(last.rows, slot * STRIDE, slot * STRIDE, (slot + 1) * STRIDE)
        last.early[slot] = taken.isEarly
        last.partner[slot] = if (slot == taken.first) taken.second else taken.first
        if (taken.time == 0.0) last.atZero[slot] = if (last.atZero[slot] == NEVER_COLLIDED) ONCE else OFTEN
    }

    override fun search(place: Int, except: Int): Boolean {
        if (taken.isLate) return searchLate(place, except)
        return super.search(place, except)
    }

    /**
     * The search of a sphere that may come too late. A sphere that it sees may have had a collision at a later time,
     * and then that sphere's previous path counts until that collision.
     *
     * @return false when the sphere could have hit a path that has already been left
     */
    private fun searchLate(slot: Int, except: Int): Boolean {
        val state = rows.state
        val time = taken.time
        val isInTime = candidates.view(slot) { other, image ->
            val isAhead = state[other * STRIDE + TIME] >= time && other != taken.first && other != taken.second
            if (isAhead && wouldHaveHit(slot, other, image, time)) return@view false
            if (other != except) {
                val t = prepared.meetingTime(rows, slot, rows, other, image)
                if (t <= prepared.duration) found.add(t, slot, other, image)
            }
            true
        }
        if (isInTime) prepared.queueWalls(rows, slot, found)
        return isInTime
    }

    /**
     * Whether the sphere in [slot], on its way since [time], could have hit the path that [other] left at that time or
     * later.
     */
    private fun wouldHaveHit(slot: Int, other: Int, image: Int, time: Double): Boolean {
        val q = other * STRIDE
        val left = rows.state[q + TIME]
        if (left == 0.0 && last.atZero[other] == NEVER_COLLIDED) return false
        // Its collision at this very time was taken in its turn: all that come before it in the order of events had
        // been done.
        if (left == time && !last.early[other]) return false
        // Or it was with one of the two that collide now, and hence before this one.
        if (left == time && precedes(last.partner[other])) return false
        // The paths before the last one left are not known; if there could have been a hit, there counts as one.
        val isKnown = if (left == 0.0) {
            last.atZero[other] == ONCE
        } else {
            last.rows[q + TIME] < time || time == 0.0
        }
        if (!isKnown) return left > time || touches(slot, other, image, time)
        // What the pair remembers has not changed since: neither has met the other.
        return prepared.meetingTime(stateOf(slot, other), rows.state, slot * STRIDE, last.rows, q, image) <= left
    }

    private fun stateOf(slot: Int, other: Int) = prepared.stateOf(rows, slot, rows, other)

    private fun precedes(partner: Int): Boolean = partner == taken.first || (partner >= 0 && partner == taken.second)

    /** Whether two spheres, both at their places at [time], touch or overlap. */
    private fun touches(slot: Int, other: Int, image: Int, time: Double): Boolean {
        val contact = rows.state[slot * STRIDE + RADIUS] + rows.state[other * STRIDE + RADIUS]
        val s = contact * prepared.grid.swelling * (1 + TOUCH)
        return separation(rows, slot, other, image, prepared.grid.images, time) { dx, dy, dz ->
            dx * dx + dy * dy + dz * dz <= s * s
        }
    }

    private companion object {
        const val NEVER_COLLIDED: Byte = 0
        const val ONCE: Byte = 1
        const val OFTEN: Byte = 2

        /** Relative; spheres which touch to within round-off count as touching. */
        const val TOUCH = 1e-9
    }
}
