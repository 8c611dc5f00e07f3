package daphnis.core.space

/**
 * Periodic images as small integers. A code packs how many boxes away an image is along x, y and z, one signed byte
 * each, so 0 is the sphere itself. In a step that starts at time `t₀`, the image of a sphere is displaced by
 * `shift(code) + s·slide(code)`, where s is the time since the start of the step. It moves with `slide(code)` relative
 * to its original: along the faces of a sheared box, towards it where spheres grow, and both in a perturbed sheet.
 *
 * Negating a code negates every one of these numbers exactly, so a pair has the same contact time from either side.
 * [daphnis.core.boundary.prepare] takes over those of a boundary.
 */
public class Images {
    private val length = DoubleArray(AXES)

    /** Axis across which images slide; −1 when they are at rest. */
    public var normalAxis: Int = -1
        private set

    /** Axis along which they slide; −1 when they are at rest. */
    public var slideAxis: Int = -1
        private set
    private var velocity = 0.0
    private var velocityAcross = 0.0

    /** See [daphnis.core.boundary.BoundaryConditions.approach]. */
    public var approach: Double = 0.0
        private set
    private var offset = 0.0

    /**
     * From now on images are [period] apart along x, y, z, 0 where there are none, and come nearer at the rate
     * [approach].
     */
    internal fun set(period: (Int) -> Double, approach: Double) {
        for (axis in 0 until AXES) length[axis] = period(axis)
        this.approach = approach
    }

    /**
     * From now on images across [normalAxis] are displaced by [offset] along [slideAxis], slide with [velocity] and
     * move away with [velocityAcross].
     */
    internal fun slide(normalAxis: Int, slideAxis: Int, offset: Double, velocity: Double, velocityAcross: Double) {
        this.normalAxis = normalAxis
        this.slideAxis = slideAxis
        this.offset = offset
        this.velocity = velocity
        this.velocityAcross = velocityAcross
    }

    /** The rate at which images come nearer along [axis]. */
    internal fun approachAlong(axis: Int): Double =
        if (axis == normalAxis && velocityAcross != 0.0) -velocityAcross / length[axis] else approach

    /** Distance of consecutive images along [axis]; 0 when there are none. */
    public fun period(axis: Int): Double = length[axis]

    /** Displacement along [axis] at the start of the step. */
    public fun shift(code: Int, axis: Int): Double {
        if (code == 0) return 0.0
        val own = component(code, axis) * length[axis]
        return if (axis == slideAxis) own + component(code, normalAxis) * offset else own
    }

    /** Velocity along [axis] relative to the original. */
    public fun slide(code: Int, axis: Int): Double = if (code != 0 && axis == slideAxis) {
        component(code, normalAxis) * velocity
    } else if (code != 0 && axis == normalAxis && velocityAcross != 0.0) {
        component(code, normalAxis) * velocityAcross
    } else if (code != 0 && approach != 0.0) {
        -(component(code, axis) * length[axis] * approach)
    } else {
        0.0
    }

    /**
     * Replaces the displacement [d] = (x, y, z) between two spheres by that to the nearest image at the start of the
     * step. Nearest means nearest along each axis separately, with sliding faces first.
     */
    public fun toNearest(d: DoubleArray) {
        if (normalAxis >= 0) {
            val boxes = Math.rint(d[normalAxis] / length[normalAxis])
            d[normalAxis] -= boxes * length[normalAxis]
            d[slideAxis] -= boxes * offset
        }
        for (axis in 0 until AXES) {
            if (axis != normalAxis && length[axis] > 0) d[axis] -= Math.rint(d[axis] / length[axis]) * length[axis]
        }
    }

    /** Displacement at the start of the step of the image at +1 along the shear's normal axis, in [0, L). */
    public val shearOffset: Double get() = offset

    /** Velocity of the image at +1 along the shear's normal axis. */
    public val shearVelocity: Double get() = velocity

    public companion object {
        private const val AXES = 3

        /** How many boxes away along an axis an image may be. */
        public const val FARTHEST: Int = 127

        /** The code of the image [x], [y], [z] boxes away, each within ±[FARTHEST]. */
        @JvmStatic
        public fun code(x: Int, y: Int, z: Int): Int = (x and 0xff) or ((y and 0xff) shl 8) or ((z and 0xff) shl 16)

        /** Boxes away along [axis]. */
        @JvmStatic
        public fun component(code: Int, axis: Int): Int = (code shl (24 - 8 * axis)) shr 24

        /** The code seen from the other sphere of the pair. */
        @JvmStatic
        public fun negated(code: Int): Int = code(-component(code, 0), -component(code, 1), -component(code, 2))
    }
}
