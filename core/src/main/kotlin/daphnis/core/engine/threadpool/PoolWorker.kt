package daphnis.core.engine.threadpool

import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.WallContact
import daphnis.core.collision.contactTime
import daphnis.core.engine.CollisionStep
import daphnis.core.engine.NeighbourSearch
import daphnis.core.engine.StepLimits
import daphnis.core.queue.EventStore
import daphnis.core.search.CellRuns
import daphnis.core.search.Grid
import daphnis.core.search.Reach
import daphnis.core.search.RowBounds

/**
 * What each sphere was before its last collision. A row is written by whoever processes the sphere and read under the
 * same rule as the state.
 */
internal class Trails {
    /** Rows like those of the step; meaningful for spheres that have collided. */
    var rows = DoubleArray(0)
        private set

    /** By slot: how often it has collided at time 0, when the local time does not tell: 0, 1, or 2 for more often. */
    var atZero = ByteArray(0)
        private set

    /** Whether the last collision was taken before its turn. */
    var early = BooleanArray(0)
        private set

    /** Slot of the partner in the last collision, negative for a wall. */
    var partner = IntArray(0)
        private set

    fun reset(size: Int) {
        if (atZero.size < size) {
            early = BooleanArray(size)
            partner = IntArray(size)
            rows = DoubleArray(size * STRIDE)
            atZero = ByteArray(size)
        } else {
            atZero.fill(0)
        }
    }
}

