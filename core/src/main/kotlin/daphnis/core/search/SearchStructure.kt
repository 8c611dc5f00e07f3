package daphnis.core.search

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** How the contact search divides space. The trajectory does not depend on it, only the time it takes. */
@Serializable
public enum class SearchStructure {
    /** One regular grid for all sizes, as in the paper. */
    @SerialName("grid")
    GRID,

    /** By size: a hierarchy of grids, a finer one for each class of smaller spheres. */
    @SerialName("tree")
    LEVELS,

    /** That of the two, and that number of classes, which promises fewer pairs to look at, chosen for each step. */
    @SerialName("auto")
    AUTO,
}
