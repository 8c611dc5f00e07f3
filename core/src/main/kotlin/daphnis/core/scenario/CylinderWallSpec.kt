package daphnis.core.scenario

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.surface.RoughnessSpec
import daphnis.core.wall.CylinderWall
import daphnis.core.wall.Wall
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction
import kotlin.math.PI
import kotlin.math.abs

/**
 * @property point on the axis
 * @property room where the spheres are
 * @property angularVelocity with which it turns about [axis], radians per unit of time
 */
@Serializable
@SerialName("cylinder")
@Described("around the line through `point` along `axis`, about which it may turn")
public class CylinderWallSpec @JvmOverloads constructor(
    @Described("direction of its axis")
    public val axis: List<Double>,
    @Described("a length")
    public val radius: Double,
    @Described("of the axis; default [0, 0, 0]")
    public val point: List<Double> = NOWHERE,
    @Described("`inside` or `outside`, where spheres are; default `inside`")
    public val room: RoomName = RoomName.INSIDE,
    @Described("in [0, 1]; default that of the walls")
    override val restitution: Double? = null,
    @Described("its surface, whatever `boundary.roughness` says; default smooth")
    override val roughness: RoughnessSpec? = null,
    @Described("of a thermal wall, mass · speed²; default reflects")
    override val temperature: Double? = null,
    @Described("about the axis, radians per unit of time; acts by `roughness` alone; default 0")
    public val angularVelocity: Double = 0.0,
) : WallSurfaceSpec {
    override val slides: Boolean get() = angularVelocity != 0.0

    override fun surface(key: String, check: ValueCheck): Wall {
        val its = WallTraits(this, key, check)
        check.extent("$key.radius", radius)
        check.speed("$key.angularVelocity", angularVelocity * radius)
        val (at, along) = its.vector("point", point) to its.direction("axis", axis)
        return CylinderWall(at, along, radius, room.side, its.face, its.roughness, angularVelocity)
    }

    override fun extent(axis: Int): ClosedFloatingPointRange<Double>? =
        around(point[axis], radius, room).takeIf { this.axis[axis] == 0.0 }

    /** Rings, and lines along its axis. */
    override fun curves(corners: List<DoubleArray>, displacement: Double): List<SurfaceCurve> {
        val d = unit(axis)
        val (u, v) = across(d)
        val middle = point.toDoubleArray()
        val along = corners.map { dot(it, d) - dot(middle, d) }
        val (from, to) = along.min() to along.max()
        val isLong = to - from > toleranceOf(corners)
        val rings = if (d.any { abs(it) == 1.0 }) 1 else RINGS
        val curves = (0..if (isLong) rings else 0).map { n ->
            val s = from + (to - from) * n / rings
            val centre = DoubleArray(AXES) { middle[it] + s * d[it] }
            SurfaceCurve { t -> onCircle(centre, u, v, radius, 2 * PI * t) }
        }
        if (!isLong) return curves
        return curves + (0 until LINES).map { n ->
            val foot = onCircle(middle, u, v, radius, 2 * PI * n / LINES)
            SurfaceCurve { t -> DoubleArray(AXES) { foot[it] + (from + (to - from) * t) * d[it] } }
        }
    }

    override fun named(length: DoubleFunction<String>): String =
        "cylinder of radius ${length.apply(radius)} along ${directionInWords(axis)}" +
            (if (slides) " that turns" else "") + outside(room)

    override fun inWords(number: DoubleFunction<String>): String =
        "cylinder of radius ${number.apply(radius)} along ${number.all(axis)}" + place(point, room, number) +
            traits(number) + if (slides) ", turns with ${number.apply(angularVelocity)} rad per unit of time" else ""
}

/** Along an axis, of what is round and keeps spheres inside. */
internal fun around(middle: Double, radius: Double, room: RoomName): ClosedFloatingPointRange<Double>? =
    (middle - radius..middle + radius).takeIf { room == RoomName.INSIDE }

private const val LINES = 8
private const val RINGS = 8
