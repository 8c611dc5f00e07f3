package daphnis.core.collision

/**
 * What an engine has counted since the start of the run. The first three numbers belong to the trajectory and are the
 * same for every engine. The rest tell how the engine worked.
 */
public class CollisionCounters {
    /** Collisions between two spheres. */
    public var collisions: Long = 0

    /** Reflections at walls. */
    public var wallCollisions: Long = 0

    /** Collisions that the collapse guard made elastic. */
    public var guardActivations: Long = 0

    /** Steps restored and redone because a sphere went farther than the bound on its reach. */
    public var redoneSteps: Long = 0

    /**
     * Steps decided by the serial engine, because a parallel one could not finish its own attempt. Either it noticed a
     * violation of the time order, or its guess led to a collapse, to a step that would be refused, to too much work or
     * memory, or to an exception from the laws of the collision. A step that the serial engine cannot finish either
     * throws, and is not counted.
     */
    public var causalityReplays: Long = 0

    /** Adds what [other] counts. */
    internal fun add(other: CollisionCounters) {
        collisions += other.collisions
        wallCollisions += other.wallCollisions
        guardActivations += other.guardActivations
        redoneSteps += other.redoneSteps
        causalityReplays += other.causalityReplays
    }

    /** What was counted since these were [before]. */
    internal fun since(before: CollisionCounters): CollisionCounters = CollisionCounters().also {
        it.collisions = collisions - before.collisions
        it.wallCollisions = wallCollisions - before.wallCollisions
        it.guardActivations = guardActivations - before.guardActivations
        it.redoneSteps = redoneSteps - before.redoneSteps
        it.causalityReplays = causalityReplays - before.causalityReplays
    }

    internal fun clear() {
        collisions = 0
        wallCollisions = 0
        guardActivations = 0
        redoneSteps = 0
        causalityReplays = 0
    }

    /** Takes over all that [other] counts. */
    internal fun set(other: CollisionCounters) {
        collisions = other.collisions
        wallCollisions = other.wallCollisions
        guardActivations = other.guardActivations
        redoneSteps = other.redoneSteps
        causalityReplays = other.causalityReplays
    }
}
