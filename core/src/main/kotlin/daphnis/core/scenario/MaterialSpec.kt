package daphnis.core.scenario

import daphnis.core.initial.SizesSpec
import daphnis.core.input.Described
import daphnis.core.potential.InteractionSpec
import daphnis.core.surface.RestitutionSpec
import daphnis.core.surface.RoughnessSpec
import kotlinx.serialization.EncodeDefault
import kotlinx.serialization.ExperimentalSerializationApi
import kotlinx.serialization.Serializable

/**
 * A kind of spheres, with a [name] of letters, digits, `_` and `-`. Either each has a [share], of the number of all
 * spheres, or each has a [count]. Masses come from [density] unless [mass] gives every sphere the same.
 */
@Serializable
public class MaterialSpec @JvmOverloads constructor(
    @Described("a word of letters, digits, `_` and `-`")
    public val name: String,
    @Described(
        "part of the number of all spheres, all adding up to 1; of this and `count` exactly one, the same for all " +
            "materials",
    )
    public val share: Double? = null,
    @Described("number of spheres")
    public val count: Int? = null,
    @Described("distribution of radii")
    public val sizes: SizesSpec,
    @Described("mass per volume of a sphere; default 1")
    public val density: Double = 1.0,
    @Described("the same mass for every sphere, in place of `density`; default by `density`")
    public val mass: Double? = null,
) {
    internal companion object {
        /** Spheres that are no bodies, where only these have materials. */
        const val PARTICLES = "particles"
    }
}

/**
 * Impacts of spheres of the two materials that [between] names, in either order, or twice one. What is left out is as for
 * all other spheres.
 */
@OptIn(ExperimentalSerializationApi::class)
@Serializable
public class ContactSpec @JvmOverloads constructor(
    @Described("the names of two materials, which may be the same, in any order; each pair once")
    public val between: List<String>,
    @Described("for impacts of these two; default that of all")
    public val restitution: RestitutionSpec? = null,
    @Described("for these two, without `momentFactor`; default that of all")
    public val roughness: RoughnessSpec? = null,
    @Described("for these two; type `none` switches that of all off; default that of all")
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val interaction: InteractionSpec? = null,
)
