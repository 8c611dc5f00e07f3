package daphnis.core.engine.horizon

import daphnis.core.step.PreparedStep

/**
 * Asks the pairs that are due whether they touch in the present step, and a sphere and the walls likewise: only
 * [contactTime][daphnis.core.collision.contactTime] decides that, from the numbers of the population, or of rows after
 * a collision. Collisions are queued; pairs that may touch in a later step only are filed in [calendar].
 */
internal class DuePairs(
    private val prepared: PreparedStep,
    private val space: EpochSpace,
    private val calendar: PairCalendar,
    private val held: GroupSpheres,
    private val sight: Sight,
    private val work: GroupWork,
) {
    private val frame = space.frame
    private val lines = space.lines
    val giants = SteadyGiants(space, held, prepared.images, this)

    /** Files slots [i] and [j], at the image [code] of the second line, under [step]. */
    fun file(step: Int, i: Int, j: Int, code: Int) {
        calendar.file(step, i, j, code, lines.version[i], sight.of(j).version[j])
    }

    /**
     * Queues the collision of two spheres if they touch in the present step, in this window of it; if they touch in no
     * window, files them under a later step. A sphere with itself stands for the sphere and the walls.
     */
    fun ask(i: Int, j: Int, code: Int) {
        if (i == j) return askWalls(i)
        val time = contact(i, j, code)
        if (giants.haveOneOf(i, j)) {
            // Whether it touches now may change as long as both keep their lines.
            fileLater(i, j, code, lines)
            if (giants.takes(i, j, code)) return
        } else if (time > frame.duration) {
            fileLater(i, j, code, lines)
        }
        queue(time, i, j, code)
    }

    /** When two spheres touch in the present step. */
    fun contact(i: Int, j: Int, code: Int, lines: Lines = this.lines): Double {
        work.asked++
        return held.contactTime(i, j, lines.spheresImage(code, i, lines, j), prepared.images)
    }

    /** Files two spheres under the first later step in which they may touch. */
    private fun fileLater(i: Int, j: Int, code: Int, lines: Lines) {
        val next = frame.step + 1
        if (next == frame.steps) return
        val touch = lines.touch(i, lines, j, code, next * frame.duration)
        if (touch > frame.end) return
        val due = maxOf(frame.stepAt(touch), next)
        if (due < frame.steps) calendar.file(due, i, j, code, lines.version[i], lines.version[j])
    }

    /** Whether two spheres touch in this window if they keep the lines they had when it began; files as [ask]. */
    fun wouldTouch(i: Int, j: Int, code: Int): Boolean {
        val touches = contact(i, j, code, space.before) <= frame.stepLimit
        if (!touches) fileLater(i, j, code, space.before)
        return touches
    }

    /** Queues the collision of two spheres at [time], if that is in this window of the step. */
    fun queue(time: Double, i: Int, j: Int, code: Int) {
        if (time > frame.stepLimit) return
        held.queue.add(time, held.placeOf(i), held.placeOf(j), lines.spheresImage(code, i, lines, j))
    }

    private fun askWalls(slot: Int) {
        queueWalls(slot)
        val next = frame.step + 1
        if (next == frame.steps) return
        val due = maxOf(frame.stepAt(lines.touchWall(slot, next * frame.duration)), next)
        if (due < frame.steps) file(due, slot, slot, 0)
    }

    /** Queues what the sphere in [slot] meets of walls in this window of the step. */
    fun queueWalls(slot: Int) {
        prepared.queueWalls(held.rows, held.placeOf(slot), held.queue, frame.stepLimit)
    }

    /**
     * Finds out when the sphere in [slot] may touch a wall, from time [from] on.
     *
     * @param isUnderWay whether it is asked at once if that is now
     */
    fun lookAtWalls(slot: Int, from: Double, isUnderWay: Boolean) {
        val due = frame.stepAt(lines.touchWall(slot, from))
        if (due > frame.step || !isUnderWay) {
            if (due < frame.steps) file(maxOf(due, frame.step), slot, slot, 0)
        } else {
            askWalls(slot)
        }
    }
}
