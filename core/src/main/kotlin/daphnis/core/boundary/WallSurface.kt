package daphnis.core.boundary

import daphnis.core.surface.Roughness
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A wall that is not a face of the box: a plane anywhere, a cylinder, or a sphere. Points, vectors and velocities are
 * given along x, y, z, in the units of the positions.
 *
 * @property face what it has of its own, see [WallFace]. Only planes and spheres that are [RoomSide.OUTSIDE] move: a
 *   plane along its normal, a sphere along its direction
 * @property roughness null for a smooth surface; spheres need spins where there is any
 */
public sealed class WallSurface(public val face: WallFace, public val roughness: Roughness?) {
    /** A point of a plane, of the axis of a cylinder, or the centre of a sphere. */
    internal abstract val origin: DoubleArray

    /** The normal of a plane, into the room, or the axis of a cylinder; of length 1, and 0 for a sphere. */
    internal abstract val direction: DoubleArray

    /** How fast the surface itself moves along itself: an angular velocity, or a velocity where [isPlane]. */
    internal abstract val turning: DoubleArray

    /** Along what the surface moves as [WallFace.motion] says. */
    internal open val way: DoubleArray get() = direction
    internal open val isPlane: Boolean get() = false

    /** Infinite for a plane. */
    public open val radius: Double get() = Double.POSITIVE_INFINITY
    public open val side: RoomSide get() = RoomSide.INSIDE

    /** Whether it moves, is thermal, or moves along itself. */
    internal val isDriven: Boolean
        get() = face.motion != null || face.temperature != null || turning.any { it != 0.0 }

    /** Whether the surface is the same everywhere along [axis] (0 = x, 1 = y, 2 = z). */
    internal abstract fun isSameAlong(axis: Int): Boolean

    /** Whether it keeps spheres between [lower] and [upper] along [axis] by itself. */
    internal open fun encloses(axis: Int, lower: Double, upper: Double): Boolean = false

    /** Distance of the point ([x], [y], [z]) from the surface at [time], negative beyond it. */
    @JvmOverloads
    public fun distance(x: Double, y: Double, z: Double, time: Double = 0.0): Double =
        across(x, y, z, time) { px, py, pz, along ->
            val far = sqrt(px * px + py * py + pz * pz)
            if (isPlane) {
                along
            } else if (side == RoomSide.INSIDE) {
                radius - far
            } else {
                far - radius
            }
        }

    /** Writes the unit normal into the room at the point ([x], [y], [z]) to [into]; 0 on the axis or in the centre. */
    internal fun normal(x: Double, y: Double, z: Double, time: Double, into: DoubleArray) {
        across(x, y, z, time) { px, py, pz, _ ->
            val far = sqrt(px * px + py * py + pz * pz)
            val by = if (far == 0.0) 0.0 else (if (side == RoomSide.INSIDE) -1.0 else 1.0) / far
            into[0] = if (isPlane) direction[0] else by * px
            into[1] = if (isPlane) direction[1] else by * py
            into[2] = if (isPlane) direction[2] else by * pz
        }
    }

    /** Tells [use] where a point is from the axis or the centre, and how far it is along the axis or the normal. */
    private inline fun <T> across(
        x: Double,
        y: Double,
        z: Double,
        time: Double,
        use: (px: Double, py: Double, pz: Double, along: Double) -> T,
    ): T {
        val moved = face.motion?.displacement(time) ?: 0.0
        val dx = x - origin[0] - moved * way[0]
        val dy = y - origin[1] - moved * way[1]
        val dz = z - origin[2] - moved * way[2]
        val along = dx * direction[0] + dy * direction[1] + dz * direction[2]
        return use(dx - along * direction[0], dy - along * direction[1], dz - along * direction[2], along)
    }

    protected fun requireSelf() {
        require(face.temperature == null || roughness == null) { "a wall that is thermal cannot be rough" }
        require(turning.size == AXES && turning.all { it.isFinite() }) {
            "the surface moves along itself with ${turning.toList()}; give three finite numbers"
        }
    }

