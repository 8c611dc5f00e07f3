package daphnis.core.collision

import daphnis.core.boundary.Images
import daphnis.core.collision.StepRows.Companion.MARKS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import kotlin.math.sqrt

/**
 * What a collision does: brings both spheres to the moment of contact and exchanges momentum along the line of centres,
 * with coefficient ε of [restitution] unless [guard] makes the collision elastic. Spheres are smooth: tangential
 * velocities stand.
 *
 * The outcome is a pure function of the two states. One object serves one worker at a time: the result fields below are
 * its scratch.
 */
public class CollisionLaw(public val restitution: Restitution, public val guard: CollapseGuard = NoGuard) {
    /** Impact speed of the last collision. */
    public var impactSpeed: Double = 0.0
        private set

    /** Coefficient of restitution that the last collision had. */
    public var coefficient: Double = 1.0
        private set

    /** Momentum the last collision gave to the second sphere along the normal, ≥ 0; the first got the opposite. */
    public var impulse: Double = 0.0
        private set

    /**
     * Vector from the centre of the first to the centre of the second sphere at contact; likewise [separationY],
     * [separationZ].
     */
    public var separationX: Double = 0.0
        private set
    public var separationY: Double = 0.0
        private set
    public var separationZ: Double = 0.0
        private set

    /**
     * Place of the last collision among those at the same time that led to it, 1 for the first; see [StepRows.rank].
     */
    public var rank: Int = 0
        private set

    /** Whether the guard made the last collision elastic. */
    public var guarded: Boolean = false
        private set

    /** A law of the same physics for another worker. */
    public fun forAnotherWorker(): CollisionLaw = CollisionLaw(restitution, guard)

    /**
     * Processes the collision of slots [first] and [second] at [time] (from the start of the step).
     *
     * @return false when round-off at a grazing contact left them receding, so that nothing but their local times
     *   changed
     */
    public fun collide(rows: StepRows, first: Int, second: Int, image: Int, images: Images, time: Double): Boolean {
        val state = rows.state
        val p = first * STRIDE
        val q = second * STRIDE
        rows.advance(first, time)
        rows.advance(second, time)
        val dx = state[q] - state[p] + (images.shift(image, 0) + images.slide(image, 0) * time)
        val dy = state[q + 1] - state[p + 1] + (images.shift(image, 1) + images.slide(image, 1) * time)
        val dz = state[q + 2] - state[p + 2] + images.shift(image, 2)
        val ux = state[q + VX] - state[p + VX] + images.slide(image, 0)
        val uy = state[q + VX + 1] - state[p + VX + 1] + images.slide(image, 1)
        val uz = state[q + VX + 2] - state[p + VX + 2]
        val b = dx * ux + dy * uy + dz * uz
        if (b >= 0.0) return false
        val d2 = dx * dx + dy * dy + dz * dz
        val distance = sqrt(d2)
        impactSpeed = -b / distance
        guarded = if (guard.needsLastCollision) {
            guard.makesElastic(impactSpeed, time - rows.lastCollision[first], time - rows.lastCollision[second])
        } else {
            guard.makesElastic(impactSpeed, 0.0, 0.0)
        }
        coefficient = if (guarded) 1.0 else restitution.coefficient(impactSpeed)
        // The normal is d/|d|; b/d² · d is the approach velocity along it, without a square root that would cost
        // energy.
        val factor = (1.0 + coefficient) * b / d2
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        val f1 = factor * (m2 / (m1 + m2))
        val f2 = factor * (m1 / (m1 + m2))
        // Adding 0.0 makes −0.0 to +0.0. Else the sign of a component that no impulse changes would tell which of the
        // two was named first.
        state[p + VX] = (state[p + VX] + f1 * dx) + 0.0
        state[p + VX + 1] = (state[p + VX + 1] + f1 * dy) + 0.0
        state[p + VX + 2] = (state[p + VX + 2] + f1 * dz) + 0.0
        state[q + VX] = (state[q + VX] - f2 * dx) + 0.0
        state[q + VX + 1] = (state[q + VX + 1] - f2 * dy) + 0.0
        state[q + VX + 2] = (state[q + VX + 2] - f2 * dz) + 0.0
        if (guard.needsLastCollision) {
            rows.lastCollision[first] = time
            rows.lastCollision[second] = time
        }
        // From the reduced mass, so that it is the same to the last bit from either side.
        impulse = (1.0 + coefficient) * impactSpeed * (m1 * m2 / (m1 + m2))
        separationX = dx
        separationY = dy
        separationZ = dz
        rank = 1 + maxOf(rows.rank(first), rows.rank(second))
        rows.marks[first * MARKS] = rank
        rows.marks[second * MARKS] = rank
        return true
    }
}
