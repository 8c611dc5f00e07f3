package daphnis.core.scenario

import daphnis.core.initial.SizesSpec
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
    public val name: String,
    public val share: Double? = null,
    public val count: Int? = null,
    public val sizes: SizesSpec,
    public val density: Double = 1.0,
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
    public val between: List<String>,
    public val restitution: RestitutionSpec? = null,
    public val roughness: RoughnessSpec? = null,
    @EncodeDefault(EncodeDefault.Mode.NEVER) public val interaction: InteractionSpec? = null,
)