/** What one thread of the pool has to itself, and what it does with a collision. */
internal class PoolWorker(
    private val rows: StepRows,
    private val grid: Grid,
    private val bounds: RowBounds,
    private val walls: WallContact,
    private val reach: Reach,
    private val trails: Trails,
    private val limits: StepLimits,
) {
    val found = EventStore()
    val taken = Taken()
    val record = CollisionRecord()
    var collisions = 0L
        private set
    var wallCollisions = 0L
        private set
    var guarded = 0L
        private set

    private val search = NeighbourSearch(rows, grid, found, bounds)
    private val near = CellRuns(grid, bounds)
    private var sourceLaw: CollisionLaw? = null
    private var law = CollisionLaw({ 1.0 })

    fun prepare(step: CollisionStep) {
        found.clear()
        record.clear()
        collisions = 0
        wallCollisions = 0
        guarded = 0
        search.prepare(step.duration)
        if (sourceLaw !== step.law) {
            sourceLaw = step.law
            law = step.law.forAnotherWorker()
        }
    }

    /** Finds what spheres [from] until [to] can hit before anybody has moved. */
    fun searchStart(from: Int, to: Int, duration: Double) {
        search.queueStart(from, to)
        if (walls.present) for (slot in from until to) findWalls(slot, duration)
    }

    /** How the processing of [taken] ended. */
    enum class Outcome { DONE, OUTRUN, TOO_LATE }

    /** Slot of the sphere that outran the bound, when one did. */
    var outrunner = -1
        private set

    /** Processes [taken]; what its spheres can now hit is in [found]. */
    fun process(step: CollisionStep): Outcome {
        found.clear()
        val first = taken.first
        val second = taken.second
        val time = taken.time
        leaveTrail(first, time)
        if (second >= 0) leaveTrail(second, time)
        if (second < 0) {
            walls.reflect(rows, first, WallContact.face(second), time)
            wallCollisions++
            limits.checkProgress(rows, first, second, time)
            return goOn(step, first, time, NOBODY)
        }
        if (law.collide(rows, first, second, taken.image, grid.images, time)) {
            collisions++
            if (law.guarded) guarded++
            if (step.record != null) record.add(time, rows.id[first], rows.id[second], law)
        }
        limits.checkProgress(rows, first, second, time)
        val outcome = goOn(step, first, time, NOBODY)
        return if (outcome == Outcome.DONE) goOn(step, second, time, first) else outcome
    }

    /** Keeps the path that [slot] is about to leave; nobody asks for it before it has been in a collision. */
    private fun leaveTrail(slot: Int, time: Double) {
        rows.state.copyInto(trails.rows, slot * STRIDE, slot * STRIDE, (slot + 1) * STRIDE)
        trails.early[slot] = taken.isEarly
        trails.partner[slot] = if (slot == taken.first) taken.second else taken.first
        if (time == 0.0) trails.atZero[slot] = if (trails.atZero[slot] == NEVER_COLLIDED) ONCE else OFTEN
    }

    private fun goOn(step: CollisionStep, slot: Int, time: Double, except: Int): Outcome {
        if (reach.isOutrun(rows, slot, step.population, step.duration)) {
            outrunner = slot
            return Outcome.OUTRUN
        }
        // Who may see this sphere is not searching now; whoever does so later has the lock of the queue between.
        bounds.include(slot, rows, slot)
        if (!taken.isLate) {
            search.queueAll(slot, time, except)
        } else if (!searchLate(slot, time, except, step.duration)) {
            return Outcome.TOO_LATE
        }
        if (walls.present) findWalls(slot, step.duration)
        return Outcome.DONE
    }

    /**
     * The search of a sphere that may come too late: whoever it sees may have been in a collision after [time], and
     * then its path of before counts until that one.
     *
     * @return false when the sphere could have hit a path that has already been left
     */
    private fun searchLate(slot: Int, time: Double, except: Int, duration: Double): Boolean {
        val state = rows.state
        val images = grid.images
        val p = slot * STRIDE
        val rest = duration - time
        val runs = near.around(
            state[p],
            state[p + 1],
            state[p + 2],
            state[p + VX] * rest,
            state[p + VX + 1] * rest,
            state[p + VX + 2] * rest,
            state[p + RADIUS],
            time,
        )
        for (r in 0 until runs) {
            val image = near.image[r]
            for (other in near.from[r] until near.to[r]) {
                val q = other * STRIDE
                val isPartner = other == taken.first || other == taken.second
                if (!isPartner && state[q + TIME] >= time && wouldHaveHit(p, q, image, time)) return false
                if (other == except) continue
                val t = contactTime(rows, slot, other, image, images)
                if (t <= duration) found.add(t, slot, other, image)
            }
        }
        return true
    }

    /**
     * Whether the sphere in row [p], on its way since [time], could have hit the path that the one in row [q] left at
     * that time or later.
     */
    private fun wouldHaveHit(p: Int, q: Int, image: Int, time: Double): Boolean {
        val left = rows.state[q + TIME]
        if (left == 0.0 && trails.atZero[q / STRIDE] == NEVER_COLLIDED) return false
        // Its collision at this very moment had its turn: all that comes before it in the order of events had been
        // done.
        if (left == time && !trails.early[q / STRIDE]) return false
        // Or it was with one of the two that collide now, hence before.
        if (left == time && precedes(trails.partner[q / STRIDE])) return false
        // What came before the path left last is not known; then it is taken for a hit if it could be one.
        val isKnown = if (left == 0.0) {
            trails.atZero[q / STRIDE] == ONCE
        } else {
            trails.rows[q + TIME] < time || time == 0.0
        }
        if (!isKnown) return left > time || touches(p, q, image, time)
        return contactTime(rows.state, p, trails.rows, q, image, grid.images) <= left
    }

    private fun precedes(partner: Int): Boolean = partner == taken.first || (partner >= 0 && partner == taken.second)

    /** Whether two spheres, both at their places at [time], touch or overlap. */
    private fun touches(p: Int, q: Int, image: Int, time: Double): Boolean {
        val state = rows.state
        val images = grid.images
        val dx = state[q] - state[p] + (images.shift(image, 0) + images.slide(image, 0) * time)
        val dy = state[q + 1] - state[p + 1] + (images.shift(image, 1) + images.slide(image, 1) * time)
        val dz = state[q + 2] - state[p + 2] + images.shift(image, 2)
        val s = (state[p + RADIUS] + state[q + RADIUS]) * (1 + TOUCH)
        return dx * dx + dy * dy + dz * dz <= s * s
    }

    private fun findWalls(slot: Int, duration: Double) {
        for (face in 0 until WallContact.FACES) {
            val t = walls.time(rows, slot, face)
            if (t <= duration) found.add(t, slot, WallContact.partner(face), 0)
        }
    }

    private companion object {
        const val NOBODY = -1
        const val NEVER_COLLIDED: Byte = 0
        const val ONCE: Byte = 1
        const val OFTEN: Byte = 2

        /** Relative; what touches to round-off counts as touching. */
        const val TOUCH = 1e-9
    }
}
