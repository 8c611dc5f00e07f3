package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.RADIUS
import daphnis.core.collision.StepRows.Companion.STRIDE
import kotlin.math.sqrt

/** What a pair exchanges at an edge: a change of state and of the velocity along the line of centres. Keeps nothing. */
internal class EdgeExchange(val states: PairStates) {
    /**
     * Decides what happens to the pair in the slots [first] and [second] of [rows], which has come to an edge at
     * distance² [d2], with the product [b] of distance and relative velocity: the factor by which the separation
     * changes their velocities goes to [CollisionOutcome.factor], and whether they recede then to
     * [CollisionOutcome.outward].
     *
     * @return false when surfaces meet, of which the contact law decides
     */
    fun pass(rows: StepRows, first: Int, second: Int, b: Double, d2: Double, outcome: CollisionOutcome): Boolean {
        val state = states.of(rows, first, rows, second)
        val r1 = rows.state[first * STRIDE + RADIUS]
        val r2 = rows.state[second * STRIDE + RADIUS]
        val isOuter = states.isOuter(state, r1 + r2, d2)
        if (!isOuter && states.isContact(state)) return false
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        val mass = m1 * m2 / (m1 + m2)
        val cost = states.cost(state, isOuter, r1, r2)
        // b² is (v_n d)², so ½ μ v_n² ≥ cost is b² ≥ 2 cost d²/μ.
        val left = b * b - 2.0 * cost * d2 / mass
        outcome.forgetSurfaces()
        outcome.guarded = false
        if (left >= 0.0) {
            val after = if (isOuter) sqrt(left) else -sqrt(left)
            val next = states.next(state, isOuter)
            // (b − b′)/d² without cancellation: b² − b′² is 2 cost d²/μ.
            val sum = b + after
            outcome.factor = if (sum == 0.0) 0.0 else 2.0 * cost / mass / sum
            outcome.coefficient = if (b == 0.0) 0.0 else -after / b
            outcome.outward = isOuter
            outcome.rubbed = cost - (states.energy(next) - states.energy(state))
            outcome.edge = if (isOuter) CollisionOutcome.OUT else CollisionOutcome.IN
            states.put(rows, first, second, next)
        } else {
            outcome.factor = 2.0 * b / d2
            outcome.coefficient = 1.0
            outcome.outward = !isOuter
            outcome.edge = CollisionOutcome.BACK
        }
        outcome.impulse = -outcome.factor * sqrt(d2) * mass
        return true
    }

    /** Surfaces of the pair have met. */
    fun met(rows: StepRows, first: Int, second: Int) {
        val state = states.of(rows, first, rows, second)
        val next = states.next(state, isOuter = false)
        if (next != state) states.put(rows, first, second, next)
    }
}
