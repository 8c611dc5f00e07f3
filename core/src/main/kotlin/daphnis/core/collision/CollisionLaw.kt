package daphnis.core.collision

import daphnis.core.collision.StepRows.Companion.MARKS
import daphnis.core.collision.StepRows.Companion.STRIDE
import daphnis.core.collision.StepRows.Companion.VX
import daphnis.core.merging.BreakRule
import daphnis.core.merging.MergeRule
import daphnis.core.potential.PairInteractions
import daphnis.core.space.Images
import daphnis.core.space.Space
import daphnis.core.surface.ContactLaw
import daphnis.core.surface.Restitution
import daphnis.core.surface.RoughContact
import daphnis.core.surface.Roughness
import daphnis.core.surface.SurfaceContact
import kotlin.math.max
import kotlin.math.sqrt

/**
 * What a collision does: brings both spheres to the moment of contact and exchanges momentum along the line of centres,
 * with coefficient ε of a [ContactLaw] unless [guard] makes the collision elastic. Tangential velocities and spins
 * change where that law is rough, also in a collision that the guard makes elastic: what ends collapse is ε = 1, and
 * friction alone leads to none.
 *
 * A law is immutable, and the outcome is a pure function of the two states, so any number of workers can share one law.
 *
 * @param law of both coefficients; a [Restitution] for smooth spheres
 * @param roughness β in place of that of [law]; null for the law's own. Spins of smooth spheres stay
 * @property momentFactor moment of inertia of spheres over mass · radius², see [Space.mostMomentFactor]
 * @param turning angular speed about z of the axes in which spins are given: Ω in Hill's frame, else 0
 * @param acceleration of all spheres along x, y, z, by forces that kick them before and after the drift: what walls
 *   need to know of the true paths
 * @property mergeRule which impacts merge two spheres; null for none
 * @property interactions what spheres do to one another besides impacts; null for nothing
 * @property breakRule which impacts break spheres; null for none
 */
