package daphnis.core.engine.horizon

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.prepare
import daphnis.core.parallel.Extremes
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.SphereColumns
import daphnis.core.search.Reach
import daphnis.core.space.Images
import daphnis.core.step.CollisionStep
import daphnis.core.wall.ContactWall
import daphnis.core.wall.WallContact
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Space and time of an epoch: its steps, its box, how images slide in it, and the lengths by which everything else is
 * rounded up. Arrays are indexed by row axis (0), middle axis (1) and slow axis (2), as in the grid of a step.
 *
 * The time of an epoch is counted from its start. Step k lasts from `k · duration` to `(k + 1) · duration`.
 *
 * An epoch of one step may be taken in several **windows** one after the other, each with lines and cells of its own.
 */
internal class EpochFrame {
    /** Which of x, y, z the row axis, the middle axis and the slow axis are. Images slide along rows. */
    val axes = intArrayOf(0, 2, 1)
    val isPeriodic = BooleanArray(AXES)

    /** The box along a periodic axis, elsewhere the stretch in which the spheres are at the start. */
    val low = DoubleArray(AXES)
    val length = DoubleArray(AXES)

    private val contacts = WallContact()

    /** Walls, ready to be asked about the epoch. */
    var walls = emptyArray<ContactWall>()
        private set
    val hasWalls: Boolean get() = walls.isNotEmpty()

    /** Images as they are at the start of the epoch. */
    val images = Images()

    /** The mean flow along the row axis by position along the slow axis; 0 when there is none of that kind. */
    var flowRate = 0.0
        private set

    /** Length of a step. */
    var duration = 0.0
        private set
    var steps = 0
        private set
    var windows = 1
        private set

    /** When the present window of the epoch begins and ends, and its middle; an epoch of several steps has only one. */
    var start = 0.0
        private set
    var end = 0.0
        private set
    var middle = 0.0
        private set

    /** Half the length of a window. */
    val halfLength: Double get() = (end - start) / 2

    /** Collisions of the present step that are later, by its time, are those of another window, or of another step. */
    val stepLimit: Double get() = if (windows == 1) duration else end

    /** Number of the present step, from 0, and when it begins. */
    var step = 0
    val stepStart: Double get() = step * duration

    /** When the present step begins, or the present window of it. */
    val windowStart: Double get() = stepStart + start
    var largestRadius = 0.0
        private set

    /** Spheres that are larger have no cell; see [MemberSizes]. Rounded up, as the radii of lines are. */
    var memberRadius = 0.0
        set(value) {
            field = Lines.roundedUp(value).toDouble()
        }

    /** Whether there are any. */
    val hasGiants: Boolean get() = largestRadius > memberRadius

    /** With a smaller [memberRadius] floats would be too coarse for lines. */
    val leastMemberRadius: Double
        get() = ROOM_FOR_WAYS * ROOM_BESIDE * FLOAT / MOST_ROUNDING * (0 until AXES).maxOf { farthestIn(it) }

    /** How far the path of a sphere may be from its line. */
    var deviation = 0.0
        private set

    /** Twice the distance that a giant may be from its course, see [SteadyGiants]. */
    val tolerance: Double get() = TOLERANCE * memberRadius

    /** What has to be added to the radii of two spheres: their paths cannot touch unless the lines come that near. */
    var inflation = 0.0
        private set

    /** Coordinates of lines are no larger. */
    var farthest = 0.0
        private set

    /** Velocities of lines along x, y, z are no larger. */
    val fastest = DoubleArray(AXES)

    /** A bound on the rounding of a line to floats: the least [deviation]. */
    private var rounding = 0.0
    private var boundary: BoundaryConditions? = null

    /** Greatest speed of any sphere along x, y, z. */
    private val speed = DoubleArray(AXES)
    private val extremes = Extremes()

    /** Whether images slide along the rows. */
    val slides: Boolean get() = images.normalAxis >= 0

    /** Takes over the space of [step] with [spheres], which [reach] has measured; [begin] follows. */
    fun takeOver(step: CollisionStep, spheres: SphereColumns, reach: Reach, loop: RangeLoop) {
        boundary = step.boundary
        duration = step.duration
        largestRadius = reach.largestRadius
        memberRadius = largestRadius
        layOutAxes(step, spheres, loop)
        reach.measured.fastest.copyInto(speed)
    }

