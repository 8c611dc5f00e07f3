package daphnis.core.engine.islands

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionOutcome
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.WallContact
import daphnis.core.collision.contactTime
import daphnis.core.engine.islands.IslandField.Companion.ATTEMPT
import daphnis.core.engine.islands.IslandField.Companion.FREE
import daphnis.core.engine.islands.IslandField.Companion.OWNER
import daphnis.core.engine.islands.IslandField.Companion.PLACE
import daphnis.core.engine.islands.IslandField.Companion.TICKET
import daphnis.core.queue.EventSink
import java.lang.invoke.VarHandle

/** Says which spheres a worker may take into its islands. */
public fun interface ClaimRule {
    public fun mayClaim(slot: Int): Boolean
}

/**
 * One of the workers on an [IslandField]: finds potential collisions, grows islands, processes and checks them. What it
 * finds and does is in stores of its own. The methods are the phases of a window; [IslandCrew] has their order.
 *
 * @param crew all workers, this one included; looked at only to follow the paths of spheres in another worker's island
 */
public class IslandWorker internal constructor(
    private val field: IslandField,
    private val number: Int,
    private val crew: Array<IslandWorker?>,
) {
    internal val hints = Hints()
    internal val attempts = Attempts()
    internal val suspects = Suspects()

    /** Collisions of committed islands, in no order. */
    internal val record = CollisionRecord()
    private val tried = CollisionRecord()
    private val candidates = field.prepared.candidates()
    private val meetings = Meetings()

    private val members = Members()
    private val local = members.rows
    internal val seeder = Seeder(field, hints)
    internal val paths = PathCheck(field, members, attempts, suspects) { crew[it]!!.members }
    private val queue = IslandQueue(local)
    private val outcome = CollisionOutcome()

    /** Which spheres may join; null for any. */
    public var claimRule: ClaimRule? = null

    /** A sphere that the last island needed and [claimRule] refused, −1 when there was none. */
    public var refused: Int = FREE
        private set

    // Of the island being processed.
    private var root = FREE
    private var attempt = 0
    private var attemptIndex = 0

    /** For a new attempt at the step. */
    internal fun prepare() {
        hints.reset(field.duration, field.limits)
        record.clear()
        clearWindow()
    }

    private fun clearWindow() {
        attempts.clear()
        suspects.clear()
        members.clear(field.limits)
        tried.clear()
    }

    /** Finds every potential collision of the step that spheres [from] until [to] can have as they are at its start. */
    public fun searchStart(from: Int, to: Int) {
        candidates.start(from, to, hints)
    }

    /**
     * Makes seeds of the own hints of slices [from] to [to] that still hold, and puts whoever shares one into one
     * island.
     */
    public fun propose(from: Int, to: Int) {
        clearWindow()
        seeder.propose(from, to, claimRule)
    }

    /** Hangs the own seeds into the lists of their islands. */
    public fun group() {
        seeder.group()
    }

    /** Compares the paths of spheres that came near those of other islands. */
    public fun check() {
        paths.run()
    }

    /**
     * Roots of the islands that [processOwn] had to give up, and whom each needed: two numbers an island,
     * [givenUpCount] islands.
     */
    public var givenUp: IntArray = IntArray(INITIAL)
        private set
    public var givenUpCount: Int = 0
        private set

    /** Processes the islands that [group] found here first. */
    public fun processOwn() {
        process(seeder.roots, seeder.rootCount)
    }

    /**
     * Processes the islands of the first [count] of [roots]; those that need somebody whom [claimRule] refuses are left
     * and noted.
     */
    public fun process(roots: IntArray, count: Int) {
        givenUpCount = 0
        for (k in 0 until count) {
            if (process(roots[k])) continue
            if (field.stopped) return
            if ((givenUpCount + 1) * 2 > givenUp.size) givenUp = givenUp.copyOf(givenUp.size * 2)
            givenUp[givenUpCount * 2] = roots[k]
            givenUp[givenUpCount * 2 + 1] = refused
            givenUpCount++
        }
    }

    /**
     * Processes the island of [root] from its seeds to the end of the window.
     *
     * @return false when it was given up: the step is void or has failed, or [refused] says whom it needed and could
     *   not have; in that case it is as if it had not been tried
     */
    public fun process(root: Int): Boolean {
        this.root = root
        refused = FREE
        attemptIndex = attempts.begin(local.size, tried.size)
        attempt = field.attemptNumber(number, attemptIndex)
        queue.clear(field.limits)
        val seeds = field.seeds
        var s = field.seedHead[root]
        while (s != FREE) {
            val first = join(seeds.first[s])
            val second = seeds.second[s]
            queue.add(seeds.time[s], first, if (second < 0) second else join(second), seeds.image[s])
            s = seeds.next[s]
        }
        var collisions = 0L
        while (queue.pop()) {
            if (++collisions > field.limits.collisions) {
                throw IslandsTooLargeException("collisions of one island", field.limits.collisions)
            }
            if (field.stopped || !collide()) return false
            if (refused != FREE) {
                attempts.drop(attemptIndex)
                restore(attemptIndex)
                return false
            }
        }
        return true
    }

    /**
     * Takes [slot], which the island owns, into its rows; its place there. From then on others see by its local time,
     * NaN, that they cannot know where it is.
     */
    private fun join(slot: Int): Int {
        val p = slot * TICKET
        val ticket = field.ticket
        if (ticket[p + ATTEMPT] == attempt) return ticket[p + PLACE]
        val k = members.take(field.rows, slot)
        field.rows.state[slot * STRIDE + TIME] = Double.NaN
        ticket[p + ATTEMPT] = attempt
        ticket[p + PLACE] = k
        queue.join(k)
        return k
    }

    private fun collide(): Boolean {
        val time = queue.time
        val first = queue.first
        val second = queue.second
        members.leaveBehind(first)
        if (second < 0) {
            field.prepared.walls.reflect(local, first, WallContact.face(second), time)
            attempts.count(attemptIndex, Attempts.WALL_COLLISIONS)
            queue.removeAllOf(first)
            field.stepLimits.checkProgress(local, first, second, time)
            return goOn(first, NOBODY)
        }
        members.leaveBehind(second)
        if (field.prepared.step.law.collide(local, first, second, queue.image, field.grid.images, time, outcome)) {
            attempts.count(attemptIndex, Attempts.COLLISIONS)
            if (outcome.guarded) attempts.count(attemptIndex, Attempts.GUARDED)
            if (field.records) tried.add(time, local.id[first], local.id[second], outcome)
        }
        queue.removeAllOf(first)
        queue.removeAllOf(second)
        field.stepLimits.checkProgress(local, first, second, time)
        // The pair itself is searched once, from the first; the second leaves it out.
        return goOn(first, NOBODY) && goOn(second, members.slot(first))
    }

    private fun goOn(k: Int, except: Int): Boolean {
        if (field.prepared.isOutrun(local, k)) {
            field.outran(local, k)
            return false
        }
        field.prepared.bounds.include(members.slot(k), local, k)
        // What is read of others from here on is not older than the marks on this island's spheres and the bounds
        // widened for them.
        VarHandle.fullFence()
        candidates.around(local, k, except, meetings)
        return true
    }

    /** What a sphere at a place of this island can have: the time is NaN when the other belongs to an island. */
    private inner class Meetings : EventSink {
        override fun add(time: Double, first: Int, second: Int, image: Int) {
            if (time.isNaN()) {
                meetOwned(first, second, image)
            } else if (time > field.windowEnd) {
                hints.add(time, members.slot(first), second, image)
            } else if (second < 0) {
                queue.add(time, first, second, image)
            } else if (claimRule?.mayClaim(second) == false) {
                refused = second
            } else if (field.claim(second, root)) {
                queue.add(time, first, join(second), image)
            } else {
                suspects.add(members.slot(first), second, image, attemptIndex)
            }
        }
    }

    private fun meetOwned(k: Int, other: Int, image: Int) {
        if (field.owner(other) != root) {
            suspects.add(members.slot(k), other, image, attemptIndex)
            return
        }
        val place = field.place(other)
        val t = contactTime(local, k, place, image, field.grid.images)
        if (t <= field.windowEnd) {
            queue.add(t, k, place, image)
        } else if (t <= field.duration) {
            hints.add(t, members.slot(k), other, image)
        }
    }

    /** One past the last row of attempt [index]. */
    internal fun endOfRows(index: Int): Int = if (index + 1 < attempts.size) {
        attempts.firstRow(index + 1)
    } else {
        local.size
    }

    /** Makes it as if attempt [index] had not been. */
    internal fun restore(index: Int) {
        for (k in attempts.firstRow(index) until endOfRows(index)) {
            val slot = members.slot(k)
            field.rows.state[slot * STRIDE + TIME] = members.firstTime(k)
            // Who has seeds stays claimed, for whoever tries next.
            if (!field.isSeeded(slot)) field.ticket[slot * TICKET + OWNER] = FREE
            field.ticket[slot * TICKET + ATTEMPT] = 0
        }
    }

    /** Takes the results of the islands that are alive over into the state. */
    public fun commit() {
        for (index in 0 until attempts.size) {
            if (!attempts.isAlive(index)) continue
            for (k in attempts.firstRow(index) until endOfRows(index)) {
                field.rows.put(members.slot(k), local, k)
                field.release(members.slot(k))
            }
            if (field.records) {
                val end = if (index + 1 < attempts.size) attempts.firstRecord(index + 1) else tried.size
                record.addAll(tried, attempts.firstRecord(index), end)
            }
        }
    }

    /**
     * After all have committed: what suspects may do to one another later, each searched from when the other was not
     * yet known.
     */
    public fun hintSuspects() {
        for (k in 0 until suspects.size) {
            if (!attempts.isAlive(suspects.attempt(k))) continue
            val slot = suspects.slot(k)
            val other = suspects.other(k)
            val t = contactTime(field.rows, slot, other, suspects.image(k), field.grid.images)
            if (t > field.windowEnd && t <= field.duration) hints.add(t, slot, other, suspects.image(k))
        }
    }

    /** Adds what the islands that are alive have counted. */
    internal fun addTo(counters: CollisionCounters) {
        for (k in 0 until attempts.size) {
            if (!attempts.isAlive(k)) continue
            counters.collisions += attempts.counted(k, Attempts.COLLISIONS)
            counters.wallCollisions += attempts.counted(k, Attempts.WALL_COLLISIONS)
            counters.guardActivations += attempts.counted(k, Attempts.GUARDED)
        }
    }

    private companion object {
        const val NOBODY = -1
        const val INITIAL = 256
    }
}
