package daphnis.core.engine.islands

import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.WallContact
import daphnis.core.collision.contactTime
import daphnis.core.collision.timeToContact
import daphnis.core.engine.islands.IslandBoard.Companion.FREE
import daphnis.core.queue.EventHeap
import daphnis.core.search.CellRuns

/**
 * Grows the islands of one worker: processes each from its seeds to the end of the window, on copies of its rows, and
 * takes in spheres of no island that it hits.
 *
 * @param number that of the worker
 */
internal class Grower(private val field: IslandField, private val number: Int, private val stores: WorkerStores) {
    private val board = field.board
    private val near = CellRuns(field.grid, field.bounds)
    private val hints = stores.hints
    private val members = stores.members
    private val local = members.rows
    private val queue = EventHeap()
    private var sourceLaw: CollisionLaw? = null
    private var law = CollisionLaw({ 1.0 })

    /** Which spheres may join; null for any. */
    var claimRule: ClaimRule? = null

    /** A sphere that the last island needed and [claimRule] refused, −1 when there was none. */
    var refused = FREE
        private set

    // Of the island being processed.
    private var root = FREE
    private var attempt = 0
    private var index = 0

    /** For a new attempt at the step. */
    fun prepare() {
        if (sourceLaw !== field.law) {
            sourceLaw = field.law
            law = field.law.forAnotherWorker()
        }
    }

    /**
     * Processes the island of [root] from its seeds to the end of the window.
     *
     * @return false when it was given up: the step is void or has failed, or [refused] says whom it needed and could
     *   not have; in that case it is as if it had not been tried
     */
    fun process(root: Int): Boolean {
        begin(root)
        var collisions = 0L
        while (queue.pop()) {
            field.limits.checkIsland(++collisions, queue.store.size)
            if (field.stopped || !collide()) return false
            if (refused != FREE) {
                stores.attempts.drop(index)
                giveBack(index)
                return false
            }
        }
        return true
    }

    /** Begins an attempt at the island of [root] with the spheres of its seeds. */
    private fun begin(root: Int) {
        this.root = root
        refused = FREE
        index = stores.attempts.begin(local.size, stores.tried.size)
        attempt = board.attemptNumber(number, index)
        queue.reset(field.duration, local.id, 0)
        val seeds = board.seeds.store
        var s = board.firstSeed(root)
        while (s != FREE) {
            val first = join(seeds.first(s))
            val second = seeds.second(s)
            queue.add(seeds.time(s), first, if (second < 0) second else join(second), seeds.image(s))
            s = seeds.link(s)
        }
    }

    /** Takes [slot], which the island owns, into its rows; its place there. */
    private fun join(slot: Int): Int {
        if (board.attempt(slot) == attempt) return board.place(slot)
        val k = members.take(field.rows, slot)
        board.take(slot, root, attempt, k)
        queue.include(k, local.id)
        return k
    }

    /** Makes it as if the own attempt [index] had not been. */
    fun giveBack(index: Int) {
        for (k in stores.attempts.firstRow(index) until stores.endOfRows(index)) {
            board.giveBack(members.slot(k), members.firstTime(k))
        }
    }

    private fun collide(): Boolean {
        val time = queue.time
        val first = queue.first
        val second = queue.second
        members.leaveBehind(first)
        if (second < 0) {
            field.walls.reflect(local, first, WallContact.face(second), time)
            stores.attempts.count(index, Attempts.WALL_COLLISIONS)
            queue.removeAllOf(first)
            field.stepLimits.checkProgress(local, first, second, time)
            return goOn(first, NOBODY)
        }
        members.leaveBehind(second)
        if (law.collide(local, first, second, queue.image, field.grid.images, time)) {
            stores.attempts.count(index, Attempts.COLLISIONS)
            if (law.guarded) stores.attempts.count(index, Attempts.GUARDED)
            if (field.records) stores.tried.add(time, local.id[first], local.id[second], law)
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
        // The marks on this island's spheres, and the bounds widened for them.
        board.announce()
        searchAround(k, except)
        if (field.walls.present) searchWalls(k)
        return true
    }

    private fun searchWalls(k: Int) {
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
        } else if (board.claim(other, root)) {
            queue.add(t, k, join(other), image)
        } else {
            stores.suspects.add(members.slot(k), other, image, index)
        }
    }

    private fun meetOwned(k: Int, other: Int, image: Int) {
        if (board.owner(other) != root) {
            stores.suspects.add(members.slot(k), other, image, index)
            return
        }
        val place = board.place(other)
        val t = contactTime(local, k, place, image, field.grid.images)
        if (t <= field.windowEnd) {
            queue.add(t, k, place, image)
        } else if (t <= field.duration) {
            hints.add(t, members.slot(k), other, image)
        }
    }

    private companion object {
        const val NOBODY = -1
        const val ROUNDING = 1e-12
    }
}
