package daphnis.core.engine.islands

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.WallContact
import daphnis.core.collision.contactTime
import daphnis.core.collision.timeToContact
import daphnis.core.engine.NeighbourSearch
import daphnis.core.engine.ProgressWatch
import daphnis.core.engine.islands.IslandField.Companion.ATTEMPT
import daphnis.core.engine.islands.IslandField.Companion.FREE
import daphnis.core.engine.islands.IslandField.Companion.OWNER
import daphnis.core.engine.islands.IslandField.Companion.PLACE
import daphnis.core.engine.islands.IslandField.Companion.TICKET
import daphnis.core.search.CellRuns
import java.lang.invoke.VarHandle

/** Says which spheres a worker may take into its islands. */
public fun interface ClaimRule {
    public fun mayClaim(slot: Int): Boolean
}

/**
 * One of the workers on an [IslandField]: finds potential collisions, grows islands, processes and checks them. What it finds and does is in
 * stores of its own. The methods are the phases of a window; [IslandCrew] has their order.
 *
 * @param crew all workers, this one included; looked at only to follow the paths of spheres in another worker's island
 */
public class IslandWorker internal constructor(private val field: IslandField, private val number: Int, private val crew: Array<IslandWorker?>) {
    internal val hints = Hints()
    internal val attempts = Attempts()
    internal val suspects = Suspects()

    /** Collisions of committed islands, in no order. */
    internal val record = CollisionRecord()
    private val tried = CollisionRecord()
    private val paths = PathLog()
    private val start = NeighbourSearch(field.rows, field.grid, hints, field.bounds)
    private val near = CellRuns(field.grid, field.bounds)

    /** Copies of the spheres in this worker's islands, with their states now, by place. */
    private val local = StepRows()

    /** By place: the slot, and where the pieces of path before the last are kept. */
    private var slotOf = IntArray(INITIAL)
    private var older = IntArray(INITIAL)
    private val queue = IslandQueue(local)
    private val progress = ProgressWatch()
    private var sourceLaw: CollisionLaw? = null
    private var law = CollisionLaw({ 1.0 })

    /** Which spheres may join; null for any. */
    public var claimRule: ClaimRule? = null

    /** A sphere that the last island needed and [claimRule] refused, −1 when there was none. */
    public var refused: Int = FREE
        private set

    /** Roots of the islands that [group] found first. */
    internal var roots = IntArray(INITIAL)
    internal var rootCount = 0
        private set

    /** Pairs of roots whose islands [check] found to touch; the second is −1 for a sphere of no island. */
    internal var conflicts = IntArray(INITIAL)
    internal var conflictCount = 0
        private set

    private var seedsFrom = 0
    private var seedsTo = 0

    /** The own seeds that concern spheres which [claimRule] does not allow. */
    internal var borderFrom = 0
        private set
    internal var borderTo = 0
        private set

    // Of the island being processed.
    private var root = FREE
    private var attempt = 0
    private var attemptIndex = 0

    /** For a new attempt at the step. */
    internal fun prepare() {
        hints.reset(field.duration)
        start.prepare(field.duration)
        record.clear()
        clearWindow()
        if (sourceLaw !== field.law) {
            sourceLaw = field.law
            law = field.law.forAnotherWorker()
        }
    }

    private fun clearWindow() {
        attempts.clear()
        suspects.clear()
        paths.clear()
        tried.clear()
        local.clear()
        rootCount = 0
    }

    /** Finds every potential collision of the step that spheres [from] until [to] can have as they are at its start. */
    public fun searchStart(from: Int, to: Int) {
        start.queueStart(from, to)
        if (!field.walls.present) return
        for (slot in from until to) {
            for (face in 0 until WallContact.FACES) {
                val t = field.walls.time(field.rows, slot, face)
                if (t <= field.duration) hints.add(t, slot, WallContact.partner(face), 0)
            }
        }
    }

