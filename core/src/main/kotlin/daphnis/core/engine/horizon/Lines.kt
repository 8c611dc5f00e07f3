package daphnis.core.engine.horizon

import daphnis.core.collision.NEVER
import daphnis.core.collision.StepRows
import daphnis.core.collision.waitUntilContact
import daphnis.core.growth.GrowingTable
import daphnis.core.space.Images
import kotlin.math.abs

/**
 * A straight line for each sphere, by slot: where the sphere would be at each moment of the epoch if it flew freely.
 * Entries of [state] are x y z, u v w and the radius, rounded up: at time t of the epoch the line is at x + u t.
 * Floats, since a search passes over many of them; their rounding is part of [EpochFrame.deviation]. Eight lines make a
 * block, in which each of the seven quantities lies side by side, as a vector unit takes them: see [place].
 *
 * A line lies in the box at the middle of the epoch, so that it fits the cells. The sphere itself is [image] boxes
 * away: its position is that of the line plus the displacement of the image.
 */
internal class Lines(private val frame: EpochFrame) : GrowingTable() {
    /** See above. */
    var state = FloatArray(0)
        private set

    /** How many boxes away from its line a sphere is, a code of [Images]. */
    var image = IntArray(0)
        private set

    /** A number by which the lines that a sphere has had in this epoch differ; 0 for the first. */
    var version = IntArray(0)
        private set

    /** Whether a line has gone beyond the bounds of the frame since [begin]; then the epoch cannot go on. */
    var isLost = false
        private set

    /** Begins an epoch of [count] spheres; their lines are to be [put]. */
    fun begin(count: Int) {
        isLost = false
        grow(count)
        version.fill(0, 0, count)
    }

    /** Makes room for [count] lines, and keeps those that there are. */
    fun grow(count: Int) {
        reserve(count)
        size = count
    }

    override fun resize(room: Int) {
        state = state.copyOf(floats(room))
        version = version.copyOf(room)
        image = image.copyOf(room)
    }

    private fun floats(count: Int): Int = (count + LANES - 1) / LANES * BLOCK

    /** Gives slot [i] the line in slot [j] of [other], with its version. */
    fun copy(i: Int, other: Lines, j: Int) {
        val p = place(i)
        val q = place(j)
        for (k in 0..RADIUS step LANES) state[p + k] = other.state[q + k]
        image[i] = other.image[j]
        version[i] = other.version[j]
    }

    /** Gives the slots [from] until [to] the lines of [other], with their versions. */
    fun copyRange(other: Lines, from: Int, to: Int) {
        if (from % LANES == 0 && to % LANES == 0) {
            other.state.copyInto(state, place(from), place(from), place(to))
            other.image.copyInto(image, from, from, to)
            other.version.copyInto(version, from, from, to)
        } else {
            for (i in from until to) copy(i, other, i)
        }
    }

    /** Gives slot [i] the line of a sphere that is at ([px], [py], [pz]) at [time] of the epoch. */
    fun put(i: Int, px: Double, py: Double, pz: Double, pu: Double, pv: Double, pw: Double, time: Double) {
        val bx = px - pu * time
        val by = py - pv * time
        val bz = pz - pw * time
        val p = place(i)
        state[p] = bx.toFloat()
        state[p + Y] = by.toFloat()
        state[p + Z] = bz.toFloat()
        state[p + U] = pu.toFloat()
        state[p + V] = pv.toFloat()
        state[p + W] = pw.toFloat()
        image[i] = 0
        val most = frame.farthest
        val fastest = frame.fastest
        val isWithin = abs(bx) <= most &&
            abs(by) <= most &&
            abs(bz) <= most &&
            abs(pu) <= fastest[0] &&
            abs(pv) <= fastest[1] &&
            abs(pw) <= fastest[2]
        if (!isWithin) isLost = true
    }

    /** Nobody is on the line in slot [i] any more, which keeps its radius. */
    fun forget(i: Int) {
        state[place(i)] = Float.NaN
        image[i] = 0
    }

    /** Gives slot [i] a radius of at least [radius]. */
    fun putRadius(i: Int, radius: Double) {
        state[place(i) + RADIUS] = roundedUp(radius)
    }

    /** Moves the line in slot [i] back by the boxes of [code], and the sphere's image forth. */
    fun moveBack(i: Int, code: Int) {
        if (code == 0) return
        val images = frame.images
        for (axis in 0..2) {
            val p = place(i) + axis * LANES
            state[p] = (state[p] - images.shift(code, axis)).toFloat()
            state[p + U] = (state[p + U] - images.slide(code, axis)).toFloat()
        }
        image[i] = sum(image[i], code)
    }

    /** Position along [axis] (x, y, z) of the line in slot [i] at time [t]. */
    fun at(i: Int, axis: Int, t: Double): Double {
        val p = place(i) + axis * LANES
        return state[p] + state[p + U] * t
    }

    /** Radius of the line in slot [i]. */
    fun radius(i: Int): Double = state[place(i) + RADIUS].toDouble()

    /** Velocity along [axis] of the line in slot [i]. */
    fun velocity(i: Int, axis: Int): Double = state[place(i) + U + axis * LANES].toDouble()

