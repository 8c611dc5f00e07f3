package daphnis.core.collision

import daphnis.core.boundary.Images
import daphnis.core.collision.StepRows.Companion.MARKS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import kotlin.math.sqrt

/**
 * What a collision does: brings both spheres to the moment of contact and exchanges momentum along the line of centres,
 * with coefficient ε of [restitution] unless [guard] makes the collision elastic. Spheres are smooth, so tangential
 * velocities do not change.
 *
 * A law is immutable, and the outcome is a pure function of the two states, so any number of workers can share one law.
 */
public class CollisionLaw @JvmOverloads constructor(
    public val restitution: Restitution,
    public val guard: CollapseGuard = NoGuard,
) {
    /**
     * Processes the collision of slots [first] and [second] at [time] (from the start of the step) and describes it in
     * [outcome].
     *
     * @return false when the spheres recede because of round-off at a grazing contact; then only their local times have
     *   changed, and [outcome] is as it was
     */
    public fun collide(
        rows: StepRows,
        first: Int,
        second: Int,
        image: Int,
        images: Images,
        time: Double,
        outcome: CollisionOutcome,
    ): Boolean {
        rows.advance(first, time)
        rows.advance(second, time)
        separation(rows, first, second, image, images, time) { dx, dy, dz ->
            val state = rows.state
            val p = first * STRIDE + VX
            val q = second * STRIDE + VX
            val ux = state[q] - state[p] + images.slide(image, 0)
            val uy = state[q + 1] - state[p + 1] + images.slide(image, 1)
            val uz = state[q + 2] - state[p + 2]
            val b = dx * ux + dy * uy + dz * uz
            if (b >= 0.0) return false
            val d2 = dx * dx + dy * dy + dz * dz
            outcome.separationX = dx
            outcome.separationY = dy
            outcome.separationZ = dz
            outcome.impactSpeed = -b / sqrt(d2)
            judge(rows, first, second, time, outcome)
            // The normal is d/|d|; b/d² · d is the approach velocity along it, without a square root that would cost
            // energy.
            exchange(rows, first, second, (1.0 + outcome.coefficient) * b / d2, outcome)
        }
        outcome.rank = 1 + maxOf(rows.rank(first), rows.rank(second))
        rows.marks[first * MARKS] = outcome.rank
        rows.marks[second * MARKS] = outcome.rank
        return true
    }

    /** Finds the coefficient of restitution from the impact speed and the guard. */
    private fun judge(rows: StepRows, first: Int, second: Int, time: Double, outcome: CollisionOutcome) {
        val speed = outcome.impactSpeed
        if (guard.needsLastCollision) {
            val last = rows.lastCollision
            outcome.guarded = guard.makesElastic(speed, time - last[first], time - last[second])
        } else {
            outcome.guarded = guard.makesElastic(speed, 0.0, 0.0)
        }
        outcome.coefficient = if (outcome.guarded) 1.0 else restitution.coefficient(speed)
        if (guard.needsLastCollision) {
            rows.lastCollision[first] = time
            rows.lastCollision[second] = time
        }
    }

    /** Changes the velocities by [factor] times the separation, shared by the masses. */
    private fun exchange(rows: StepRows, first: Int, second: Int, factor: Double, outcome: CollisionOutcome) {
        val state = rows.state
        val p = first * STRIDE + VX
        val q = second * STRIDE + VX
        val dx = outcome.separationX
        val dy = outcome.separationY
        val dz = outcome.separationZ
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        val f1 = factor * (m2 / (m1 + m2))
        val f2 = factor * (m1 / (m1 + m2))
        // Adding 0.0 turns −0.0 into +0.0. Otherwise the sign of a component that no impulse changes would depend on
        // which of the two was named first.
        state[p] = (state[p] + f1 * dx) + 0.0
        state[p + 1] = (state[p + 1] + f1 * dy) + 0.0
        state[p + 2] = (state[p + 2] + f1 * dz) + 0.0
        state[q] = (state[q] - f2 * dx) + 0.0
        state[q + 1] = (state[q + 1] - f2 * dy) + 0.0
        state[q + 2] = (state[q + 2] - f2 * dz) + 0.0
        // From the reduced mass, so that it is the same to the last bit from either side.
        outcome.impulse = (1.0 + outcome.coefficient) * outcome.impactSpeed * (m1 * m2 / (m1 + m2))
    }
}
