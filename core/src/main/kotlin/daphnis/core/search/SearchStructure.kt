package daphnis.core.search

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** How the contact search divides space. It affects only the time of the search, not the trajectory. */
@Serializable
public enum class SearchStructure {
    /** One regular grid for all sizes, as in the paper. */
    @SerialName("grid")
    GRID,

    /** A hierarchy of grids, with a finer one for each class of smaller spheres. */
    @SerialName("tree")
    LEVELS,

    /**
     * The one of the two, with the number of classes, that is expected to have fewer pairs to check, chosen for each
     * step.
     */
    @SerialName("auto")
    AUTO,
}