    /**
     * Begins an epoch that is laid out by [tuning].
     *
     * @return false when lines cannot be used: images are too near or too far, or numbers are too far
     *   apart for floats
     */
    fun begin(tuning: HorizonTuning): Boolean {
        steps = tuning.steps
        windows = tuning.windows
        val whole = steps * duration
        walls = contacts.within(whole)
        openWindow(0)
        var span = 0.0
        var squares = 0.0
        for (k in 0 until AXES) {
            val way = speed[axes[k]] * whole
            squares += way * way
            span = maxOf(span, farthestIn(k))
            if (isPeriodic[k] && (length[k] < LEAST_BOX * largestRadius || way > MOST_BOXES * length[k])) return false
        }
        if (slides && abs(images.shearVelocity) * whole > MOST_BOXES * length[0]) return false
        farthest = ROOM_BESIDE * span + ROOM * sqrt(squares)
        for (k in 0 until AXES) {
            fastest[axes[k]] = minOf(farthest, if (isPeriodic[k]) 2 * MOST_BOXES * length[k] else farthest) / whole
        }
        rounding = farthest * FLOAT
        deviation = maxOf(tuning.deviation * memberRadius, 2 * rounding)
        inflation = 2 * deviation + 8 * rounding + LEAST_INFLATION * memberRadius
        return rounding < MOST_ROUNDING * memberRadius && isComputable(whole)
    }

    /** Begins window [k] of [windows]. */
    fun openWindow(k: Int) {
        val whole = steps * duration
        start = whole * k / windows
        end = if (k + 1 == windows) whole else whole * (k + 1) / windows
        middle = start + (end - start) / 2
    }

    private fun farthestIn(k: Int): Double = maxOf(abs(low[k]), abs(low[k] + length[k]))

    private fun layOutAxes(step: CollisionStep, spheres: SphereColumns, loop: RangeLoop) {
        val boundary = step.boundary
        val flow = boundary.meanFlow
        images.prepare(boundary, step.start)
        contacts.prepare(boundary.walls, step.law, step.start, step.duration)
        axes[0] = boundary.shear?.slideAxis ?: flow?.flowAxis ?: 0
        axes[2] = boundary.shear?.normalAxis ?: flow?.normalAxis ?: 1
        axes[1] = AXES - axes[0] - axes[2]
        flowRate = if (flow != null && flow.flowAxis == axes[0] && flow.normalAxis == axes[2]) flow.rate else 0.0
        for (k in 0 until AXES) {
            isPeriodic[k] = boundary.hasImages(axes[k])
            if (isPeriodic[k]) {
                low[k] = boundary.box.lower(axes[k])
                length[k] = boundary.box.length(axes[k])
            } else {
                extremes.measure(spheres.position(axes[k]), spheres.size, loop)
                low[k] = extremes.least
                length[k] = extremes.greatest - extremes.least
            }
        }
    }

    /** Whether squares of lengths times speeds are within the range of floats, with room on either side. */
    private fun isComputable(whole: Double): Boolean = memberRadius >= 1 / MOST_RADIUS &&
        largestRadius <= MOST_RADIUS &&
        memberRadius / whole * memberRadius >= LEAST_RATE &&
        largestRadius / whole * largestRadius <= MOST_RATE &&
        farthest <= MOST_RADII * memberRadius

    /** Whether [next], whose images are [now], can be the step of this epoch after the present one. */
    fun continues(next: CollisionStep, now: Images): Boolean {
        if (step + 1 >= steps || next.duration != duration || next.boundary !== boundary) return false
        return !slides || abs(now.shearOffset - offset((step + 1) * duration)) <= rounding
    }

    /** Displacement along the rows, at time [t], of the image one box up the slow axis. */
    fun offset(t: Double): Double = images.shearOffset + images.shearVelocity * t

    /** The step in which time [t] lies, or the one before when it is close. */
    fun stepAt(t: Double): Int = (t / duration - TIME_SLACK).toInt()

    /** The code of the image as many boxes away along row axis, middle axis and slow axis. */
    fun code(along: Int, middle: Int, slow: Int): Int =
        ((along and 0xff) shl (8 * axes[0])) or ((middle and 0xff) shl (8 * axes[1])) or
            ((slow and 0xff) shl (8 * axes[2]))

    private companion object {
        const val AXES = 3

        /** Periodic boxes are at least so many of the largest radii long: no sphere meets its own image. */
        const val LEAST_BOX = 3.0

        /**
         * Boxes that spheres and images go within an epoch, at most, at its start. With twice as many after collisions
         * all codes are valid: 7 boxes for path and margin, 4 × 7 where images slide, 12 for the image of a line.
         */
        const val MOST_BOXES = 2.0

        /** Room beside the spheres, for those that fly out of an open box. */
        const val ROOM_BESIDE = 1.25

        /** Room for speeds that collisions create. */
        const val ROOM = 4.0

        /** Eight units in the last place of a float. */
        const val FLOAT = 8.0 / (1 shl 23)

        /** In units of the radius of a member; lines inflate it by twelve times as much. */
        const val MOST_ROUNDING = 0.06

        /** In units of the radius of a member. */
        const val TOLERANCE = 1e-3
        const val LEAST_INFLATION = 1e-3
        const val MOST_RADIUS = 1e9
        const val LEAST_RATE = 1e-12
        const val MOST_RATE = 1e6
        const val MOST_RADII = 1e6
        const val TIME_SLACK = 1e-6

        /** Of [leastMemberRadius], for how far spheres go in an epoch. */
        const val ROOM_FOR_WAYS = 1.5
    }
}
