package daphnis.core.force

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** How gravity among all spheres is summed. */
@Serializable
public enum class GravityMethod {
    /** A tree, within a range: [SelfGravity]. */
    @SerialName("tree")
    TREE,

    /** A mesh and near pairs, in a patch with all of its images: [MeshGravity]. */
    @SerialName("mesh")
    MESH,

    /** Waves along x alone: [RadialGravity]. */
    @SerialName("radial-modes")
    RADIAL_MODES,
}
