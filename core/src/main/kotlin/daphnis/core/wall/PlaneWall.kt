package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.surface.Roughness
import kotlin.math.abs

/**
 * A plane through [point], which moves along its normal. A [Piston] is a face of the box, and no other plane.
 *
 * @param normal into the room, of any length > 0
 * @param belt velocity of the surface along itself, such as that of a belt; it acts on spheres by roughness, or by a
 *   temperature
 */
public open class PlaneWall @JvmOverloads constructor(
    point: List<Double>,
    normal: List<Double>,
    face: WallFace = WallFace(),
    roughness: Roughness? = null,
    belt: List<Double> = STILL,
) : Wall(face, roughness) {
    internal val origin: DoubleArray = vector("point", point)

    /** The unit normal, into the room. */
    internal val direction: DoubleArray = unit("normal", normal)
    internal val belt: DoubleArray = vector("belt", belt)

    /** 1 where it moves along its normal, −1 where it moves against that. */
    internal open val way: Double get() = 1.0
    internal open val mayBePiston: Boolean get() = false

    init {
        requireSelf()
        require(mayBePiston || motion?.isKnownAhead != false) { "a piston is a face of the box, not a plane" }
        val across = (0 until AXES).sumOf { belt[it] * direction[it] }
        require(abs(across) <= ROUNDING * belt.sumOf { abs(it) }) { "belt is $belt; it must lie in the plane" }
    }

    override val glides: Boolean get() = belt.any { it != 0.0 }

    override fun glides(axis: Int): Boolean = belt[axis] != 0.0

    override fun distanceAt(x: Double, y: Double, z: Double, moved: Double): Double {
        val by = moved * way
        val dx = x - origin[0] - by * direction[0]
        val dy = y - origin[1] - by * direction[1]
        val dz = z - origin[2] - by * direction[2]
        return dx * direction[0] + dy * direction[1] + dz * direction[2]
    }

    override fun normal(x: Double, y: Double, z: Double, time: Double, into: DoubleArray) {
        direction.copyInto(into)
    }

    override fun isSameAlong(axis: Int): Boolean = direction[axis] == 0.0

    override val farthest: Double get() = origin.maxOf { abs(it) }

    override fun cut(at: DoubleArray, axis: Int, into: DoubleArray) {
        val along = distance(at[0], at[1], at[2])
        val slope = direction[axis]
        into[0] = if (slope > 0) {
            -along / slope
        } else if (slope < 0 || along >= 0) {
            Double.NEGATIVE_INFINITY
        } else {
            Double.POSITIVE_INFINITY
        }
        into[1] = if (slope < 0) {
            -along / slope
        } else if (slope > 0 || along >= 0) {
            Double.POSITIVE_INFINITY
        } else {
            Double.NEGATIVE_INFINITY
        }
    }

    override fun contact(number: Int, walls: WallSet, law: CollisionLaw): ContactWall =
        PlaneContact(this, number, walls, law)

    override fun toString(): String = "plane, normal ${direction.toList()}, through ${origin.toList()}"

    private companion object {
        const val ROUNDING = 1e-12
    }
}

/**
 * The face of [number] of a box, −x, +x, −y, +y, −z, +z from 0, which is at [place] while it rests. Its motion is along
 * the axis.
 */
internal class FaceWall(number: Int, val place: Double, face: WallFace, roughness: Roughness?) :
    PlaneWall(
        List(AXES) { if (it == number shr 1) place else 0.0 },
        List(AXES) { if (it == number shr 1) inward(number) else 0.0 },
        face,
        roughness,
    ) {
    override val way: Double = inward(number)
    override val mayBePiston: Boolean get() = true

    override fun contact(number: Int, walls: WallSet, law: CollisionLaw): ContactWall =
        FaceContact(this, number, walls, law)

    companion object {
        /** 1 where the room is above the face of [number], −1 where it is below. */
        fun inward(number: Int): Double = if (number and 1 == 0) 1.0 else -1.0
    }
}
