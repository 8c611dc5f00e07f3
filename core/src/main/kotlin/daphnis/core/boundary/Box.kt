package daphnis.core.boundary

import daphnis.core.space.Space

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
 * A [flat] box is a rectangle of the plane z = 0. Along z it is one unit thick and open, so its [volume] is an area.
 *
 * @property space in which particles move
 * @throws IllegalArgumentException unless every `lower < upper`; infinite bounds stand for open axes
 */
public class Box internal constructor(
    public val lowerX: Double,
    public val lowerY: Double,
    public val lowerZ: Double,
    public val upperX: Double,
    public val upperY: Double,
    public val upperZ: Double,
    public val space: Space,
) {
    public constructor(
        lowerX: Double,
        lowerY: Double,
        lowerZ: Double,
        upperX: Double,
        upperY: Double,
        upperZ: Double,
    ) : this(lowerX, lowerY, lowerZ, upperX, upperY, upperZ, Space.VOLUME)

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

    /** Volume, or area where the box is flat. */
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

        /** The rectangle of the given edge lengths in the plane z = 0, centred on the origin. */
        @JvmStatic
        public fun flat(lengthX: Double, lengthY: Double): Box =
            flat(-lengthX / 2, -lengthY / 2, lengthX / 2, lengthY / 2)

        /** The rectangle of the given faces in the plane z = 0. */
        @JvmStatic
        public fun flat(lowerX: Double, lowerY: Double, upperX: Double, upperY: Double): Box =
            Box(lowerX, lowerY, -THIN, upperX, upperY, THIN, Space.PLANE)

        private const val THIN = 0.5

        /** The whole plane z = 0. */
        @JvmField
        public val PLANE: Box = Double.POSITIVE_INFINITY.let { Box(-it, -it, -it, it, it, it, Space.PLANE) }

        /** The whole of space. */
        @JvmField
        public val UNBOUNDED: Box = Double.POSITIVE_INFINITY.let { Box(-it, -it, -it, it, it, it) }
    }
}
