package daphnis.core.engine.islands

import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionRecord
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.WallContact
import daphnis.core.collision.contactTime
import daphnis.core.collision.timeToContact
import daphnis.core.engine.NeighbourSearch
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
    private val start = NeighbourSearch(field.rows, field.grid, hints, field.bounds)
    private val near = CellRuns(field.grid, field.bounds)

    private val members = Members()
    private val local = members.rows
    internal val seeder = Seeder(field, hints)
    internal val paths = PathCheck(field, members, attempts, suspects) { crew[it]!!.members }
    private val queue = IslandQueue(local)
    private var sourceLaw: CollisionLaw? = null
    private var law = CollisionLaw({ 1.0 })

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
        members.clear(field.limits)
        tried.clear()
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
            field.walls.reflect(local, first, WallContact.face(second), time)
            attempts.count(attemptIndex, Attempts.WALL_COLLISIONS)
            queue.removeAllOf(first)
            field.stepLimits.checkProgress(local, first, second, time)
            return goOn(first, NOBODY)
        }
        members.leaveBehind(second)
        if (law.collide(local, first, second, queue.image, field.grid.images, time)) {
            attempts.count(attemptIndex, Attempts.COLLISIONS)
            if (law.guarded) attempts.count(attemptIndex, Attempts.GUARDED)
            if (field.records) tried.add(time, local.id[first], local.id[second], law)
        }
        queue.removeAllOf(first)
        queue.removeAllOf(second)
        field.stepLimits.checkProgress(local, first, second, time)
        // The pair itself is searched once, from the first; the second leaves it out.
        return goOn(first, NOBODY) && goOn(second, members.slot(first))
    }

    private fun goOn(k: Int, except: Int): Boolean {
        if (field.reach.isOutrun(local, k, field.population, field.duration)) {
            field.outran(local, k)
            return false
        }
        field.bounds.include(members.slot(k), local, k)
        // What is read of others from here on is not older than the marks on this island's spheres and the bounds
        // widened for them.
        VarHandle.fullFence()
        searchAround(k, except)
        if (field.walls.present) {
            for (face in 0 until WallContact.FACES) {
                val t = field.walls.time(local, k, face)
                val partner = WallContact.partner(face)
                if (t <= field.windowEnd) {
                    queue.add(t, k, partner, 0)
                } else if (t <= field.duration) {
                    hints.add(t, members.slot(k), partner, 0)
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
                if (!(c > b * closing || b >= 0.0)) {
                    meet(
                        k,
                        q / STRIDE,
                        except,
                        image,
                        time,
                        timeToContact(dx, dy, dz, ux, uy, uz, s),
                        b,
                    )
                }
                q += STRIDE
            }
        }
    }

    /**
     * The sphere at place [k] may touch [other] after [wait]; if [other] belongs to an island, [b] is NaN and nothing
     * is known.
     */
    private fun meet(k: Int, other: Int, except: Int, image: Int, time: Double, wait: Double, b: Double) {
        if (other == except) return
        if (b.isNaN()) {
            meetOwned(k, other, image)
            return
        }
        val t = time + wait
        if (t > field.duration) return
        if (t > field.windowEnd) {
            hints.add(t, members.slot(k), other, image)
        } else if (claimRule?.mayClaim(other) == false) {
            refused = other
        } else if (field.claim(other, root)) {
            queue.add(t, k, join(other), image)
        } else {
            suspects.add(members.slot(k), other, image, attemptIndex)
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
        const val ROUNDING = 1e-12
        const val INITIAL = 256
    }
}
