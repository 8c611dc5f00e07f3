package daphnis.core.population

import daphnis.core.space.Space

/** What sums over velocities have to know of where spheres move. */
public interface Kinematics {
    /** Space in which they move. */
    public val space: Space

    /** The mean flow that is driven, or null when there is none. A granular temperature excludes it. */
    public val meanFlow: MeanFlow?
}
