package daphnis.core.wall

import daphnis.core.population.Carried
import kotlin.math.abs

/**
 * A wall with a mass, which a constant force and the impacts of spheres move along its normal.
 *
 * Its motion depends on all impacts, which engines find in any order. So within a step it moves as it would without
 * them, with the acceleration force/mass, and a sphere of mass m that meets it with the relative speed u gets the
 * impulse (1 + ε) u m M/(m + M), as from a free body of mass M, and u m at least, since the wall does not give way
 * within the step; at the end of the step the piston takes up the exact
 * sum of these impulses. Momentum is conserved to round-off. The energy changes by J₁J₂/M for each pair of impulses
 * in a step, and the force takes about as much back: it drifts by first order in the step, and wanders with the root
 * of it. A step should change the speed of the piston by little, and its mass be large for that of a sphere; see
 * docs/physics.md.
 *
 * [position] and [speed] are state of the simulation whose boundary this belongs to: one simulation, which moves it
 * at the end of each step, by the thread that calls it. Its checkpoints hold them.
 *
 * @property mass M > 0; infinite is what [WallMotion.Steady] is for
 * @property force along the axis, positive towards greater coordinates
 * @param position displacement from the face of the box at the start
 * @param speed along the axis at the start
 * @throws IllegalArgumentException when a number is not finite, or the mass not > 0
 */
public class Piston @JvmOverloads constructor(
    public val mass: Double,
    public val force: Double = 0.0,
    position: Double = 0.0,
    speed: Double = 0.0,
) : WallMotion(),
    Carried {
    init {
        require(mass > 0 && mass.isFinite()) { "mass of a piston is $mass; it must be > 0" }
        require(force.isFinite()) { "force on a piston is $force; it must be finite" }
        require(position.isFinite()) { "position of a piston is $position; it must be finite" }
        require(speed.isFinite()) { "speed of a piston is $speed; it must be finite" }
    }

    /** Displacement from the face of the box at the end of the last step. */
    public var position: Double = position
        private set

    /** Velocity along the axis at the end of the last step. */
    public var speed: Double = speed
        private set

    private val acceleration = force / mass

    /** Of its motion and in its force, ½ M V² − F · [position]. */
    public val energy: Double get() = 0.5 * mass * speed * speed - force * position

    override val isKnownAhead: Boolean get() = false
    override val amplitude: Double get() = Double.POSITIVE_INFINITY
    override val strongest: Double = abs(acceleration)

    /** The displacement at the end of the last step, whatever the time. */
    override fun phase(time: Double): Double = position

    override fun displacement(phase: Double, t: Double): Double = phase + t * (speed + 0.5 * acceleration * t)

    override fun velocity(phase: Double, t: Double): Double = speed + acceleration * t

    override fun leastAcceleration(piece: Long): Double = acceleration

    override fun mostAcceleration(piece: Long): Double = acceleration

    /**
     * The coefficient of restitution of a wall of infinite mass which gives a sphere of mass [m] the impulse that this
     * piston gives with [restitution]; 0 at least.
     */
    override fun coefficient(restitution: Double, m: Double): Double =
        maxOf(0.0, (1 + restitution) * (mass / (mass + m)) - 1)

    /** Ends a step of [duration] in which it gave the [impulse] along the axis to spheres. */
    internal fun move(duration: Double, impulse: Double) {
        position = displacement(position, duration)
        speed += acceleration * duration - impulse / mass
    }

    /** [position] and [speed]. */
    override var carried: DoubleArray
        get() = doubleArrayOf(position, speed)
        set(value) {
            position = value[0]
            speed = value[1]
        }

    override fun toString(): String = "piston of mass $mass under the force $force"
}

/** The pistons among the walls, by number. */
internal val WallSet.pistons: Map<Int, Piston>
    get() = buildMap { for (number in numbers) (this@pistons[number]?.motion as? Piston)?.let { put(number, it) } }