    /** Makes seeds of the own hints of slices [from] to [to] that still hold, and puts whoever shares one into one island. */
    public fun propose(from: Int, to: Int) {
        clearWindow()
        var count = 0
        for (slice in from..to) count += hints.count(slice)
        val seeds = field.seeds
        val rule = claimRule
        seedsFrom = seeds.reserve(count)
        borderTo = seedsFrom + count
        borderFrom = borderTo
        var own = seedsFrom
        for (slice in from..to) {
            var hint = hints.head(slice)
            while (hint != FREE) {
                val first = hints.first(hint)
                val second = hints.second(hint)
                val image = hints.image(hint)
                val time = hints.time(hint)
                if (time == timeOf(first, second, image)) {
                    val isOwn = rule == null || (rule.mayClaim(first) && (second < 0 || rule.mayClaim(second)))
                    val s = if (isOwn) own++ else --borderFrom
                    seeds.time[s] = time
                    seeds.first[s] = first
                    seeds.second[s] = second
                    seeds.image[s] = image
                    if (isOwn && second >= 0) field.union(first, second)
                }
                hint = hints.next(hint)
            }
        }
        seedsTo = own
    }

    private fun timeOf(first: Int, second: Int, image: Int): Double =
        if (second < 0) field.walls.time(field.rows, first, WallContact.face(second)) else contactTime(field.rows, first, second, image, field.grid.images)

    /** Hangs the own seeds into the lists of their islands. */
    public fun group() {
        val seeds = field.seeds
        val ticket = field.ticket
        for (s in seedsFrom until seedsTo) {
            val root = field.find(seeds.first[s])
            ticket[seeds.first[s] * TICKET + OWNER] = root
            if (seeds.second[s] >= 0) ticket[seeds.second[s] * TICKET + OWNER] = root
            if (field.hang(s, root)) {
                if (rootCount == roots.size) roots = roots.copyOf(rootCount * 2)
                roots[rootCount++] = root
            }
        }
        // In the order of memory, so that islands one after the other find their neighbourhoods in the cache.
        roots.sort(0, rootCount)
    }

    /** Roots of the islands that [processOwn] had to give up, and whom each needed: two numbers an island, [givenUpCount] islands. */
    public var givenUp: IntArray = IntArray(INITIAL)
        private set
    public var givenUpCount: Int = 0
        private set

    /** Processes the islands that [group] found here first. */
    public fun processOwn() {
        process(roots, rootCount)
    }

