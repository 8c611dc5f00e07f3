package daphnis.core.scenario

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.wall.WallFace
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction

/** What a wall has of its own, see [WallFace]. */
@Serializable
public class WallFaceSpec @JvmOverloads constructor(
    @Described("coefficient of restitution, in [0, 1]; default that of all walls")
    public val restitution: Double? = null,
    @Described("how the wall moves along its axis; default rests")
    public val motion: WallMotionSpec? = null,
    @Described(
        "of a thermal wall, mass · speed²: spheres leave with the velocities of a gas of that temperature; " +
            "default reflects",
    )
    public val temperature: Double? = null,
) {
    /** Whether it gives energy to what meets it. */
    internal val drives: Boolean get() = temperature != null || motion?.moves == true

    internal fun inWords(number: DoubleFunction<String>): String = listOfNotNull(
        restitution?.let { "restitution ${number.apply(it)}" },
        motion?.inWords(number),
        temperature?.let { "thermal at ${number.apply(it)}" },
    ).joinToString(", ")

    internal fun face(key: String, check: ValueCheck): WallFace {
        restitution?.let { check.fraction("$key.restitution", it) }
        temperature?.let { check.positive("$key.temperature", it) }
        check.must("$key.restitution", restitution == null || temperature == null) {
            "does not matter for a wall with a temperature; give one of the two"
        }
        check.must("$key.temperature", temperature == null || motion?.isFree != true) {
            "is of a piston; a piston cannot be thermal"
        }
        return WallFace(restitution, motion?.motion("$key.motion", check), temperature)
    }
}

/** What the lower and the upper wall across each axis have of their own. */
@Serializable
public class WallFacesSpec @JvmOverloads constructor(
    @Described("the face at the least x; default as all")
    public val lowerX: WallFaceSpec? = null,
    @Described("the face at the greatest x; default as all")
    public val upperX: WallFaceSpec? = null,
    @Described("the face at the least y; default as all")
    public val lowerY: WallFaceSpec? = null,
    @Described("the face at the greatest y; default as all")
    public val upperY: WallFaceSpec? = null,
    @Described("the face at the least z; default as all")
    public val lowerZ: WallFaceSpec? = null,
    @Described("the face at the greatest z; default as all")
    public val upperZ: WallFaceSpec? = null,
) {
    internal val named: List<WallFaceSpec?> get() = listOf(lowerX, upperX, lowerY, upperY, lowerZ, upperZ)

    /** Where those that impacts push begin, by face: position and velocity. */
    internal val pistons: Map<Int, List<Double>>
        get() = buildMap { named.forEachIndexed { face, spec -> spec?.motion?.begin?.let { put(face, it) } } }

    /** The same with pistons at the position and speed in [states], by face. */
    internal fun withPistons(states: Map<Int, List<Double>>): WallFacesSpec {
        val all = named.mapIndexed { face, spec ->
            val state = states[face]
            if (state ==
                null
            ) {
                spec
            } else {
                spec?.run { WallFaceSpec(restitution, motion?.beginningWith(state), temperature) }
            }
        }
        return WallFacesSpec(all[0], all[1], all[2], all[3], all[4], all[5])
    }

    /** The faces for a reader, such as `, lowerZ sine of amplitude 1, frequency 2`. */
    internal fun inWords(number: DoubleFunction<String>): String {
        val told = named.mapIndexedNotNull { face, spec -> spec?.let { "${NAMES[face]} ${it.inWords(number)}" } }
        return if (told.isEmpty()) "" else told.joinToString("; ", prefix = ", ")
    }

    /** Of the faces −x, +x, −y, +y, −z, +z; those across [axes] are walls. */
    internal fun faces(axes: String, check: ValueCheck): List<WallFace?> = named.mapIndexed { face, spec ->
        val key = "$KEY.${NAMES[face]}"
        check.must(key, spec == null || "xyz"[face / 2] in axes) { "is of no wall; there are walls across $axes" }
        spec?.face(key, check)
    }

    internal companion object {
        const val KEY = "boundary.faces"
        val NAMES = listOf("lowerX", "upperX", "lowerY", "upperY", "lowerZ", "upperZ")
    }
}
