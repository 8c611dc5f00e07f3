package daphnis.core.scenario

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.surface.RoughnessSpec
import daphnis.core.wall.SphereWall
import daphnis.core.wall.Wall
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction
import kotlin.math.PI

/**
 * @property room where the spheres are: outside, it is a body that is fixed, or moves as told
 * @property angularVelocity with which it turns, radians per unit of time, along x, y, z
 * @property along direction of its [motion]
 */
@Serializable
@SerialName("sphere")
@Described("a vessel, or a body that is fixed or moves as told")
public class SphereWallSpec @JvmOverloads constructor(
    @Described("a length")
    public val radius: Double,
    @Described("x, y, z; default [0, 0, 0]")
    public val centre: List<Double> = NOWHERE,
    @Described("`inside` or `outside`, where spheres are; default `inside`")
    public val room: RoomName = RoomName.INSIDE,
    @Described("in [0, 1]; default that of the walls")
    override val restitution: Double? = null,
    @Described("its surface, whatever `boundary.roughness` says; default smooth")
    override val roughness: RoughnessSpec? = null,
    @Described("of a thermal wall, mass · speed²; default reflects")
    override val temperature: Double? = null,
    @Described("radians per unit of time; acts by `roughness` alone; default [0, 0, 0]")
    public val angularVelocity: List<Double> = NOWHERE,
    @Described("`steady` or `sine`; default rests")
    override val motion: WallMotionSpec? = null,
    @Described("direction of the motion; default [0, 0, 1]")
    public val along: List<Double> = listOf(0.0, 0.0, 1.0),
) : WallSurfaceSpec {
    override val slides: Boolean get() = angularVelocity.any { it != 0.0 }

    override fun surface(key: String, check: ValueCheck): Wall {
        val its = WallTraits(this, key, check)
        check.extent("$key.radius", radius)
        its.vector("angularVelocity", angularVelocity).forEachIndexed { k, it ->
            check.speed("$key.angularVelocity[$k]", it * radius)
        }
        check.must("$key.motion", motion == null || room == RoomName.OUTSIDE && motion.isSmooth) {
            "is of a sphere with the room outside, and steady or a sine"
        }
        val (at, way) = its.vector("centre", centre) to its.direction("along", along)
        return SphereWall(at, radius, room.side, its.face, its.roughness, angularVelocity, way)
    }

    override fun extent(axis: Int): ClosedFloatingPointRange<Double>? = around(centre[axis], radius, room)

    /** Great circles. */
    override fun curves(corners: List<DoubleArray>, displacement: Double): List<SurfaceCurve> {
        val way = unit(along)
        val middle = DoubleArray(AXES) { centre[it] + displacement * way[it] }
        return (0 until AXES).map { axis ->
            val (u, v) = across(DoubleArray(AXES) { if (it == axis) 1.0 else 0.0 })
            SurfaceCurve { t -> onCircle(middle, u, v, radius, 2 * PI * t) }
        }
    }

    override fun named(length: DoubleFunction<String>): String = "sphere of radius ${length.apply(radius)}" +
        (if (motion != null) " that moves" else "") + (if (slides) " that turns" else "") + outside(room)

    override fun inWords(number: DoubleFunction<String>): String =
        "sphere of radius ${number.apply(radius)}" + place(centre, room, number) + traits(number) +
            (motion?.let { ", ${it.inWords(number)} along ${number.all(along)}" } ?: "") +
            if (slides) ", turns with ${number.all(angularVelocity)}" else ""
}
