package daphnis.core.scenario

import daphnis.core.boundary.RoomSide
import daphnis.core.boundary.WallFace
import daphnis.core.boundary.WallSurface
import daphnis.core.input.ValueCheck
import daphnis.core.surface.Roughness
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * A wall that is not a face of the box, see [WallSurface]. Points, vectors and velocities are three numbers, along x,
 * y, z.
 *
 * @property restitution its own; that of the walls when left out
 * @property roughness of the surface; smooth when left out
 * @property temperature of a thermal wall
 */
@Serializable
public sealed interface WallSurfaceSpec {
    public val restitution: Double?
    public val roughness: RoughnessSpec?
    public val temperature: Double?

    /** A description for a reader: [number] writes numbers. */
    public fun inWords(number: DoubleFunction<String>): String

    /** @property belt velocity of the surface along itself */
    @Serializable
    @SerialName("plane")
    public class Plane @JvmOverloads constructor(
        public val point: List<Double>,
        public val normal: List<Double>,
        override val restitution: Double? = null,
        override val roughness: RoughnessSpec? = null,
        override val temperature: Double? = null,
        public val motion: WallMotionSpec? = null,
        public val belt: List<Double> = NONE,
    ) : WallSurfaceSpec {
        override fun inWords(number: DoubleFunction<String>): String =
            "plane with normal ${number.all(normal)} through ${number.all(point)}" + traits(number) +
                (motion?.let { ", ${it.inWords(number)}" } ?: "") +
                if (belt.any { it != 0.0 }) ", belt with ${number.all(belt)}" else ""
    }

    /**
     * @property point on the axis
     * @property room where the spheres are
     * @property angularVelocity with which it turns about [axis], radians per unit of time
     */
    @Serializable
    @SerialName("cylinder")
    public class Cylinder @JvmOverloads constructor(
        public val axis: List<Double>,
        public val radius: Double,
        public val point: List<Double> = NONE,
        public val room: RoomName = RoomName.INSIDE,
        override val restitution: Double? = null,
        override val roughness: RoughnessSpec? = null,
        override val temperature: Double? = null,
        public val angularVelocity: Double = 0.0,
    ) : WallSurfaceSpec {
        override fun inWords(number: DoubleFunction<String>): String =
            "cylinder of radius ${number.apply(radius)} along ${number.all(axis)}" + place(point, room, number) +
                traits(number) +
                if (angularVelocity != 0.0) ", turns with ${number.apply(angularVelocity)} rad per unit of time" else ""
    }

    /**
     * @property room where the spheres are: outside, it is a body that is fixed, or moves as told
     * @property angularVelocity with which it turns, radians per unit of time, along x, y, z
     * @property along direction of its [motion]
     */
    @Serializable
    @SerialName("sphere")
    public class Sphere @JvmOverloads constructor(
        public val radius: Double,
        public val centre: List<Double> = NONE,
        public val room: RoomName = RoomName.INSIDE,
        override val restitution: Double? = null,
        override val roughness: RoughnessSpec? = null,
        override val temperature: Double? = null,
        public val angularVelocity: List<Double> = NONE,
        public val motion: WallMotionSpec? = null,
        public val along: List<Double> = listOf(0.0, 0.0, 1.0),
    ) : WallSurfaceSpec {
        override fun inWords(number: DoubleFunction<String>): String =
            "sphere of radius ${number.apply(radius)}" + place(centre, room, number) + traits(number) +
                (motion?.let { ", ${it.inWords(number)} along ${number.all(along)}" } ?: "") +
                if (angularVelocity.any { it != 0.0 }) ", turns with ${number.all(angularVelocity)}" else ""
    }

    public companion object {
        internal const val KEY = "boundary.surfaces"
        private val NONE = listOf(0.0, 0.0, 0.0)

        private fun DoubleFunction<String>.all(vector: List<Double>) = "(${vector.joinToString(" ") { apply(it) }})"

        private fun place(at: List<Double>, room: RoomName, number: DoubleFunction<String>): String {
            val where = if (at.all { it == 0.0 }) "" else " at ${number.all(at)}"
            return where + if (room == RoomName.OUTSIDE) ", spheres outside" else ""
        }

        private fun WallSurfaceSpec.traits(number: DoubleFunction<String>): String = listOfNotNull(
            restitution?.let { "restitution ${number.apply(it)}" },
            temperature?.let { "thermal at ${number.apply(it)}" },
            roughness?.inWords(number),
        ).joinToString("") { ", $it" }
    }
}

