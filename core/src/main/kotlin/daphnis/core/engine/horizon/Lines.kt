package daphnis.core.engine.horizon

import daphnis.core.boundary.Images
import daphnis.core.collision.NEVER
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A straight line for each sphere, by slot: where the sphere would be at each moment of the epoch if it flew freely.
 * Entries i·8 to i·8 + 6 of [state] are x y z, u v w and the radius, rounded up: at time t of the epoch the line is at
 * x + u t. Floats side by side, since a search passes over many of them; their rounding is part of
 * [EpochFrame.deviation].
 *
 * A line lies in the box at the middle of the epoch, so that it fits the cells. The sphere itself is [image] boxes
 * away: its position is that of the line plus the displacement of the image.
 */
internal class Lines(private val frame: EpochFrame) {
    /** See above. */
    var state = FloatArray(0)
        private set

    /** How many boxes away from its line a sphere is, a code of [Images]. */
    var image = IntArray(0)
        private set

    /** Counts the lines that a sphere has had in this epoch. */
    var version = IntArray(0)
        private set

    /** Whether a line has gone beyond the bounds of the frame since [begin]; then the epoch cannot go on. */
    var isLost = false
        private set

    /** Begins an epoch of [count] spheres; their lines are to be [put]. */
    fun begin(count: Int) {
        isLost = false
        if (image.size < count) {
            state = FloatArray(count * STRIDE)
            version = IntArray(count)
            image = IntArray(count)
        }
        version.fill(0, 0, count)
    }

    /** Gives slot [i] the line of a sphere that is at ([px], [py], [pz]) at [time] of the epoch. */
    fun put(i: Int, px: Double, py: Double, pz: Double, pu: Double, pv: Double, pw: Double, time: Double) {
        val bx = px - pu * time
        val by = py - pv * time
        val bz = pz - pw * time
        val p = i * STRIDE
        state[p] = bx.toFloat()
        state[p + 1] = by.toFloat()
        state[p + 2] = bz.toFloat()
        state[p + U] = pu.toFloat()
        state[p + U + 1] = pv.toFloat()
        state[p + U + 2] = pw.toFloat()
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

    /** Gives slot [i] a radius of at least [radius]. */
    fun putRadius(i: Int, radius: Double) {
        val f = radius.toFloat()
        state[i * STRIDE + RADIUS] = if (f < radius) Math.nextUp(f) else f
    }

    /** Moves the line in slot [i] back by the boxes of [code], and the sphere's image forth. */
    fun moveBack(i: Int, code: Int) {
        if (code == 0) return
        val images = frame.images
        val p = i * STRIDE
        for (axis in 0..2) {
            state[p + axis] = (state[p + axis] - images.shift(code, axis)).toFloat()
            state[p + U + axis] = (state[p + U + axis] - images.slide(code, axis)).toFloat()
        }
        image[i] = sum(image[i], code)
    }

    /** Position along [axis] (x, y, z) of the line in slot [i] at time [t]. */
    fun at(i: Int, axis: Int, t: Double): Double = state[i * STRIDE + axis] + state[i * STRIDE + U + axis] * t

    /** Velocity along [axis] of the line in slot [i]. */
    fun velocity(i: Int, axis: Int): Double = state[i * STRIDE + U + axis].toDouble()

    /** For the image [code] of line [j] as seen from line [i], the image of sphere j as seen from sphere i. */
    fun spheresImage(code: Int, i: Int, j: Int): Int {
        val p = image[i]
        val q = image[j]
        return if (p == q) code else sum(sum(code, p), Images.negated(q))
    }

    /**
     * A moment before which the spheres in slots [i] and [j], at the image [code] of the second line, cannot touch from
     * time [t] on as long as both keep their lines; [NEVER] when they cannot at all.
     */
    fun touch(i: Int, j: Int, code: Int, t: Double): Double {
        val images = frame.images
        val p = i * STRIDE
        val q = j * STRIDE
        val ux = (state[q + U].toDouble() - state[p + U]) + images.slide(code, 0)
        val uy = (state[q + U + 1].toDouble() - state[p + U + 1]) + images.slide(code, 1)
        val uz = state[q + U + 2].toDouble() - state[p + U + 2]
        val dx = (state[q].toDouble() - state[p]) + images.shift(code, 0) + ux * t
        val dy = (state[q + 1].toDouble() - state[p + 1]) + images.shift(code, 1) + uy * t
        val dz = (state[q + 2].toDouble() - state[p + 2]) + images.shift(code, 2) + uz * t
        val s = state[p + RADIUS].toDouble() + state[q + RADIUS] + frame.inflation
        val c = dx * dx + dy * dy + dz * dz - s * s
        if (c <= 0) return t
        val b = dx * ux + dy * uy + dz * uz
        if (b >= 0) return NEVER
        val discriminant = b * b - (ux * ux + uy * uy + uz * uz) * c
        return if (discriminant < 0) NEVER else t + c / (sqrt(discriminant) - b)
    }

    companion object {
        /** Floats per line in [state]. */
        const val STRIDE = 8

        /** Offsets of the velocity and of the radius. */
        const val U = 3
        const val RADIUS = 6

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
