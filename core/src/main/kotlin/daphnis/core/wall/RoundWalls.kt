package daphnis.core.wall

import daphnis.core.collision.WallImpact
import daphnis.core.surface.Roughness
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A cylinder or a sphere: the gap is ±(ρ² − q²), where ρ is the distance at contact, the difference of the radii, or
 * their sum where the room is outside. On a straight path this is a quadratic in time.
 *
 * @property side where the room is
 * @param turning angular velocity of the surface along x, y, z
 */
public sealed class RoundWall(
    point: List<Double>,
    along: List<Double>?,
    final override val radius: Double,
    public val side: RoomSide,
    face: WallFace,
    roughness: Roughness?,
    way: List<Double>?,
) : CurvedWall(point, along, face, roughness, way) {
    /** Angular velocity along x, y, z. */
    internal abstract val turning: DoubleArray
    private val isInside = side == RoomSide.INSIDE

    /** 1 where the gap is ρ² − q², else −1. */
    private val sign = if (isInside) 1.0 else -1.0

    init {
        require(radius > 0 && radius.isFinite()) { "radius is $radius; it must be > 0" }
    }

    override val leans: Boolean get() = false
    override val glides: Boolean get() = turning.any { it != 0.0 }

    override fun gap(q2: Double, h: Double, r: Double): Double {
        val reach = if (isInside) radius - r else radius + r
        return sign * (reach * abs(reach) - q2)
    }

    override fun rate(qw: Double, h: Double, u: Double, r: Double): Double = -2 * sign * qw

    override fun bending(
        least: Double,
        most: Double,
        h: Double,
        u: Double,
        fall: Double,
        rest: Double,
        r: Double,
    ): Double = if (isInside) -most else least

    override fun distance(q: Double, h: Double): Double = if (isInside) radius - q else q - radius

    override fun meet(
        qx: Double,
        qy: Double,
        qz: Double,
        q: Double,
        across: Double,
        fall: Double,
        impact: WallImpact,
    ) {
        impact.normal(-sign * qx, -sign * qy, -sign * qz)
        impact.length = q
        impact.lean = 0.0
        impact.press = sign * across
    }

    override fun glide(impact: WallImpact) {
        val reach = if (isInside) -radius else radius
        val w = turning
        impact.surface(
            reach * (w[1] * impact.nz - w[2] * impact.ny),
            reach * (w[2] * impact.nx - w[0] * impact.nz),
            reach * (w[0] * impact.ny - w[1] * impact.nx),
        )
    }

    override fun encloses(axis: Int, lower: Double, upper: Double): Boolean = isInside &&
        direction[axis] == 0.0 &&
        origin[axis] - radius >= lower &&
        origin[axis] + radius <= upper

    override fun fits(radius: Double): Boolean = !isInside || this.radius > radius

    override val isRoomWithin: Boolean get() = isInside

    override fun cut(at: DoubleArray, axis: Int, into: DoubleArray) {
        across(at[0], at[1], at[2], motion?.displacement(0.0) ?: 0.0) { px, py, pz, _ ->
            val q = doubleArrayOf(px, py, pz)
            var qq = 0.0
            var qu = 0.0
            var uu = 0.0
            for (k in 0 until AXES) {
                val u = (if (k == axis) 1.0 else 0.0) - direction[axis] * direction[k]
                qq += q[k] * q[k]
                qu += q[k] * u
                uu += u * u
            }
            val square = qu * qu - uu * (qq - radius * radius)
            val isAlong = uu == 0.0 && qq < radius * radius
            val meets = square > 0 && uu > 0
            into[0] = if (meets) {
                (-qu - sqrt(square)) / uu
            } else if (isAlong) {
                Double.NEGATIVE_INFINITY
            } else {
                Double.POSITIVE_INFINITY
            }
            into[1] = if (meets) (-qu + sqrt(square)) / uu else -into[0]
        }
    }
}

/**
 * A cylinder around the line through [point] along [axis], which has any length > 0. It does not move, but may turn.
 *
 * @param angularVelocity with which its surface turns about [axis], in radians per unit of time
 */
public class CylinderWall @JvmOverloads constructor(
    point: List<Double>,
    axis: List<Double>,
    radius: Double,
    side: RoomSide = RoomSide.INSIDE,
    face: WallFace = WallFace(),
    roughness: Roughness? = null,
    public val angularVelocity: Double = 0.0,
) : RoundWall(point, axis, radius, side, face, roughness, axis) {
    override val turning: DoubleArray = DoubleArray(AXES) { angularVelocity * direction[it] }

    init {
        requireSelf(*turning)
        require(motion == null) { "a cylinder does not move; it turns" }
    }

    override fun isSameAlong(axis: Int): Boolean = abs(direction[axis]) == 1.0

    override fun volume(axes: IntRange, lengths: (Int) -> Double): Double? =
        axes.filter { isSameAlong(it) }.fold(PI * radius * radius) { volume, axis -> volume * lengths(axis) }

    override fun toString(): String =
        "cylinder of radius $radius along ${direction.toList()}, room ${side.name.lowercase()}"
}

/**
 * A sphere around [centre]: a vessel, or with [RoomSide.OUTSIDE] a body that is fixed, or moves as told.
 *
 * @param angularVelocity with which its surface turns, along x, y, z, in radians per unit of time
 * @param along the direction in which it moves as [WallFace.motion] says, of any length > 0
 */
public class SphereWall @JvmOverloads constructor(
    centre: List<Double>,
    radius: Double,
    side: RoomSide = RoomSide.INSIDE,
    face: WallFace = WallFace(),
    roughness: Roughness? = null,
    angularVelocity: List<Double> = STILL,
    along: List<Double> = listOf(0.0, 0.0, 1.0),
) : RoundWall(centre, null, radius, side, face, roughness, along) {
    override val turning: DoubleArray = vector("angularVelocity", angularVelocity)

    init {
        requireSelf(*turning)
        require(motion == null || side == RoomSide.OUTSIDE) { "a sphere around the room does not move" }
        require(motion?.isSmooth != false) { "a sphere moves steadily or as a sine" }
    }

    override fun isSameAlong(axis: Int): Boolean = false

    override fun volume(axes: IntRange, lengths: (Int) -> Double): Double? = 4.0 / 3.0 * PI * radius * radius * radius

    override fun toString(): String = "sphere of radius $radius, room ${side.name.lowercase()}"
}
