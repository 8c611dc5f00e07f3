package daphnis.core.step

import daphnis.core.api.EngineApi
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.collision.CollisionCounters
import daphnis.core.collision.CollisionLaw
import daphnis.core.collision.CollisionRecord
import daphnis.core.population.Population
import daphnis.core.search.SearchStructure

/**
 * The input of one step. The object is reused from step to step.
 *
 * @property law the physics of a collision
 * @property counters to which the engine adds its counts once the step has succeeded; a step that throws adds
 *   nothing
 * @property search how neighbours are found
 * @property record where collisions are to be written in order, or null when they are not wanted
 */
@EngineApi
public class CollisionStep @JvmOverloads constructor(
    public val population: Population,
    public val boundary: BoundaryConditions,
    public val law: CollisionLaw,
    public val counters: CollisionCounters,
    public val search: SearchStructure = SearchStructure.AUTO,
) {
    /** Time at the start of the step. */
    public var start: Double = 0.0

    /** Length of the step, > 0. */
    public var duration: Double = 0.0
    public var record: CollisionRecord? = null

    /** Steps that should follow this one; it affects only the time that they take. */
    public var toCome: Long = UNKNOWN

    @EngineApi
    public companion object {
        /** Where nobody knows how many steps are to come: as if there were no end. */
        public const val UNKNOWN: Long = Long.MAX_VALUE
    }
}
