package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.StepRows
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.MeanFlow
import daphnis.core.population.SphereColumns
import daphnis.core.population.nameNotFinite
import kotlin.math.abs

/**
 * How far a sphere may go along each axis within a step: a bound on which the search relies, not a guess. It is the
 * largest speed along the axis times the duration, with some headroom for what collisions may add. An engine checks
 * every velocity that a collision creates against it. When one exceeds it, the step is restored, [enlarge] is called
 * and the step is redone.
 *
 * Along a periodic axis the bound is limited so that images too far away do not matter. The headroom is reduced there,
 * so a step is refused only when a sphere itself goes too far: at the start of the step, or by a collision. That
 * depends on the state at the start and on the trajectory, not on the headroom.
 */
public class Reach {
    private val fastest = DoubleArray(AXES)
    private val most = DoubleArray(AXES)
    private var headroom = LEAST_HEADROOM

    /** The flow in which images slide. */
    private var flow: MeanFlow? = null

    /** What was found of the spheres, or of all parts of them. */
    internal val measured = StepBounds()

    /** The largest radius of the spheres that were measured; 0 when there are none. */
    internal val largestRadius: Double get() = measured.largestRadius

    /** The bound along x, y, z, in units of length. */
    public val bound: DoubleArray = DoubleArray(AXES)

    /** Speeds along x, y, z: a sphere that stays within them cannot go beyond [bound]. */
    public val speed: DoubleArray = DoubleArray(AXES)

    /**
     * Computes the bounds from all velocities and radii of [population] for a step of [duration] within [boundary].
     *
     * @throws IllegalArgumentException when a sphere goes so far that it meets images farther away than are searched,
     *   when a number of the population is not finite, when a sphere is outside a periodic box, or when sizes, speeds
     *   and duration are beyond what can be computed
     */
    @JvmOverloads
    public fun measure(
        population: SphereColumns,
        boundary: BoundaryConditions,
        duration: Double,
        loop: RangeLoop = InlineLoop,
    ) {
        look(population, boundary, everywhere = false, loop)
        apply(boundary, duration)
    }

    /**
     * The first half of [measure]: looks at the spheres and fills [measured]. A driver of several parts of a population
     * makes that the bounds of all of them before it calls [apply].
     *
     * @param everywhere whether positions are measured along axes without images too
     * @param along see [StepBounds.measure]
     */
    internal fun look(
        spheres: SphereColumns,
        boundary: BoundaryConditions,
        everywhere: Boolean,
        loop: RangeLoop,
        along: StepBounds.AlongPieces? = null,
    ) {
        measured.measure(spheres, boundary, everywhere, loop, along)
        if (!measured.areFinite) {
            spheres.nameNotFinite()?.let { throw IllegalArgumentException("$it; it must be finite") }
        }
        measured.headroom = maxOf(LEAST_HEADROOM, headroom * DECAY)
    }

    /** The second half of [measure]: computes the bounds from what was [measured]. */
    internal fun apply(boundary: BoundaryConditions, duration: Double) {
        headroom = measured.headroom
        measured.fastest.copyInto(fastest)
        for (axis in 0 until AXES) requireInBox(axis, boundary)
        if (!measured.isEmpty) {
            Scales.requireSpeeds(maxOf(fastest[0], fastest[1], fastest[2]), measured.leastRadius, duration)
        }
        for (axis in 0 until AXES) {
            val mostReach = ImageRange.mostReach(boundary, axis, largestRadius, duration)
            most[axis] = mostReach / duration * (1 - 4 * ROUNDING)
            if (fastest[axis] > most[axis]) refuse(axis)
        }
        flow = boundary.slidingFlow
        apply(duration)
    }

    /**
     * Takes over the bounds of [whole], for some of the spheres that it has measured. What is refused for all is
     * refused for the part too. Closer bounds would be no gain: what a sphere can meet is told by those of rows of
     * cells.
     */
    internal fun take(whole: Reach) {
        headroom = whole.headroom
        flow = whole.flow
        measured.take(whole.measured.numbers())
        for (axis in 0 until AXES) {
            fastest[axis] = whole.fastest[axis]
            most[axis] = whole.most[axis]
            speed[axis] = whole.speed[axis]
            bound[axis] = whole.bound[axis]
        }
    }

    /** Starts the next step with the headroom that [part] had to take in this one, if that is larger. */
    internal fun learn(part: Reach) {
        headroom = maxOf(headroom, part.headroom)
    }

