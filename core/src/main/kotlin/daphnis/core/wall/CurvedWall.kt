package daphnis.core.wall

import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.WallImpact
import daphnis.core.surface.Roughness
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A surface of revolution, such as a cylinder or a cone, or a sphere. **q** is where a point is from the axis and h how
 * far it is along it, from the [origin]; of a sphere, which has no axis, **q** is all and h is 0. The gap to a sphere
 * of radius r is a smooth function of q² and h: above 0 where it is free, and 0 where it touches. It need not be a
 * length. In a step these are taken relative to the wall.
 *
 * @param along the axis, of any length > 0; null for none
 * @param way along which it moves as its motion says, of any length > 0; that of the axis when not given
 */
public abstract class CurvedWall @JvmOverloads constructor(
    point: List<Double>,
    along: List<Double>?,
    face: WallFace,
    roughness: Roughness?,
    way: List<Double>? = along,
) : Wall(face, roughness) {
    /** The point, not to be written to. */
    public val origin: DoubleArray = vector("point", point)

    /** The axis, of length 1, or 0. */
    public val direction: DoubleArray = if (along == null) DoubleArray(AXES) else unit("axis", along)
    internal val way: DoubleArray = if (way == null) DoubleArray(AXES) else unit("along", way)

    /** Whether the gap depends on h. */
    public open val leans: Boolean get() = true

    /** See above; [q2] is q². */
    public abstract fun gap(q2: Double, h: Double, r: Double): Double

    /** How the [gap] changes, where q² does so with 2 [qw], and [h] with [u]. */
    public abstract fun rate(qw: Double, h: Double, u: Double, r: Double): Double

    /**
     * The least second derivative of the [gap], where that of q² is between [least] and [most], and that of [h] is
     * [fall], in the time [rest] from now on.
     */
    public abstract fun bending(
        least: Double,
        most: Double,
        h: Double,
        u: Double,
        fall: Double,
        rest: Double,
        r: Double,
    ): Double

    /** Distance of a point, negative beyond the surface. */
    public abstract fun distance(q: Double, h: Double): Double

    /**
     * Writes the normal into the room where a sphere at (qx, qy, qz) from the axis touches, its length, which is above
     * 0, and what of it is along the axis; and the acceleration by which the path presses the sphere to the surface,
     * where [q] changes with the second derivative [across], and h with [fall].
     */
    public abstract fun meet(
        qx: Double,
        qy: Double,
        qz: Double,
        q: Double,
        across: Double,
        fall: Double,
        impact: WallImpact,
    )

    /** Writes the velocity of the surface along itself, where the unit normal is known. */
    public open fun glide(impact: WallImpact): Unit = impact.surface(0.0, 0.0, 0.0)

    override fun distanceAt(x: Double, y: Double, z: Double, moved: Double): Double =
        across(x, y, z, moved) { px, py, pz, h -> distance(sqrt(px * px + py * py + pz * pz), h) }

    override fun normal(x: Double, y: Double, z: Double, time: Double, into: DoubleArray) {
        into.fill(0.0)
        across(x, y, z, motion?.displacement(time) ?: 0.0) { px, py, pz, _ ->
            val q = sqrt(px * px + py * py + pz * pz)
            if (q == 0.0) return
            val impact = WallImpact()
            meet(px, py, pz, q, 0.0, 0.0, impact)
            into[0] = impact.nx / impact.length
            into[1] = impact.ny / impact.length
            into[2] = impact.nz / impact.length
        }
    }

    /** Tells [use] where a point is from the axis or the centre, and how far it is along the axis. */
    internal inline fun <T> across(
        x: Double,
        y: Double,
        z: Double,
        moved: Double,
        use: (px: Double, py: Double, pz: Double, along: Double) -> T,
    ): T {
        val dx = x - origin[0] - moved * way[0]
        val dy = y - origin[1] - moved * way[1]
        val dz = z - origin[2] - moved * way[2]
        val along = dx * direction[0] + dy * direction[1] + dz * direction[2]
        return use(dx - along * direction[0], dy - along * direction[1], dz - along * direction[2], along)
    }

    override val farthest: Double get() = maxOf(if (radius.isFinite()) radius else 0.0, origin.maxOf { abs(it) })

    override fun contact(number: Int, walls: WallSet, law: CollisionLaw): ContactWall =
        CurvedContact(this, number, walls, law)
}
