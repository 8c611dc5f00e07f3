package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.merging.MergeRule
import daphnis.core.population.Population
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import kotlin.math.abs
import kotlin.math.max
import kotlin.math.sqrt

/**
 * What a merger does to the two rows: one sphere lives on in the row of the larger, and the other row is dead until the
 * end of the step: at rest so [far away][GONE] that nothing can touch it, so searches need not know. [removeGone] then
 * removes it. Keeps nothing.
 *
 * @param momentFactor moment of inertia over mass · radius²
 */
internal class Merging(private val rule: MergeRule, private val momentFactor: Double) {
    /**
     * Merges the spheres in the slots [first] and [second] of [rows], which touch and approach and are described in
     * [outcome], if the rule says so. Then [CollisionOutcome.gone] is the slot of the dead row.
     *
     * @return whether they merged
     */
    fun take(rows: StepRows, first: Int, second: Int, outcome: CollisionOutcome): Boolean {
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        val mass = m1 + m2
        val distance = rows.state[first * STRIDE + RADIUS] + rows.state[second * STRIDE + RADIUS]
        val speed2 = outcome.ux * outcome.ux + outcome.uy * outcome.uy + outcome.uz * outcome.uz
        if (!rule.merges(sqrt(speed2), mass, distance)) return false
        val staysFirst = isKept(rows, first, second)
        val stays = if (staysFirst) first else second
        val goes = if (staysFirst) second else first
        // From the one that stays to the other: exact either way, since exchanging them negates both.
        val sign = if (staysFirst) 1.0 else -1.0
        val share = (if (staysFirst) m2 else m1) / mass
        val reduced = m1 * m2 / mass
        val before = if (rows.hasSpin) turned(rows, first) + turned(rows, second) else 0.0
        if (rows.hasSpin) turn(rows, stays, goes, reduced, mass, outcome)
        val state = rows.state
        val p = stays * STRIDE
        val q = goes * STRIDE
        val r = state[p + RADIUS]
        val other = state[q + RADIUS]
        move(state, p, sign * share, outcome)
        state[p + RADIUS] = StrictMath.cbrt(r * r * r + other * other * other)
        rows.mass[stays] = mass
        val after = if (rows.hasSpin) turned(rows, stays) else 0.0
        bury(rows, goes)
        outcome.gone = goes
        // ε = 0 takes what the normal component had; the rest went with the tangential one and into spin.
        outcome.coefficient = 0.0
        outcome.guarded = false
        outcome.forgetSurfaces()
        val normal = outcome.impactSpeed
        outcome.rubbed = max(0.0, 0.5 * reduced * (speed2 - normal * normal)) + (before - after)
        outcome.impulse = outcome.impactSpeed * reduced
        return true
    }

    /** Whether the sphere in slot [first] is the larger, of two as large the heavier, of equals that of the lower id. */
    private fun isKept(rows: StepRows, first: Int, second: Int): Boolean {
        val r1 = rows.state[first * STRIDE + RADIUS]
        val r2 = rows.state[second * STRIDE + RADIUS]
        if (r1 != r2) return r1 > r2
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        return if (m1 != m2) m1 > m2 else rows.id[first] < rows.id[second]
    }

    private fun move(state: DoubleArray, p: Int, share: Double, outcome: CollisionOutcome) {
        state[p] = state[p] + share * outcome.separationX + 0.0
        state[p + 1] = state[p + 1] + share * outcome.separationY + 0.0
        state[p + 2] = state[p + 2] + share * outcome.separationZ + 0.0
        state[p + VX] = state[p + VX] + share * outcome.ux + 0.0
        state[p + VX + 1] = state[p + VX + 1] + share * outcome.uy + 0.0
        state[p + VX + 2] = state[p + VX + 2] + share * outcome.uz + 0.0
    }

    /** Energy of rotation of [slot]. */
    private fun turned(rows: StepRows, slot: Int): Double {
        val squares = rows.wx[slot] * rows.wx[slot] + rows.wy[slot] * rows.wy[slot] + rows.wz[slot] * rows.wz[slot]
        return 0.5 * inertia(rows, slot) * squares
    }