/** On which side of a surface the spheres are. */
@Serializable
public enum class RoomName(internal val side: RoomSide) {
    @SerialName("inside")
    INSIDE(RoomSide.INSIDE),

    @SerialName("outside")
    OUTSIDE(RoomSide.OUTSIDE),
}

/** The surface of what stands at [key]. */
internal fun WallSurfaceSpec.surface(key: String, check: ValueCheck): WallSurface {
    fun vector(name: String, values: List<Double>): List<Double> {
        check.that("$key.$name", values, values.size == AXES) { "must be three numbers, along x, y and z" }
        values.forEachIndexed { k, it ->
            check.that("$key.$name[$k]", it, abs(it) <= ValueCheck.MOST) { "must be in ±${ValueCheck.MOST}" }
        }
        return values
    }

    fun direction(name: String, values: List<Double>): List<Double> = vector(name, values).also {
        check.that("$key.$name", it, it.any { c -> c != 0.0 }) { "must have a length; it is a direction" }
    }
    restitution?.let { check.fraction("$key.restitution", it) }
    temperature?.let { check.positive("$key.temperature", it) }
    check.must("$key.restitution", restitution == null || temperature == null) {
        "does not matter for a wall with a temperature; give one of the two"
    }
    check.must("$key.roughness.momentFactor", roughness?.momentFactor == null) {
        "is that of spheres; give it as roughness.momentFactor"
    }
    val law: Roughness? = roughness?.law("$key.roughness", check)
    check.must("$key.temperature", temperature == null || law == null) {
        "is that of a thermal wall, which cannot be rough"
    }
    fun face(motion: WallMotionSpec?) = WallFace(restitution, motion?.motion("$key.motion", check), temperature)
    return when (this) {
        is WallSurfaceSpec.Plane -> {
            val n = direction("normal", normal)
            vector("belt", belt).forEachIndexed { k, it -> check.speed("$key.belt[$k]", it) }
            // Scaled first, since squares of the smallest numbers are 0.
            val scale = n.maxOf { abs(it) }
            val across =
                (0 until AXES).sumOf { belt[it] * (n[it] / scale) } / sqrt(n.sumOf { (it / scale) * (it / scale) })
            check.that("$key.belt", belt, abs(across) <= ROUNDING * belt.sumOf { abs(it) }) {
                "must be along the plane; what moves along the normal is a motion"
            }
            check.must("$key.motion", motion !is WallMotionSpec.Piston) {
                "is of a piston, which must be a face of the box; give it in ${WallFacesSpec.KEY}"
            }
            WallSurface.Plane(vector("point", point), n, face(motion), law, belt)
        }
        is WallSurfaceSpec.Cylinder -> {
            check.extent("$key.radius", radius)
            check.speed("$key.angularVelocity", angularVelocity * radius)
            WallSurface.Cylinder(
                vector("point", point),
                direction("axis", axis),
                radius,
                room.side,
                face(null),
                law,
                angularVelocity,
            )
        }
        is WallSurfaceSpec.Sphere -> {
            check.extent("$key.radius", radius)
            vector("angularVelocity", angularVelocity).forEachIndexed { k, it ->
                check.speed("$key.angularVelocity[$k]", it * radius)
            }
            val mayMove = room == RoomName.OUTSIDE &&
                (motion is WallMotionSpec.Sine || motion is WallMotionSpec.Steady)
            check.must("$key.motion", motion == null || mayMove) {
                "is of a sphere with the room outside, and steady or a sine"
            }
            val way = direction("along", along)
            WallSurface.Sphere(vector("centre", centre), radius, room.side, face(motion), law, angularVelocity, way)
        }
    }
}

private const val AXES = 3
private const val ROUNDING = 1e-12
