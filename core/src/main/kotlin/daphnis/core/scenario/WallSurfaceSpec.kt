package daphnis.core.scenario

import daphnis.core.input.Kind
import daphnis.core.input.Kinds
import daphnis.core.input.ValueCheck
import daphnis.core.surface.Roughness
import daphnis.core.surface.RoughnessSpec
import daphnis.core.wall.RoomSide
import daphnis.core.wall.Wall
import daphnis.core.wall.WallFace
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction
import kotlin.math.abs

/**
 * A wall that is not a face of the box as a scenario describes it, see [Wall]: what others ask of a wall is asked
 * here, and nobody asks which one it is. Points, vectors and velocities are three numbers, along x, y, z.
 *
 * @property restitution its own; that of the walls when left out
 * @property roughness of the surface; smooth when left out
 * @property temperature of a thermal wall
 */
@Serializable(WallSurfaceKinds::class)
public interface WallSurfaceSpec {
    public val restitution: Double?
    public val roughness: RoughnessSpec?
    public val temperature: Double?

    /** How it moves; null for at rest. */
    public val motion: WallMotionSpec? get() = null

    /** Whether the surface moves along itself: it turns, or is a belt. Then what touches it flows along. */
    public val slides: Boolean get() = false

    /**
     * The surface of what stands at [key].
     *
     * @throws daphnis.core.input.InputException for values that are wrong
     */
    public fun surface(key: String, check: ValueCheck): Wall

    /** Between which coordinates it keeps spheres along [axis]; null where it does not. */
    public fun extent(axis: Int): ClosedFloatingPointRange<Double>? = null

    /** What is drawn of it where it has moved by [displacement] and all that is seen has these [corners]. */
    public fun curves(corners: List<DoubleArray>, displacement: Double): List<SurfaceCurve> = emptyList()

    /** A short name for a reader; [length] writes a length with its unit. */
    public fun named(length: DoubleFunction<String>): String

    /** A description for a reader: [number] writes numbers. */
    public fun inWords(number: DoubleFunction<String>): String
}

/** A curve on a surface: the place [at] a parameter from 0 to 1. */
public class SurfaceCurve @JvmOverloads constructor(
    public val isStraight: Boolean = false,
    public val at: DoubleFunction<DoubleArray>,
)

/** The walls besides faces of the box that a scenario can name. */
internal object WallSurfaceKinds : Kinds<WallSurfaceSpec>(
    WallSurfaceSpec::class,
    listOf(
        Kind(PlaneWallSpec::class, PlaneWallSpec.serializer()),
        Kind(CylinderWallSpec::class, CylinderWallSpec.serializer()),
        Kind(SphereWallSpec::class, SphereWallSpec.serializer()),
    ),
)

/** On which side of a surface the spheres are. */
@Serializable
public enum class RoomName(internal val side: RoomSide) {
    @SerialName("inside")
    INSIDE(RoomSide.INSIDE),

    @SerialName("outside")
    OUTSIDE(RoomSide.OUTSIDE),
}

/** Whether it gives energy to what meets it. */
internal val WallSurfaceSpec.drives: Boolean
    get() = temperature != null || slides || motion?.moves == true

/** What a surface at [key] has besides its shape, with its values checked. */
public class WallTraits(spec: WallSurfaceSpec, private val key: String, private val check: ValueCheck) {
    public val roughness: Roughness?
    public val face: WallFace

    init {
        spec.restitution?.let { check.fraction("$key.restitution", it) }
        spec.temperature?.let { check.positive("$key.temperature", it) }
        check.must("$key.restitution", spec.restitution == null || spec.temperature == null) {
            "does not matter for a wall with a temperature; give one of the two"
        }
        check.must("$key.roughness.momentFactor", spec.roughness?.momentFactor == null) {
            "is that of spheres; give it as roughness.momentFactor"
        }
        roughness = spec.roughness?.law("$key.roughness", check)
        check.must("$key.temperature", spec.temperature == null || roughness == null) {
            "is that of a thermal wall, which cannot be rough"
        }
        face = WallFace(spec.restitution, spec.motion?.motion("$key.motion", check), spec.temperature)
    }

    /** The vector [name] with its [values]. */
    public fun vector(name: String, values: List<Double>): List<Double> {
        check.that("$key.$name", values, values.size == AXES) { "must be three numbers, along x, y and z" }
        values.forEachIndexed { k, it ->
            check.that("$key.$name[$k]", it, abs(it) <= ValueCheck.MOST) { "must be in ±${ValueCheck.MOST}" }
        }
        return values
    }

    /** The same of one that must have a length. */
    public fun direction(name: String, values: List<Double>): List<Double> = vector(name, values).also {
        check.that("$key.$name", it, it.any { c -> c != 0.0 }) { "must have a length; it is a direction" }
    }
}

/** The key of all surfaces. */
internal const val SURFACES = "boundary.surfaces"

internal val NOWHERE = listOf(0.0, 0.0, 0.0)

internal fun DoubleFunction<String>.all(vector: List<Double>) = "(${vector.joinToString(" ") { apply(it) }})"

internal fun outside(room: RoomName) = if (room == RoomName.OUTSIDE) ", spheres outside" else ""

internal fun place(at: List<Double>, room: RoomName, number: DoubleFunction<String>): String =
    (if (at.all { it == 0.0 }) "" else " at ${number.all(at)}") + outside(room)

internal fun WallSurfaceSpec.traits(number: DoubleFunction<String>): String = listOfNotNull(
    restitution?.let { "restitution ${number.apply(it)}" },
    temperature?.let { "thermal at ${number.apply(it)}" },
    roughness?.inWords(number),
).joinToString("") { ", $it" }

/** An axis by its name, another direction by its components. */
internal fun directionInWords(v: List<Double>): String {
    val along =
        v.indices.singleOrNull { v[it] != 0.0 } ?: return "(${v.joinToString(" ") { "$it".removeSuffix(".0") }})"
    return (if (v[along] < 0) "−" else "") + "xyz"[along]
}