    private fun inertia(rows: StepRows, slot: Int): Double {
        val r = rows.state[slot * STRIDE + RADIUS]
        return momentFactor * rows.mass[slot] * r * r
    }

    /** Gives [stays] the angular momentum of both about their centre of mass, that of their orbit with it. */
    private fun turn(rows: StepRows, stays: Int, goes: Int, reduced: Double, mass: Double, outcome: CollisionOutcome) {
        val r = rows.state[stays * STRIDE + RADIUS]
        val other = rows.state[goes * STRIDE + RADIUS]
        val radius = StrictMath.cbrt(r * r * r + other * other * other)
        val all = momentFactor * mass * radius * radius
        val a = inertia(rows, stays)
        val b = inertia(rows, goes)
        val dx = outcome.separationX
        val dy = outcome.separationY
        val dz = outcome.separationZ
        rows.wx[stays] =
            (a * rows.wx[stays] + b * rows.wx[goes] + reduced * (dy * outcome.uz - dz * outcome.uy)) / all + 0.0
        rows.wy[stays] =
            (a * rows.wy[stays] + b * rows.wy[goes] + reduced * (dz * outcome.ux - dx * outcome.uz)) / all + 0.0
        rows.wz[stays] =
            (a * rows.wz[stays] + b * rows.wz[goes] + reduced * (dx * outcome.uy - dy * outcome.ux)) / all + 0.0
    }

    private fun bury(rows: StepRows, slot: Int) {
        val p = slot * STRIDE
        for (axis in 0..2) {
            rows.state[p + axis] = GONE
            rows.state[p + VX + axis] = 0.0
        }
        if (rows.hasSpin) {
            rows.wx[slot] = 0.0
            rows.wy[slot] = 0.0
            rows.wz[slot] = 0.0
        }
    }

    companion object {
        /** A coordinate of what is gone. Its square is far from the largest number. */
        private const val GONE = 1e100

        /** How much larger than it is a sphere is looked for: one that merges with an equal one grows and moves so far. */
        const val ROOM: Double = 2.3

        /** By how much more, where that was too little. */
        const val MORE: Double = 1.3

        /** Whether the sphere at [place] of [rows] is one of several that have merged in this step. */
        fun hasMerged(rows: StepRows, place: Int, spheres: SphereColumns): Boolean =
            rows.state[place * STRIDE + RADIUS] != spheres.radius[rows.origin[place]]

        /**
         * Whether the sphere at [place] of [rows] goes farther in a step of [duration] than those that look for it know:
         * than the [bound] on the reach along each axis, and [room] times the radius that it had at the start.
         */
        fun isBeyond(
            rows: StepRows,
            place: Int,
            spheres: SphereColumns,
            bound: DoubleArray,
            room: Double,
            duration: Double,
        ): Boolean {
            val p = place * STRIDE
            val state = rows.state
            val origin = rows.origin[place]
            val rest = duration - state[p + StepRows.TIME]
            var now = 0.0
            var end = 0.0
            for (axis in 0..2) {
                val from = spheres.column(SphereQuantity.POSITION.place + axis)[origin]
                val here = max(0.0, abs(state[p + axis] - from) - bound[axis])
                val there = max(0.0, abs(state[p + axis] + state[p + VX + axis] * rest - from) - bound[axis])
                now += here * here
                end += there * there
            }
            val left = room * spheres.radius[origin] - state[p + RADIUS]
            return !(left >= 0 && max(now, end) <= left * left)
        }

        const val OWN_IMAGE: String =
            "a sphere that has grown by mergers touches its own image; take a larger box, or end the run earlier"

        /** As [take] is for pairs: a sphere that meets an image of itself, which slides, would merge with itself. */
        fun requireTwo(first: Int, second: Int): Unit = require(first != second) { OWN_IMAGE }

        /** Removes what is gone, after the step. */
        fun removeGone(population: Population) {
            val x = population.x
            if ((0 until population.size).any { x[it] == GONE }) population.retain { population.x[it] != GONE }
        }
    }
}