public class CollisionLaw @JvmOverloads constructor(
    law: ContactLaw,
    public val guard: CollapseGuard = NoGuard,
    roughness: Roughness? = null,
    public val momentFactor: Double = SurfaceContact.SOLID,
    turning: Double = 0.0,
    private val acceleration: List<Double> = STILL,
    public val interactions: PairInteractions? = null,
    public val mergeRule: MergeRule? = null,
    public val breakRule: BreakRule? = null,
) {
    /** Both coefficients. */
    public val contactLaw: ContactLaw = if (roughness == null) law else RoughContact(law, roughness)

    /** Of smooth spheres whose ε depends on the impact speed alone, for which no contact is described; else null. */
    private val restitution = contactLaw as? Restitution

    /** Whether spheres need spins. */
    internal val isRough: Boolean = restitution == null && contactLaw.isRough

    init {
        require(momentFactor > 0 && momentFactor <= Space.PLANE.mostMomentFactor) {
            "the moment of inertia is $momentFactor m r²; the factor must be > 0 and ${Space.PLANE.mostMomentInWords}"
        }
        // A search looks as far as one of them asks for, and states of pairs say nothing of what two become.
        require(interactions == null || mergeRule == null) { "spheres have interactions and merge; they can do one" }
        require(interactions == null || breakRule == null) { "spheres have interactions and break; they can do one" }
    }

    /** @throws IllegalArgumentException when no particle of [space] has such a moment of inertia */
    internal fun requireIn(space: Space) {
        require(momentFactor <= space.mostMomentFactor) {
            "the moment of inertia is $momentFactor m r²; the factor must be ${space.mostMomentInWords}"
        }
    }

    internal val hasAcceleration: Boolean = acceleration.any { it != 0.0 }

    /** The acceleration of all spheres along [axis]. */
    internal fun acceleration(axis: Int): Double = acceleration[axis]

    /**
     * The time from the start of the step at which the spheres in slots [first] and [second] of [rows] meet or come to an
     * edge of their interaction; without one, [contactTime].
     */
    public fun meetingTime(rows: StepRows, first: Int, second: Int, image: Int, images: Images): Double {
        val states = edges?.states ?: return contactTime(rows, first, second, image, images)
        val state = states.of(rows, first, rows, second)
        return states.time(state, rows.state, first * STRIDE, rows.state, second * STRIDE, image, images)
    }

    /** The coefficient of restitution at a wall whose own is [own]; the guard may make it 1 as between spheres. */
    internal fun atWall(own: Double, rows: StepRows, slot: Int, speed: Double, time: Double): Double {
        if (!guard.needsLastCollision) return if (guard.makesElastic(speed, 0.0, 0.0)) 1.0 else own
        val since = time - rows.lastCollision[slot]
        rows.lastCollision[slot] = time
        return if (guard.makesElastic(speed, since, Double.POSITIVE_INFINITY)) 1.0 else own
    }

    /** Energy of motion and spin of [slot], the components of whose true velocity have [squares] as sum of squares. */
    internal fun energy(rows: StepRows, slot: Int, squares: Double): Double {
        if (!rows.hasSpin) return 0.5 * rows.mass[slot] * squares
        val r = rows.state[slot * STRIDE + StepRows.RADIUS]
        val turns = rows.wx[slot] * rows.wx[slot] + rows.wy[slot] * rows.wy[slot] + rows.wz[slot] * rows.wz[slot]
        return 0.5 * rows.mass[slot] * (squares + momentFactor * r * r * turns)
    }

    /** What happens at the edges of [interactions]. */
    internal val edges: EdgeExchange? = interactions?.let { EdgeExchange(PairStates(it)) }

    /** What happens in a merger; null where nothing merges. */
    internal val merging: Merging? = mergeRule?.let { Merging(it, momentFactor) }

    /** What happens to spheres that break; null where nothing does. */
    internal val breaking: Breaking? = breakRule?.let { Breaking(it) }

    /** Whether spheres only meet, and stay what and as many as they are: epochs and lists of neighbours know no more. */
    internal val isPlain: Boolean = interactions == null && mergeRule == null && breakRule == null

    /** Whether spheres overlap in right states too. */
    internal val mayOverlap: Boolean = interactions?.areHard == false || mergeRule != null || breakRule != null

    /** For spheres and walls. */
    internal val spins = SpinExchange(momentFactor, turning)

    /**
     * Processes the collision of slots [first] and [second] at [time] (from the start of the step) and describes it in
     * [outcome].
     *
     * @return false when the spheres recede because of round-off at a grazing contact; then only their local times have
     *   changed, and [outcome] is as it was
     * @throws IllegalArgumentException when the law gives an ε that is not in [0, 1], or a β that is not in [−1, 1], or
     *   a sphere that has merged meets its own image
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
        if (merging != null) Merging.requireTwo(first, second)
        rows.advance(first, time)
        rows.advance(second, time)
        separation(rows, first, second, image, images, time) { dx, dy, dz ->
            val state = rows.state
            val p = first * STRIDE + VX
            val q = second * STRIDE + VX
            val ux = state[q] - state[p] + images.slide(image, 0)
            val uy = state[q + 1] - state[p + 1] + images.slide(image, 1)
            val uz = state[q + 2] - state[p + 2] + images.slide(image, 2)
            val b = dx * ux + dy * uy + dz * uz
            val d2 = dx * dx + dy * dy + dz * dz
            val isEdge = edges != null && edges.pass(rows, first, second, b, d2, outcome)
            if (!isEdge && b >= 0.0) return false
            outcome.gone = CollisionOutcome.NOBODY
            outcome.separationX = dx
            outcome.separationY = dy
            outcome.separationZ = dz
            outcome.impactSpeed = -b / sqrt(d2)
            val restitution = restitution
            if (isEdge) {
                exchange(rows, first, second, outcome.factor, outcome)
                separate(rows, first, second, image, images, outcome, if (outcome.outward) 1.0 else -1.0)
                return@separation
            }
            outcome.edge = CollisionOutcome.CONTACT
            if (restitution == null || merging != null) {
                outcome.ux = ux
                outcome.uy = uy
                outcome.uz = uz
            }
            if (merging != null && mayMerge(rows, first, second) && merging.take(rows, first, second, outcome)) {
                return@separation
            }
            if (restitution != null) {
                askGuard(rows, first, second, time, outcome)
                outcome.coefficient = if (outcome.guarded) 1.0 else restitution.coefficient(outcome.impactSpeed)
                settle(rows, first, second, b, d2, time, outcome)
                outcome.forgetSurfaces()
            } else {
                outcome.nearing = b
                outcome.distance2 = d2
                touch(rows, first, second, time, outcome)
            }
            if (breaking != null) outcome.rubbed -= outcome.kept
            // From the reduced mass, so that it is the same to the last bit from either side.
            val m1 = rows.mass[first]
            val m2 = rows.mass[second]
            outcome.impulse = (1.0 + outcome.coefficient) * outcome.impactSpeed * (m1 * m2 / (m1 + m2))
            separate(rows, first, second, image, images, outcome, sign = 1.0)
            edges?.met(rows, first, second)
        }
        outcome.rank = 1 + maxOf(rows.rank(first), rows.rank(second))
        rows.marks[first * MARKS] = outcome.rank
        rows.marks[second * MARKS] = outcome.rank
        return true
    }

    /** The exchange by a law that is told of more than the impact speed. */
    private fun touch(rows: StepRows, first: Int, second: Int, time: Double, outcome: CollisionOutcome) {
        spins.meet(rows, first, second, time, outcome)
        askGuard(rows, first, second, time, outcome)
        outcome.coefficient = if (outcome.guarded) 1.0 else contactLaw.restitution(outcome.contact)
        settle(rows, first, second, outcome.nearing, outcome.distance2, time, outcome)
        outcome.contact.restitution = outcome.coefficient
        if (isRough) spins.rub(rows, contactLaw, first, second, outcome) else outcome.forgetSurfaces()
    }

    /** Whether the guard makes the collision elastic. */
    private fun askGuard(rows: StepRows, first: Int, second: Int, time: Double, outcome: CollisionOutcome) {
        val speed = outcome.impactSpeed
        if (guard.needsLastCollision) {
            val last = rows.lastCollision
            outcome.guarded = guard.makesElastic(speed, time - last[first], time - last[second])
        } else {
            outcome.guarded = guard.makesElastic(speed, 0.0, 0.0)
        }
    }

    /** Exchanges momentum along the normal, with the coefficient of [outcome] if that is one. */
    private fun settle(
        rows: StepRows,
        first: Int,
        second: Int,
        b: Double,
        d2: Double,
        time: Double,
        outcome: CollisionOutcome,
    ) {
        val coefficient = outcome.coefficient
        // NaN is in no range.
        if (!(coefficient >= 0.0 && coefficient <= 1.0)) refuse(coefficient, outcome.impactSpeed)
        if (guard.needsLastCollision) {
            rows.lastCollision[first] = time
            rows.lastCollision[second] = time
        }
        // The normal is d/|d|; b/d² · d is the approach velocity along it, without a square root that would cost
        // energy.
        if (breaking != null) return shatter(breaking, rows, first, second, b, d2, outcome)
        exchange(rows, first, second, (1.0 + coefficient) * b / d2, outcome)
    }

    /** Exchanges momentum with what is left of ½ μ v_n² when the pieces of what breaks have theirs. */
    private fun shatter(
        breaking: Breaking,
        rows: StepRows,
        first: Int,
        second: Int,
        b: Double,
        d2: Double,
        outcome: CollisionOutcome,
    ) {
        breaking.take(rows, first, second, outcome)
        val m1 = rows.mass[first]
        val m2 = rows.mass[second]
        val left = -sqrt(max(0.0, b * b - 2.0 * outcome.kept * d2 / (m1 * m2 / (m1 + m2))))
        val coefficient = outcome.coefficient
        outcome.coefficient = coefficient * (left / b)
        exchange(rows, first, second, (b + coefficient * left) / d2, outcome)
    }

    /** What has broken in this step is not one sphere any more. */
    private fun mayMerge(rows: StepRows, first: Int, second: Int) =
        breaking == null || !breaking.isBroken(rows, first) && !breaking.isBroken(rows, second)

    private fun refuse(coefficient: Double, speed: Double): Nothing = throw IllegalArgumentException(
        "the coefficient of restitution is $coefficient at an impact speed of $speed; it must be in [0, 1]",
    )
}

private val STILL = listOf(0.0, 0.0, 0.0)