    /**
     * Whether a sphere that is at the place [p] of [state] at time [t], with the velocity there, see [StepRows.state],
     * follows the line in slot [i] for the time [rest]: both are straight, so its ends are enough.
     */
    fun isFollowed(i: Int, state: DoubleArray, p: Int, t: Double, rest: Double): Boolean {
        val v = p + StepRows.VX
        return isFollowed(
            i, image[i], state[p], state[p + 1], state[p + 2], state[v], state[v + 1], state[v + 2], t, rest,
        )
    }

    /** The same for a sphere at (x, y, z) with velocity (vx, vy, vz), if it is at the image [code] of the line. */
    fun isFollowed(
        i: Int,
        code: Int,
        x: Double,
        y: Double,
        z: Double,
        vx: Double,
        vy: Double,
        vz: Double,
        t: Double,
        rest: Double,
    ): Boolean {
        val images = frame.images
        val sx = images.slide(code, 0)
        val sy = images.slide(code, 1)
        val ex = x - (at(i, 0, t) + images.shift(code, 0) + sx * t)
        val ey = y - (at(i, 1, t) + images.shift(code, 1) + sy * t)
        val ez = z - (at(i, 2, t) + images.shift(code, 2))
        val fx = ex + (vx - (velocity(i, 0) + sx)) * rest
        val fy = ey + (vy - (velocity(i, 1) + sy)) * rest
        val fz = ez + (vz - velocity(i, 2)) * rest
        val most = frame.deviation * frame.deviation
        return ex * ex + ey * ey + ez * ez <= most && fx * fx + fy * fy + fz * fz <= most
    }

    /**
     * For the image [code] of line [j] of [other] as seen from line [i], the image of the one sphere as seen from the
     * other.
     */
    fun spheresImage(code: Int, i: Int, other: Lines, j: Int): Int {
        val p = image[i]
        val q = other.image[j]
        return if (p == q) code else sum(sum(code, p), Images.negated(q))
    }

    /** The reverse of [spheresImage]: for the image [code] of the sphere, that of line [j] of [other]. */
    fun linesImage(code: Int, i: Int, other: Lines, j: Int): Int {
        val p = image[i]
        val q = other.image[j]
        return if (p == q) code else sum(sum(code, Images.negated(p)), q)
    }

    /**
     * A moment before which the sphere in slot [i] and that in slot [j] of [other], at the image [code] of the second
     * line, cannot touch from time [t] on as long as both keep their lines; [NEVER] when they cannot at all.
     */
    fun touch(i: Int, other: Lines, j: Int, code: Int, t: Double): Double {
        val images = frame.images
        val mine = state
        val theirs = other.state
        val p = place(i)
        val q = place(j)
        val ux = (theirs[q + U].toDouble() - mine[p + U]) + images.slide(code, 0)
        val uy = (theirs[q + V].toDouble() - mine[p + V]) + images.slide(code, 1)
        val uz = theirs[q + W].toDouble() - mine[p + W]
        val dx = (theirs[q].toDouble() - mine[p]) + images.shift(code, 0) + ux * t
        val dy = (theirs[q + Y].toDouble() - mine[p + Y]) + images.shift(code, 1) + uy * t
        val dz = (theirs[q + Z].toDouble() - mine[p + Z]) + images.shift(code, 2) + uz * t
        val s = mine[p + RADIUS].toDouble() + theirs[q + RADIUS] + frame.inflation
        val c = dx * dx + dy * dy + dz * dz - s * s
        if (c <= 0) return t
        val b = dx * ux + dy * uy + dz * uz
        return if (b >= 0) NEVER else t + waitUntilContact(ux * ux + uy * uy + uz * uz, b, c)
    }

    /**
     * A moment before which the sphere in slot [i] cannot touch a wall from time [t] on as long as it keeps its line;
     * [NEVER] when it cannot at all.
     */
    fun touchWall(i: Int, t: Double): Double {
        val r = state[place(i) + RADIUS] + frame.inflation
        val x = at(i, 0, t)
        val y = at(i, 1, t)
        val z = at(i, 2, t)
        val vx = velocity(i, 0)
        val vy = velocity(i, 1)
        val vz = velocity(i, 2)
        var first = NEVER
        for (wall in frame.walls) first = minOf(first, t + wall.soonest(x, y, z, vx, vy, vz, r))
        return first
    }

    companion object {
        /** Lines of a block, and its floats. */
        const val LANES = 8
        const val BLOCK = 64

        /** Where the other quantities of a line are, counted from its x. */
        const val Y = LANES
        const val Z = 2 * LANES
        const val U = 3 * LANES
        const val V = 4 * LANES
        const val W = 5 * LANES
        const val RADIUS = 6 * LANES

        /** Where in [state] the line of slot [i] begins, with its x. */
        @JvmStatic
        fun place(i: Int): Int = (i and -LANES) * (BLOCK / LANES) + (i and LANES - 1)

        fun roundedUp(radius: Double): Float {
            val f = radius.toFloat()
            return if (f < radius) Math.nextUp(f) else f
        }

        /** The image as many boxes away as [a] and [b] together. */
        fun sum(a: Int, b: Int): Int {
            if (a == 0) return b
            if (b == 0) return a
            return Images.code(
                Images.component(a, 0) + Images.component(b, 0),
                Images.component(a, 1) + Images.component(b, 1),
                Images.component(a, 2) + Images.component(b, 2),
            )
        }
    }
}
