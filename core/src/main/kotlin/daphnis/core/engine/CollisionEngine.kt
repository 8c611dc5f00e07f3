package daphnis.core.engine

import daphnis.core.api.EngineApi
import daphnis.core.step.CollisionStep

/**
 * Carries a population through one step of straight paths and collisions. All engines give the same state, bit for bit.
 * It is the state that results from processing the collisions in the order (time, lower id, higher id), with none
 * missed, where a sphere changes only at its own collisions and at the end of the step. [SerialEngine] is the
 * specification.
 */
public interface CollisionEngine : Workforce {
    /**
     * Moves every sphere of the step's population from the start of the step to its end. Boundaries are not applied at
     * the end; that is the caller's task. When this throws, population and counters are as they were before. An engine
     * writes the population last, with [daphnis.core.collision.StepRows.store], which does not touch the previous
     * arrays, so that the caller can take the step back too.
     *
     * @throws CollapseException when one sphere has more than 10,000 collisions in a row while time stands still: each
     *   at most 1e-13 of the step after the one before
     * @throws IllegalArgumentException when a sphere meets images too far away, when the step has more than 2,000,000
     *   collisions and 1000 for each sphere, when a number of the population is not finite, or when sizes, speeds
     *   and duration are too far apart to compute contacts.
     *   Like the state, whether a step fails, and with which exception, is the same for every engine. That does not
     *   hold for an [Error], which a parallel engine passes on from wherever it came
     * @throws IllegalStateException after [close]
     */
    @EngineApi
    public fun advance(step: CollisionStep)

    /**
     * Ends the engine's threads, if it has any; from then on [advance] and [loop] throw and start nothing. A step under
     * way either succeeds, or throws and leaves everything as before. Closing twice is allowed.
     */
    override fun close(): Unit = Unit

    public companion object {
        internal const val CLOSED = "the engine is closed"
    }
}
