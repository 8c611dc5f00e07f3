package daphnis.core.engine.lists

import daphnis.core.collision.FAR
import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.contactTime
import daphnis.core.collision.waitUntilOutside
import daphnis.core.collision.waitUntilRoot
import daphnis.core.queue.compareTied
import daphnis.core.space.Images
import kotlin.math.max
import kotlin.math.sqrt

/**
 * The next event of each sphere: a collision of the present step, a moment before which it cannot collide, or one at
 * which it leaves its shell.
 *
 * **Why no collision is missed.** Of two spheres near each other, one was scanned last, when both had the paths that
 * they have now: whoever gets a new path is scanned. It cannot touch the other before its own event. So in order of
 * time over all spheres nothing comes before the earliest event, and it is enough that each pair is known to one of the
 * two. When an event turns out to be void, since the partner has another path by then, its sphere is scanned again.
 *
 * Predictions take spheres to be larger by [ListSpace.margin], so that they are no later than what
 * [daphnis.core.collision.contactTime] gives, whichever step it is asked in. It alone says whether and when two spheres
 * collide. What it says of a step holds until one of the two collides, and in that step only.
 */
internal class NextEvents(
    private val rows: StepRows,
    private val lists: NeighbourLists,
    private val space: ListSpace,
    private val images: Images,
) {
    val calendar = SphereCalendar(::isBefore)

    /** Four numbers per sphere: what its event is, version of the partner then, image of the partner, own version. */
    private var data = IntArray(0)

    /** No event of a sphere other than that with the partner of its event comes before this time. */
    private var others = DoubleArray(0)
    private var duration = 0.0

    /** Pairs whose product of distance and velocity is not below this recede for certain or miss one another. */
    private var receding = 0.0
    private var fastest = 0.0

    private val near = Approaching(rows, lists, images)

    fun reserve(spheres: Int) {
        calendar.reserve(spheres)
        if (others.size < spheres) {
            data = IntArray(4 * spheres)
            others = DoubleArray(spheres)
        }
        data.fill(0, 0, 4 * spheres)
        near.reserve()
    }

    /** Begins a step of [duration] in which no sphere is faster than [fastest] at first. */
    fun begin(duration: Double, fastest: Double) {
        this.duration = duration
        this.fastest = fastest
        receding = fastest * space.margin
    }

    /** The partner in the collision that is the event of [i]; negative when that is none. */
    fun partner(i: Int): Int = data[4 * i]

    fun image(i: Int): Int = data[4 * i + 2]

    fun isExit(i: Int): Boolean = data[4 * i] == EXIT

    /** Whether the partner of [i] has the path on which the collision was found. */
    fun isFresh(i: Int): Boolean = data[4 * i + 1] == data[4 * data[4 * i] + 3]

    /** The sphere [i] has another path, and is to be scanned. */
    fun bend(i: Int) {
        data[4 * i + 3]++
        val v = i * STRIDE + VX
        val state = rows.state
        val speed = sqrt(state[v] * state[v] + state[v + 1] * state[v + 1] + state[v + 2] * state[v + 2])
        if (speed > fastest) {
            fastest = speed
            receding = fastest * space.margin
        }
    }

    /** The places of [i] and its images have changed together, and nothing else: bounds stay, images do not. */
    fun wrap(i: Int) {
        data[4 * i + 3]++
        if (data[4 * i] <= HINT) data[4 * i] = BOUND
    }

    /** A step of [past] has ended: times count from the start of the next one. */
    fun shift(i: Int, past: Double) {
        calendar.time[i] -= past
        others[i] -= past
    }

    /** Whether the event of [i] is due at the start of the step. */
    fun isDue(i: Int): Boolean = calendar.time[i] <= 0.0

    /** The event of [i] stays what it was in the step before. */
    fun goOn(i: Int) {
        calendar.put(i, calendar.time[i])
    }

    /** Finds the next event of [i] from time [now] on, at which it follows the path that it has. */
    fun scan(i: Int, now: Double) {
        val count = near.find(i, now, space.margin, receding)
        var first = FAR
        var second = FAR
        var next = NONE
        for (l in 0 until count) {
            val c = near.c[l]
            val t = if (c <= 0.0) 0.0 else waitUntilRoot(near.b[l], c, near.discriminant[l])
            if (t < first) {
                second = first
                first = t
                next = near.entries[l]
            } else if (t < second) {
                second = t
            }
        }
        others[i] = now + second
        val p = 4 * i
        if (next == NONE) return putUnlessExit(i, now, FAR, BOUND)
        val entry = lists.entries[next]
        val j = entry and NeighbourLists.SPHERE
        val image = if (entry < 0) lists.codes[next] else 0
        data[p + 1] = data[4 * j + 3]
        data[p + 2] = image
        val bound = max(now, now + first)
        if (bound > duration) return putUnlessExit(i, now, bound, HINT - j)
        val time = contactTime(rows, i, j, image, images)
        if (time <= duration && time < others[i]) putUnlessExit(i, now, time, j) else scanAll(i, now)
    }

    /** The same as [scan] by asking for the exact time of each: where two are too near each other to tell otherwise. */
    private fun scanAll(i: Int, now: Double) {
        val count = near.find(i, now, space.margin, receding)
        var best = FAR
        var partner = BOUND
        var image = 0
        var bound = FAR
        for (l in 0 until count) {
            val k = near.entries[l]
            val j = lists.entries[k] and NeighbourLists.SPHERE
            val code = if (lists.entries[k] < 0) lists.codes[k] else 0
            val time = contactTime(rows, i, j, code, images)
            if (time > duration) {
                // Whatever is predicted, they do not touch in this step.
                val t = if (near.c[l] <= 0.0) 0.0 else now + waitUntilRoot(near.b[l], near.c[l], near.discriminant[l])
                if (t < bound) bound = t
            } else if (partner < 0 ||
                time < best ||
                time == best &&
                compareTied(rows.id, i, j, code, i, partner, image) < 0
            ) {
                best = time
                partner = j
                image = code
            }
        }
        others[i] = NEVER_ASKED
        val p = 4 * i
        if (partner < 0) return putUnlessExit(i, now, max(bound, duration), BOUND)
        data[p + 1] = data[4 * partner + 3]
        data[p + 2] = image
        putUnlessExit(i, now, best, partner)
    }

    /** The event of [i] is [what] at [at], unless it leaves its shell before. */
    private fun putUnlessExit(i: Int, now: Double, at: Double, what: Int) {
        val state = rows.state
        val reference = lists.reference
        val p = i * STRIDE
        val vx = state[p + VX]
        val vy = state[p + VX + 1]
        val vz = state[p + VX + 2]
        val elapsed = now - state[p + TIME]
        val ex = state[p] + vx * elapsed - reference[4 * i]
        val ey = state[p + 1] + vy * elapsed - reference[4 * i + 1]
        val ez = state[p + 2] + vz * elapsed - reference[4 * i + 2]
        val rest = at - now
        val fx = ex + vx * rest
        val fy = ey + vy * rest
        val fz = ez + vz * rest
        val most = space.shell * space.shell
        if (!(fx * fx + fy * fy + fz * fz <= most)) {
            val v2 = vx * vx + vy * vy + vz * vz
            val b = ex * vx + ey * vy + ez * vz
            val c = most - (ex * ex + ey * ey + ez * ez)
            val exit = now + waitUntilOutside(v2, b, c)
            if (exit < at) {
                data[4 * i] = EXIT
                calendar.put(i, exit)
                return
            }
        }
        data[4 * i] = what
        if (what >= 0) calendar.put(i, at) else calendar.putLater(i, at)
    }

    /** What was no more than a bound for [i] has come to be due at [now]. */
    fun due(i: Int, now: Double) {
        val what = data[4 * i]
        if (what > HINT || !becomesCollision(i, HINT - what)) scan(i, now)
    }

    /** Whether the event of [i] is the collision with the one that it was expected to touch first. */
    private fun becomesCollision(i: Int, j: Int): Boolean {
        if (data[4 * j + 3] != data[4 * i + 1]) return false
        val time = contactTime(rows, i, j, data[4 * i + 2], images)
        if (!(time <= duration && time < others[i])) return false
        val p = i * STRIDE
        val state = rows.state
        val rest = time - state[p + TIME]
        val isInShell = lists.isInShell(
            i,
            state[p] + state[p + VX] * rest,
            state[p + 1] + state[p + VX + 1] * rest,
            state[p + 2] + state[p + VX + 2] * rest,
        )
        if (!isInShell) return false
        data[4 * i] = j
        calendar.put(i, time)
        return true
    }

    /**
     * Scans those whose collision with [i] at [now] is void, so that of all collisions at this time the right one is
     * next.
     */
    fun scanVoid(i: Int, now: Double) {
        val from = i * lists.stride
        for (k in from + 1..from + lists.entries[from]) {
            val j = lists.entries[k] and NeighbourLists.SPHERE
            if (calendar.time[j] == now && data[4 * j] == i && !isFresh(j)) scan(j, now)
        }
    }

    /** Bounds come before collisions at their time. */
    private fun isBefore(a: Int, b: Int): Boolean {
        val first = data[4 * a]
        val second = data[4 * b]
        if (first < 0 || second < 0) return first < second
        return compareTied(rows.id, a, first, data[4 * a + 2], b, second, data[4 * b + 2]) < 0
    }

    private companion object {
        const val NONE = -1

        /** What an event is, if not the number of the partner in a collision: */
        const val BOUND = -1
        const val EXIT = -2

        /** A bound, with [HINT] less the number of the sphere that it may touch first. */
        const val HINT = -3
        const val NEVER_ASKED = -1.0
    }
}
