package daphnis.core.scenario

import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.surface.Roughness
import daphnis.core.surface.RoughnessSpec
import kotlinx.serialization.Serializable
import java.util.function.DoubleFunction

/** Surfaces of walls: of [all] that are not named, and of the lower and upper face across each axis. */
@Serializable
public class WallRoughnessSpec @JvmOverloads constructor(
    @Described("of the faces that are not named, without `momentFactor`; default smooth")
    public val all: RoughnessSpec? = null,
    @Described("of the face at the least x; default `all`")
    public val lowerX: RoughnessSpec? = null,
    @Described("of the face at the greatest x; default `all`")
    public val upperX: RoughnessSpec? = null,
    @Described("of the face at the least y; default `all`")
    public val lowerY: RoughnessSpec? = null,
    @Described("of the face at the greatest y; default `all`")
    public val upperY: RoughnessSpec? = null,
    @Described("of the face at the least z; default `all`")
    public val lowerZ: RoughnessSpec? = null,
    @Described("of the face at the greatest z; default `all`")
    public val upperZ: RoughnessSpec? = null,
) {
    private val named: List<RoughnessSpec?> get() = listOf(lowerX, upperX, lowerY, upperY, lowerZ, upperZ)

    /** The surfaces of the walls across [axes] for a reader, such as `smooth; lowerZ sticking 0 …`. */
    internal fun inWords(axes: String, number: DoubleFunction<String>): String {
        val others = "xyz".withIndex().any { (axis, name) ->
            name in axes && (0..1).any { named[2 * axis + it] == null }
        }
        val parts = named.mapIndexedNotNull { face, spec -> spec?.let { "${NAMES[face]} ${it.inWords(number)}" } }
        val rest = (all?.inWords(number) ?: "smooth").takeIf { others }
        return (parts + listOfNotNull(rest?.let { if (parts.isEmpty()) it else "others $it" })).joinToString("; ")
    }

    /** The laws of the faces −x, +x, −y, +y, −z, +z, of which those across [axes] are walls. */
    internal fun laws(axes: String, check: ValueCheck): List<Roughness?> {
        for ((spec, name) in (named + all).zip(NAMES + "all")) {
            check.must("$KEY.$name.momentFactor", spec?.momentFactor == null) {
                "is that of spheres; give it as roughness.momentFactor"
            }
        }
        return named.mapIndexed { face, spec ->
            val isWall = "xyz"[face / 2] in axes
            check.must("$KEY.${NAMES[face]}", spec == null || isWall) { "is of no wall; there are walls across $axes" }
            val said = if (spec == null) "all" else NAMES[face]
            if (isWall) (spec ?: all)?.law("$KEY.$said", check) else null
        }
    }

    private companion object {
        const val KEY = "boundary.roughness"
        val NAMES = listOf("lowerX", "upperX", "lowerY", "upperY", "lowerZ", "upperZ")
    }
}