    /** Images are counted from the box, so a sphere elsewhere would be looked for at the wrong ones. */
    private fun requireInBox(axis: Int, boundary: BoundaryConditions) {
        if (!boundary.hasImages(axis) || measured.isEmpty) return
        val low = boundary.box.lower(axis)
        val high = low + boundary.box.length(axis)
        val rounding = ImageRange.rounding(low, high)
        val isBelow = measured.lowest[axis] < low - rounding
        require(!isBelow && measured.highest[axis] <= high + rounding) {
            val place = if (isBelow) measured.lowest[axis] else measured.highest[axis]
            "a sphere is at ${"xyz"[axis]} = $place, outside the box, which goes from $low to $high; " +
                "BoundaryConditions.endStep brings it back"
        }
    }

    /**
     * Whether sphere [slot] of [rows], if nothing more happens to it, ends the step of [duration] farther from where it
     * started in [population] than the bound. Its path so far has been checked before.
     */
    public fun isOutrun(rows: StepRows, slot: Int, population: SphereColumns, duration: Double): Boolean {
        val v = slot * StepRows.STRIDE + StepRows.VX
        val state = rows.state
        // Nearly always the sphere is not faster than the bound on speed, and the place where it started need not be
        // looked up.
        if (abs(state[v]) <= speed[0] && abs(state[v + 1]) <= speed[1] && abs(state[v + 2]) <= speed[2]) return false
        for (axis in 0 until AXES) if (isOutrunAlong(axis, rows, slot, population, duration)) return true
        return false
    }

    private fun isOutrunAlong(
        axis: Int,
        rows: StepRows,
        slot: Int,
        population: SphereColumns,
        duration: Double,
    ): Boolean {
        val p = slot * StepRows.STRIDE
        val v = rows.state[p + StepRows.VX + axis]
        if (abs(v) <= speed[axis]) return false
        val from = when (axis) {
            0 -> population.x
            1 -> population.y
            else -> population.z
        }
        val to = rows.state[p + axis] + v * (duration - rows.state[p + StepRows.TIME])
        return abs(to - from[rows.origin[slot]]) > bound[axis]
    }

    /**
     * Enlarges the bound after sphere [first] or [second] (negative for none) of [rows], which collided with each
     * other, went beyond it: by twice the excess of their speeds on each axis.
     *
     * @throws IllegalArgumentException when there is no more room: images farther away than are looked for would matter
     */
    public fun enlarge(rows: StepRows, first: Int, second: Int, population: SphereColumns, duration: Double) {
        for (axis in 0 until AXES) {
            if (speed[axis] < most[axis]) continue
            val isOutrun = isOutrunAlong(axis, rows, first, population, duration) ||
                second >= 0 &&
                isOutrunAlong(axis, rows, second, population, duration)
            if (isOutrun) refuse(axis)
        }
        headroom *= 1.5
        for (axis in 0 until AXES) {
            raise(axis, rows, first)
            if (second >= 0) raise(axis, rows, second)
        }
        apply(duration)
    }

    private fun raise(axis: Int, rows: StepRows, slot: Int) {
        val speed = abs(rows.state[slot * StepRows.STRIDE + StepRows.VX + axis])
        if (speed > fastest[axis]) fastest[axis] += 2 * (speed - fastest[axis])
    }

    private fun apply(duration: Double) {
        val floor = floor()
        for (axis in 0 until AXES) {
            speed[axis] = minOf(maxOf(fastest[axis], floor) * (1 + headroom), most[axis])
            bound[axis] = speed[axis] * duration * (1 + ROUNDING)
        }
    }

    /**
     * The speed that every axis gets at least, since one without motion can gain some from the others: a small part of
     * the greatest. Where images slide in a flow that is the speed relative to the flow, and the difference of the flow
     * over a sphere: the flow itself is that of neighbours too, and fast at the ends of a wide box.
     */
    private fun floor(): Double {
        val greatest = maxOf(fastest[0], fastest[1], fastest[2]) * LEAST_SHARE
        val flow = flow ?: return greatest
        val across = maxOf(fastest[flow.normalAxis], fastest[AXES - flow.normalAxis - flow.flowAxis])
        val relative = maxOf(across, measured.peculiar) * LEAST_SHARE
        return minOf(greatest, maxOf(relative, 2 * largestRadius * abs(flow.rate)))
    }

    private fun refuse(axis: Int): Nothing = throw IllegalArgumentException(ImageRange.refusal(axis))

    private companion object {
        const val AXES = 3
        const val LEAST_HEADROOM = 0.05
        const val DECAY = 0.98
        const val LEAST_SHARE = 0.1
        const val ROUNDING = 1e-12
    }
}