    /** Processes the islands of the first [count] of [roots]; those that need somebody whom [claimRule] refuses are left and noted. */
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
     * @return false when it was given up: the step is void or has failed, or [refused] says whom it needed and could not have; in that case it
     *   is as if it had not been tried
     */
    public fun process(root: Int): Boolean {
        this.root = root
        refused = FREE
        attemptIndex = attempts.begin(local.size, tried.size)
        attempt = field.attemptNumber(number, attemptIndex)
        queue.clear()
        progress.start(field.size, field.duration)
        val seeds = field.seeds
        var s = field.seedHead[root]
        while (s != FREE) {
            val first = join(seeds.first[s])
            val second = seeds.second[s]
            queue.add(seeds.time[s], first, if (second < 0) second else join(second), seeds.image[s])
            s = seeds.next[s]
        }
        while (queue.pop()) {
            progress.check(queue.time, field.start)
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
     * Takes [slot], which the island owns, into its rows; its place there. From then on others see by its local time, NaN, that they cannot
     * know where it is.
     */
    private fun join(slot: Int): Int {
        val p = slot * TICKET
        val ticket = field.ticket
        if (ticket[p + ATTEMPT] == attempt) return ticket[p + PLACE]
        val k = local.take(field.rows, slot)
        field.rows.state[slot * STRIDE + TIME] = Double.NaN
        ticket[p + ATTEMPT] = attempt
        ticket[p + PLACE] = k
        if (k >= slotOf.size) {
            slotOf = slotOf.copyOf(k * 2)
            older = older.copyOf(k * 2)
        }
        slotOf[k] = slot
        older[k] = PathLog.NONE
        queue.join(k)
        return k
    }

    private fun collide(): Boolean {
        val time = queue.time
        val first = queue.first
        val second = queue.second
        leaveBehind(first)
        if (second < 0) {
            field.walls.reflect(local, first, WallContact.face(second), time)
            attempts.count(attemptIndex, Attempts.WALL_COLLISIONS)
            queue.removeAllOf(first)
            return goOn(first, NOBODY)
        }
        leaveBehind(second)
        if (law.collide(local, first, second, queue.image, field.grid.images, time)) {
            attempts.count(attemptIndex, Attempts.COLLISIONS)
            if (law.guarded) attempts.count(attemptIndex, Attempts.GUARDED)
            if (field.records) tried.add(time, local.id[first], local.id[second], law)
        }
        queue.removeAllOf(first)
        queue.removeAllOf(second)
        // The pair itself is searched once, from the first; the second leaves it out.
        return goOn(first, NOBODY) && goOn(second, slotOf[first])
    }

    /** Keeps the present path of the sphere at place [k]; the one that it had at the start of the window too, of which the state loses the local time. */
    private fun leaveBehind(k: Int) {
        older[k] = paths.add(local.state, k * STRIDE, older[k])
    }

    private fun goOn(k: Int, except: Int): Boolean {
        if (field.reach.isOutrun(local, k, field.population, field.duration)) {
            field.outran(local, k)
            return false
        }
        field.bounds.include(slotOf[k], local, k)
        // What is read of others from here on is not older than the marks on this island's spheres and the bounds widened for them.
        VarHandle.fullFence()
        searchAround(k, except)
        if (field.walls.present) {
            for (face in 0 until WallContact.FACES) {
                val t = field.walls.time(local, k, face)
                val partner = WallContact.partner(face)
                if (t <= field.windowEnd) {
                    queue.add(t, k, partner, 0)
                } else if (t <= field.duration) {
                    hints.add(t, slotOf[k], partner, 0)
                }
            }
        }
        return true
    }

    /** Like [NeighbourSearch.queueAll]. Who is in an island has NaN for a local time, which no comparison dismisses. */
    private fun searchAround(k: Int, except: Int) {
        val own = local.state
        val state = field.rows.state
        val images = field.grid.images
        val p = k * STRIDE
        val time = own[p + TIME]
        val x = own[p]
        val y = own[p + 1]
        val z = own[p + 2]
        val vx = own[p + VX]
        val vy = own[p + VX + 1]
        val vz = own[p + VX + 2]
        val radius = own[p + RADIUS]
        val rest = field.duration - time
        val closing = -2.0 * (rest + field.duration * ROUNDING)
        val runs = near.around(x, y, z, vx * rest, vy * rest, vz * rest, radius, time)
        for (r in 0 until runs) {
            val image = near.image[r]
            val wx = images.slide(image, 0)
            val wy = images.slide(image, 1)
            val sx = images.shift(image, 0) + wx * time
            val sy = images.shift(image, 1) + wy * time
            val sz = images.shift(image, 2)
            var q = near.from[r] * STRIDE
            val end = near.to[r] * STRIDE
            while (q < end) {
                val vqx = state[q + VX]
                val vqy = state[q + VX + 1]
                val vqz = state[q + VX + 2]
                val elapsed = time - state[q + TIME]
                val ux = vqx - vx + wx
                val uy = vqy - vy + wy
                val uz = vqz - vz
                val dx = (state[q] + vqx * elapsed) - x + sx
                val dy = (state[q + 1] + vqy * elapsed) - y + sy
                val dz = (state[q + 2] + vqz * elapsed) - z + sz
                val b = dx * ux + dy * uy + dz * uz
                val s = radius + state[q + RADIUS]
                val c = dx * dx + dy * dy + dz * dz - s * s
                if (!(c > b * closing || b >= 0.0)) meet(k, q / STRIDE, except, image, time, timeToContact(dx, dy, dz, ux, uy, uz, s), b)
                q += STRIDE
            }
        }
    }

    /** The sphere at place [k] may touch [other] after [wait]; if [other] belongs to an island, [b] is NaN and nothing is known. */
    private fun meet(k: Int, other: Int, except: Int, image: Int, time: Double, wait: Double, b: Double) {
        if (other == except) return
        if (b.isNaN()) {
            meetOwned(k, other, image)
            return
        }
        val t = time + wait
        if (t > field.duration) return
        if (t > field.windowEnd) {
            hints.add(t, slotOf[k], other, image)
        } else if (claimRule?.mayClaim(other) == false) {
            refused = other
        } else if (field.claim(other, root)) {
            queue.add(t, k, join(other), image)
        } else {
            suspects.add(slotOf[k], other, image, attemptIndex)
        }
    }

    private fun meetOwned(k: Int, other: Int, image: Int) {
        if (field.owner(other) != root) {
            suspects.add(slotOf[k], other, image, attemptIndex)
            return
        }
        val place = field.place(other)
        val t = contactTime(local, k, place, image, field.grid.images)
        if (t <= field.windowEnd) {
            queue.add(t, k, place, image)
        } else if (t <= field.duration) {
            hints.add(t, slotOf[k], other, image)
        }
    }

    /** Compares the paths of the own suspects; the islands that touch go into [conflicts]. */
    public fun check() {
        conflictCount = 0
        for (k in 0 until suspects.size) {
            if (!attempts.isAlive(suspects.attempt(k))) continue
            val slot = suspects.slot(k)
            val other = suspects.other(k)
            if (!pathsTouch(field.place(slot), other, suspects.image(k))) continue
            if (conflictCount * 2 == conflicts.size) conflicts = conflicts.copyOf(conflicts.size * 2)
            conflicts[conflictCount * 2] = field.owner(slot)
            conflicts[conflictCount * 2 + 1] = field.owner(other)
            conflictCount++
        }
    }

    /** Whether any new piece of the path at place [k] touches any piece of that of [other] within the window. */
    private fun pathsTouch(k: Int, other: Int, image: Int): Boolean {
        var state = local.state
        var p = k * STRIDE
        var end = field.windowEnd
        var older = older[k]
        while (true) {
            // The last of the chain is what it began with; that was compared with the others' beginnings when seeds were made, and
            // with what they did since from their side.
            if (older < 0) return false
            if (touches(state, p, end, other, image)) return true
            end = state[p + TIME]
            state = paths.rows()
            p = PathLog.offset(older)
            older = paths.older(older)
        }
    }

    /** Whether the piece of path in the row at [p] of [state], which ends at [end], touches any piece of that of [other]. */
    private fun touches(state: DoubleArray, p: Int, end: Double, other: Int, image: Int): Boolean {
        val images = field.grid.images
        val attempt = field.attempt(other)
        if (attempt == 0) return contactTime(state, p, field.rows.state, other * STRIDE, image, images) <= end
        val worker = crew[field.workerOf(attempt)]!!
        val k = field.place(other)
        var otherState = worker.local.state
        var q = k * STRIDE
        var otherEnd = field.windowEnd
        var older = worker.older[k]
        while (true) {
            val t = contactTime(state, p, otherState, q, image, images)
            if (t <= end && t <= otherEnd) return true
            if (older < 0) return false
            otherEnd = otherState[q + TIME]
            otherState = worker.paths.rows()
            q = PathLog.offset(older)
            older = worker.paths.older(older)
        }
    }

    /** One past the last row of attempt [index]. */
    internal fun endOfRows(index: Int): Int = if (index + 1 < attempts.size) attempts.firstRow(index + 1) else local.size

    /** Makes it as if attempt [index] had not been. */
    internal fun restore(index: Int) {
        for (k in attempts.firstRow(index) until endOfRows(index)) {
            val slot = slotOf[k]
            var state = local.state
            var p = k * STRIDE
            var older = older[k]
            while (older >= 0) {
                state = paths.rows()
                p = PathLog.offset(older)
                older = paths.older(older)
            }
            field.rows.state[slot * STRIDE + TIME] = state[p + TIME]
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
                field.rows.put(slotOf[k], local, k)
                field.release(slotOf[k])
            }
            if (field.records) {
                val end = if (index + 1 < attempts.size) attempts.firstRecord(index + 1) else tried.size
                record.addAll(tried, attempts.firstRecord(index), end)
            }
        }
    }

    /** After all have committed: what suspects may do to one another later, each searched from when the other was not yet known. */
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
        const val ROUNDING = 1e-12
        const val INITIAL = 256
    }
}