    /**
     * A plane through [point].
     *
     * @param normal into the room, of any length > 0
     * @param belt velocity of the surface along itself, such as that of a belt; it acts on spheres by roughness, or by
     *   a temperature
     */
    public class Plane @JvmOverloads constructor(
        point: List<Double>,
        normal: List<Double>,
        face: WallFace = WallFace(),
        roughness: Roughness? = null,
        belt: List<Double> = STILL,
    ) : WallSurface(face, roughness) {
        override val origin: DoubleArray = vector("point", point)
        override val direction: DoubleArray = unit("normal", normal)
        override val turning: DoubleArray = belt.toDoubleArray()
        override val isPlane: Boolean get() = true

        init {
            requireSelf()
            require(face.motion !is Piston) { "a piston is a face of the box, not a plane" }
            val across = (0 until AXES).sumOf { turning[it] * direction[it] }
            require(abs(across) <= ROUNDING * turning.sumOf { abs(it) }) { "belt is $belt; it must lie in the plane" }
        }

        override fun isSameAlong(axis: Int): Boolean = direction[axis] == 0.0

        override fun toString(): String = "plane, normal ${direction.toList()}, through ${origin.toList()}"
    }

    /**
     * A cylinder around the line through [point] along [axis], which has any length > 0.
     *
     * @param angularVelocity with which its surface turns about [axis], in radians per unit of time
     */
    public class Cylinder @JvmOverloads constructor(
        point: List<Double>,
        axis: List<Double>,
        override val radius: Double,
        override val side: RoomSide = RoomSide.INSIDE,
        face: WallFace = WallFace(),
        roughness: Roughness? = null,
        public val angularVelocity: Double = 0.0,
    ) : WallSurface(face, roughness) {
        override val origin: DoubleArray = vector("point", point)
        override val direction: DoubleArray = unit("axis", axis)
        override val turning: DoubleArray = DoubleArray(AXES) { angularVelocity * direction[it] }

        init {
            requireSelf()
            requireRadius(radius)
            require(face.motion == null) { "a cylinder does not move; it turns" }
        }

        override fun isSameAlong(axis: Int): Boolean = abs(direction[axis]) == 1.0

        override fun encloses(axis: Int, lower: Double, upper: Double): Boolean = side == RoomSide.INSIDE &&
            direction[axis] == 0.0 &&
            origin[axis] - radius >= lower &&
            origin[axis] + radius <= upper

        override fun toString(): String =
            "cylinder of radius $radius along ${direction.toList()}, room ${side.name.lowercase()}"
    }

    /**
     * A sphere around [centre]: a vessel, or with [RoomSide.OUTSIDE] a body that is fixed, or moves as told.
     *
     * @param angularVelocity with which its surface turns, along x, y, z, in radians per unit of time
     * @param along the direction in which it moves as [WallFace.motion] says, of any length > 0
     */
    public class Sphere @JvmOverloads constructor(
        centre: List<Double>,
        override val radius: Double,
        override val side: RoomSide = RoomSide.INSIDE,
        face: WallFace = WallFace(),
        roughness: Roughness? = null,
        angularVelocity: List<Double> = STILL,
        along: List<Double> = listOf(0.0, 0.0, 1.0),
    ) : WallSurface(face, roughness) {
        override val origin: DoubleArray = vector("centre", centre)
        override val direction: DoubleArray = DoubleArray(AXES)
        override val turning: DoubleArray = angularVelocity.toDoubleArray()
        override val way: DoubleArray = unit("along", along)

        init {
            requireSelf()
            requireRadius(radius)
            require(face.motion == null || side == RoomSide.OUTSIDE) { "a sphere around the room does not move" }
            require(face.motion == null || face.motion is WallMotion.Steady || face.motion is WallMotion.Sine) {
                "a sphere moves steadily or as a sine"
            }
        }

        override fun isSameAlong(axis: Int): Boolean = false

        override fun encloses(axis: Int, lower: Double, upper: Double): Boolean = side == RoomSide.INSIDE &&
            origin[axis] - radius >= lower &&
            origin[axis] + radius <= upper

        override fun toString(): String = "sphere of radius $radius, room ${side.name.lowercase()}"
    }

    private companion object {
        val STILL = listOf(0.0, 0.0, 0.0)
        const val ROUNDING = 1e-12

        fun vector(name: String, components: List<Double>): DoubleArray {
            require(components.size == AXES && components.all { it.isFinite() }) {
                "$name is $components; give three finite numbers"
            }
            return components.toDoubleArray()
        }

        /** Exact along an axis, and otherwise to rounding. */
        fun unit(name: String, components: List<Double>): DoubleArray {
            val v = vector(name, components)
            val scale = v.maxOf { abs(it) }
            require(scale > 0) { "$name is $components; it must have a length > 0" }
            for (k in v.indices) v[k] /= scale
            val length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
            for (k in v.indices) v[k] = v[k] / length + 0.0
            return v
        }

        fun requireRadius(radius: Double) {
            require(radius > 0 && radius.isFinite()) { "radius is $radius; it must be > 0" }
        }
    }
}

/** On which side of a surface the spheres are. */
public enum class RoomSide { INSIDE, OUTSIDE }
