package daphnis.core.engine.horizon

import daphnis.core.collision.StepRows
import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.TIME
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.collision.soonestContact
import daphnis.core.space.Images

/**
 * The giants of a step, which hardly change their paths when they meet the small spheres around them. Searching anew
 * for a moonlet whenever a ring particle falls on it, and asking all that lie there, would be most of the work.
 *
 * - As long as the path of a giant stays within the deviation of its line until the end of the step, or window, it
 *   **keeps the line**: what is filed of it holds, and only those that have been asked in this step have to be asked
 *   again. All of these are filed under a later step as well, where there is one in which they may touch.
 * - Of these, most wait. A giant has a **course**, a path that it had not long ago, and is within half of
 *   [EpochFrame.tolerance] of it, or takes another. A pair waits for the moment before which the two cannot touch if
 *   the giant is on its course and larger by that tolerance. From then on it is **imminent**: only such pairs are asked
 *   whenever the giant has met another.
 *
 * Where paths are cut into pieces, for groups on several threads, giants are as other spheres.
 */
internal class SteadyGiants(
    private val space: EpochSpace,
    private val held: GroupSpheres,
    private val images: Images,
    private val pairs: DuePairs,
) {
    private val frame = space.frame
    private val lines = space.lines
    private val asked = AskedGiants(lines)

    /** Whether there are any that may keep their lines. */
    private var areAny = false

    /** Collisions in which giants have kept their lines, since the start. */
    var kept = 0L
        private set

    /** Those that have kept their lines in the present collision. */
    private var first = NOBODY
    private var second = NOBODY

    /** The course of a giant, and the state of another sphere. */
    private val course = DoubleArray(STRIDE)
    private val other = DoubleArray(STRIDE)

    /** Begins a step, or window. */
    fun begin(areCut: Boolean) {
        areAny = !areCut && frame.hasGiants
        if (areAny) asked.begin(space.spheres)
        forget()
    }

    /** The next collision begins. */
    fun forget() {
        first = NOBODY
        second = NOBODY
    }

    /** Whether [slot] has kept its line in the present collision. */
    fun hasKept(slot: Int): Boolean = slot != NOBODY && (slot == first || slot == second)

    /** The sphere in [slot] has the path at [p] of its rows from time [t] on. @return whether it keeps its line */
    fun keeps(slot: Int, p: Int, t: Double): Boolean {
        if (!areAny || !space.isGiant(slot)) return false
        if (!lines.isFollowed(slot, held.rows.state, p, t, frame.stepStart + frame.stepLimit - t)) return false
        kept++
        if (first == NOBODY) first = slot else second = slot
        // Before the other one looks for it.
        if (!asked.hasCourse(slot) || !isOnCourse(slot, held.rows.state, p)) take(slot, p)
        return true
    }

    /** The giant in [slot] takes its course along the path at [p] of the rows. */
    private fun take(slot: Int, p: Int) {
        asked.setCourse(slot, held.rows.state, p)
        asked.forEachPresent(slot) { e ->
            val areGiants = space.isGiant(asked.first(e)) && space.isGiant(asked.second(e))
            if (areGiants || !waits(slot, e)) asked.setImminent(slot, e)
        }
    }

    /** Whether one of the two is a giant that may keep its line. */
    fun haveOneOf(i: Int, j: Int): Boolean = areAny && (space.isGiant(i) || space.isGiant(j))

    /** Takes a pair of which [haveOneOf], and which has been asked. @return whether it waits */
    fun takes(i: Int, j: Int, code: Int): Boolean {
        val isFirst = space.isGiant(i)
        val isSecond = space.isGiant(j)
        // Two giants are imminent: each has a course, from which it may go.
        val mayWait = isFirst != isSecond
        return isFirst && note(i, i, j, code, mayWait) || isSecond && note(j, i, j, code, mayWait)
    }

    /** @return whether the pair waits */
    private fun note(giant: Int, i: Int, j: Int, code: Int, mayWait: Boolean): Boolean {
        val e = asked.add(giant, i, j, code)
        if (!asked.hasCourse(giant)) {
            val p = held.findState(giant, other)
            asked.setCourse(giant, held.found, p)
        }
        if (mayWait && waits(giant, e)) return true
        asked.setImminent(giant, e)
        return false
    }

    /** Has entry [e] wait for the moment before which the two cannot touch. @return false when that is now */
    private fun waits(giant: Int, e: Int): Boolean {
        val i = asked.first(e)
        val j = asked.second(e)
        val image = lines.spheresImage(asked.image(e), i, lines, j)
        asked.copyCourse(giant, course)
        course[RADIUS] += frame.tolerance
        val q = held.findState(if (giant == i) j else i, other)
        val its = held.found
        val time = soonestContact(course, 0, its, q, if (giant == i) image else Images.negated(image), images)
        if (time <= maxOf(course[TIME], its[q + TIME])) return false
        if (time <= frame.stepLimit) asked.wait(e, time)
        return true
    }

    /**
     * Asks all pairs that have waited until [time].
     *
     * @return whether there were any, so that another collision may be next
     */
    fun askUntil(time: Double): Boolean {
        if (!areAny) return false
        var isAny = false
        while (true) {
            val e = asked.takeUntil(time)
            if (e == AskedGiants.NONE) return isAny
            if (asked.isImminent(e) || !asked.holds(e)) continue
            isAny = true
            asked.setImminent(if (space.isGiant(asked.first(e))) asked.first(e) else asked.second(e), e)
            ask(e)
        }
    }

    private fun ask(e: Int) {
        val i = asked.first(e)
        val j = asked.second(e)
        val code = asked.image(e)
        pairs.queue(pairs.contact(i, j, code), i, j, code)
    }

    /** Asks all again, except slot [except], that may touch the giant in [slot] now, which has kept its line. */
    fun askAgain(slot: Int, except: Int) {
        asked.forEachImminent(slot) { e -> if (asked.first(e) != except && asked.second(e) != except) ask(e) }
        // Under which later step it and the walls are filed has not changed.
        if (frame.hasWalls) pairs.queueWalls(slot)
    }

    /** Whether the path at [p] of [state] is near the course of [giant] until the end of the step. */
    private fun isOnCourse(giant: Int, state: DoubleArray, p: Int): Boolean {
        asked.copyCourse(giant, course)
        val t = state[p + TIME]
        var now = 0.0
        var later = 0.0
        for (k in 0..2) {
            val off = state[p + k] - (course[k] + course[VX + k] * (t - course[TIME]))
            val then = off + (state[p + VX + k] - course[VX + k]) * (frame.stepLimit - t)
            now += off * off
            later += then * then
        }
        // Half of the tolerance, which leaves the other half for the rounding of everything.
        val most = frame.tolerance * frame.tolerance / 4
        return now <= most && later <= most
    }

    companion object {
        const val NOBODY = -1
    }
}
