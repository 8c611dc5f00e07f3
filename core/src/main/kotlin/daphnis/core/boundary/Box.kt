package daphnis.core.boundary

/**
 * The box of a simulation: `lower ≤ position < upper` on each axis, in units of length.
 *
 * Axes, here and everywhere in daphnis:
 *
 * ```
 *        z   vertical, out of the plane (flattened boxes are thin along z)
 *        │
 *        │      y   across the shear; in Hill's frame along the orbit
 *        │    ╱
 *        │  ╱
 *        └──────── x   along the shear flow; in Hill's frame radially outward
 *
 *   sheared boxes: the mean flow is v_x = γ·y, so the image above the upper y face moves with +γ·L_y
 *
 *        y ▲   image:  ○ ○ ──▶ +γ L_y
 *          ├─────────────────┐
 *          │  ──────▶        │   upper half flows to +x
 *          │                 │
 *          │        ◀──────  │   lower half flows to −x
 *          └─────────────────┴─▶ x
 *              image: ◀── ○ ○   −γ L_y
 * ```
 *
 * @throws IllegalArgumentException unless every `lower < upper`; infinite bounds stand for open axes
 */
public class Box(
    public val lowerX: Double,
    public val lowerY: Double,
    public val lowerZ: Double,
    public val upperX: Double,
    public val upperY: Double,
    public val upperZ: Double,
) {
    init {
        for (axis in 0..2) {
            require(lower(axis) < upper(axis)) {
                "box along ${"xyz"[axis]} is [${lower(axis)}, ${upper(axis)}]; lower must be below upper"
            }
        }
    }

    public fun lower(axis: Int): Double = if (axis == 0) {
        lowerX
    } else if (axis == 1) {
        lowerY
    } else {
        lowerZ
    }

    public fun upper(axis: Int): Double = if (axis == 0) {
        upperX
    } else if (axis == 1) {
        upperY
    } else {
        upperZ
    }

    public fun length(axis: Int): Double = upper(axis) - lower(axis)

    /** Whether its bounds are finite along every axis. */
    public val isFinite: Boolean get() = length(0).isFinite() && length(1).isFinite() && length(2).isFinite()

    public val volume: Double get() = length(0) * length(1) * length(2)

    public companion object {
        /** A box of the given edge lengths, centred on the origin. */
        @JvmStatic
        public fun centred(lengthX: Double, lengthY: Double, lengthZ: Double): Box = Box(
            -lengthX / 2,
            -lengthY / 2,
            -lengthZ / 2,
            lengthX / 2,
            lengthY / 2,
            lengthZ / 2,
        )

        /** The whole of space. */
        @JvmField
        public val UNBOUNDED: Box = Double.POSITIVE_INFINITY.let { Box(-it, -it, -it, it, it, it) }
    }
}
