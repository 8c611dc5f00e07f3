package daphnis.core.initial

import daphnis.core.boundary.Box
import daphnis.core.parallel.RangeLoop
import kotlin.math.sqrt

/**
 * Places drawn ahead for the next spheres, and the verdicts that can be given for all of them at once.
 *
 * If no candidate were rejected, candidate c would be for the sphere of rank `first + c`. After a rejection the next
 * candidate is for the same sphere, which is larger or equal. So the radius of the sphere of candidate c lies between
 * those of the ranks `first + c` and `first`. Most verdicts are the same for all of these radii. Across walls the place
 * depends on the radius too, because whole spheres stay inside; there the verdict holds for all possible places.
 * Candidates without a verdict, or with a rival in the same block, are examined in order afterwards.
 *
 * @param capacity most candidates
 */
internal class CandidateBlock(
    private val space: OccupiedSpace,
    private val box: Box,
    private val walled: BooleanArray,
    capacity: Int,
) {
    private val axes = box.space.dimensions
    private val drawn = Array(3) { DoubleArray(capacity) }
    private val place = Array(3) { DoubleArray(capacity) }
    private val verdicts = Array(capacity) { Verdict.OPEN }
    private val hasRival = BooleanArray(capacity)

    // Candidates that may be accepted, by hash of their cell.
    private val heads = IntArray(Integer.highestOneBit(4 * capacity))
    private val next = IntArray(capacity)
    private val walls = (0 until axes).count { walled[it] }

    /** Draws [count] places. */
    fun draw(count: Int, random: SeededRandom) {
        for (c in 0 until count) {
            for (axis in 0 until axes) drawn[axis][c] = random.nextDouble()
        }
    }

    /** Where candidate [c] is along [axis] for a sphere of [radius]. */
    fun coordinate(c: Int, axis: Int, radius: Double): Double {
        if (axis >= axes) return 0.0
        val margin = if (walled[axis]) radius else 0.0
        val lower = box.lower(axis) + margin
        val upper = box.upper(axis) - margin
        return lower + (upper - lower) * drawn[axis][c]
    }

    /**
     * FREE or TAKEN if that holds whatever happens to the earlier candidates; OPEN if it depends on them. After
     * [judge].
     */
    fun verdict(c: Int): Verdict = if (verdicts[c] == Verdict.FREE && hasRival[c]) Verdict.OPEN else verdicts[c]

    /**
     * Judges the first [count] candidates on all workers of [loop]; the next sphere has rank [first], and all of them
     * are of one octave.
     */
    fun judge(first: Int, count: Int, loop: RangeLoop) {
        val most = space.radius(first)
        loop.run(count, GRAIN) { _, from, to ->
            for (c in from until to) {
                val least = space.radius(first + c)
                for (axis in 0..2) place[axis][c] = coordinate(c, axis, least)
                verdicts[c] = space.verdict(place[0][c], place[1][c], place[2][c], least, most, slack(least, most))
            }
        }
        val octave = space.octaveFor(most)
        link(octave, count)
        val slack = slack(space.radius(first + count - 1), most)
        loop.run(count, GRAIN) { _, from, to ->
            for (c in from until to) if (verdicts[c] == Verdict.FREE) hasRival[c] = hasRival(octave, c, most, slack)
        }
    }

    /** How far a place can be from that for the radius [least] if the radius may be up to [most]. */
    private fun slack(least: Double, most: Double): Double {
        if (walls == 0 || least == most) return 0.0
        var size = 0.0
        for (axis in 0 until axes) {
            if (walled[axis]) {
                size =
                    maxOf(size, Math.abs(box.lower(axis)), Math.abs(box.upper(axis)))
            }
        }
        return sqrt(walls.toDouble()) * (most - least) * (1 + ROUNDING) + ROUNDING * size
    }

    private fun link(octave: OccupiedSpace.Octave, count: Int) {
        heads.fill(-1)
        for (c in 0 until count) {
            if (verdicts[c] == Verdict.TAKEN) continue
            val slot = slot(octave.cell(place[0][c], place[1][c], place[2][c]))
            next[c] = heads[slot]
            heads[slot] = c
        }
    }

    private fun slot(cell: Int): Int = (cell * GOLDEN) ushr (Integer.numberOfLeadingZeros(heads.size) + 1)

    /** Whether an earlier candidate that is not rejected yet may overlap candidate [c]. */
    private fun hasRival(octave: OccupiedSpace.Octave, c: Int, most: Double, slack: Double): Boolean {
        val x = place[0][c]
        val y = place[1][c]
        val z = place[2][c]
        val reach = 2 * (most + slack)
        for (cz in octave.first(2, z, slack, reach)..octave.last(2, z, slack, reach)) {
            val layer = octave.wrap(2, cz) * octave.cells[1]
            for (cy in octave.first(1, y, slack, reach)..octave.last(1, y, slack, reach)) {
                val row = (layer + octave.wrap(1, cy)) * octave.cells[0]
                for (cx in octave.first(0, x, slack, reach)..octave.last(0, x, slack, reach)) {
                    if (hasRival(slot(row + octave.wrap(0, cx)), c, reach)) return true
                }
            }
        }
        return false
    }

    private fun hasRival(slot: Int, c: Int, reach: Double): Boolean {
        var other = heads[slot]
        while (other >= 0) {
            if (other < c) {
                val squared = space.distanceSquared(
                    place[0][other],
                    place[1][other],
                    place[2][other],
                    place[0][c],
                    place[1][c],
                    place[2][c],
                )
                if (squared < reach * reach) return true
            }
            other = next[other]
        }
        return false
    }

    private companion object {
        const val GRAIN = 256
        const val ROUNDING = 1e-12

        /** 2³² over the golden ratio, odd: spreads neighbouring cells. */
        const val GOLDEN = -0x61c88647
    }
}
