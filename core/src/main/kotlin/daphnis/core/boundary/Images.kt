package daphnis.core.boundary

/**
 * Periodic images as small integers. A code packs how many boxes away an image is along x, y and z, a signed byte each,
 * so 0 is the sphere itself. For a step that starts at time `t₀` the image of a sphere is displaced by `shift(code) +
 * s·slide(code)`, s the time since the start of the step, and moves with `slide(code)` against its original.
 *
 * Negating a code negates every one of these numbers exactly, so a pair has the same contact time from either side.
 */
public class Images {
    private val length = DoubleArray(3)
    private var normalAxis = -1
    private var slideAxis = -1
    private var velocity = 0.0
    private var offset = 0.0

    /** Takes over [boundary] as it stands at [time], the start of a step. */
    public fun prepare(boundary: BoundaryConditions, time: Double) {
        for (axis in 0..2) {
            length[axis] = if (boundary.contactFaces(axis) == ContactFaces.PERIODIC) boundary.box.length(axis) else 0.0
        }
        val shear = boundary.shear
        normalAxis = shear?.normalAxis ?: -1
        slideAxis = shear?.slideAxis ?: -1
        velocity = shear?.velocity ?: 0.0
        offset = shear?.offset(time) ?: 0.0
    }

    /** Displacement along [axis] at the start of the step. */
    public fun shift(code: Int, axis: Int): Double {
        if (code == 0) return 0.0
        val own = component(code, axis) * length[axis]
        return if (axis == slideAxis) own + component(code, normalAxis) * offset else own
    }

    /** Velocity along [axis] against the original. */
    public fun slide(code: Int, axis: Int): Double = if (code != 0 && axis == slideAxis) {
        component(code, normalAxis) * velocity
    } else {
        0.0
    }

    /** Displacement at the start of the step of the image at +1 along the shear's normal axis, in [0, L). */
    public val shearOffset: Double get() = offset

    /** Velocity of the image at +1 along the shear's normal axis. */
    public val shearVelocity: Double get() = velocity

    public companion object {
        /** How many boxes away along an axis an image may be. */
        public const val FARTHEST: Int = 127

        /** The code of the image [x], [y], [z] boxes away, each within ±[FARTHEST]. */
        public fun code(x: Int, y: Int, z: Int): Int = (x and 0xff) or ((y and 0xff) shl 8) or ((z and 0xff) shl 16)

        /** Boxes away along [axis]. */
        public fun component(code: Int, axis: Int): Int = (code shl (24 - 8 * axis)) shr 24

        /** The code seen from the other sphere of the pair. */
        public fun negated(code: Int): Int = code(-component(code, 0), -component(code, 1), -component(code, 2))
    }
}
