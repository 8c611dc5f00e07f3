package daphnis.core.engine

import daphnis.core.api.EngineApi
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.step.CollisionStep

/**
 * Carries a population through one step of straight paths and collisions. All engines give the same state, bit for bit:
 * the one that processes the collisions in the order (time, lower id, higher id), none missed, with every sphere
 * changed at its own collisions and at the end of the step only. [SerialEngine] is the specification.
 */
public interface CollisionEngine : AutoCloseable {
    /** The name it is chosen by. */
    public val name: String

    /** How many threads work. */
    public val threads: Int

    /**
     * Runs loops over spheres on the engine's threads; for what else a step has to do. Not while [advance] runs. Throws
     * after [close].
     */
    public val loop: RangeLoop get() = InlineLoop

    /**
     * Brings every sphere of the step's population from its start to its end. Boundaries are not applied at the end;
     * that is the caller's. When this throws, population and counters are as they were before: an engine writes the
     * population last, with [daphnis.core.collision.StepRows.store], which leaves the arrays of before alone, so that
     * the caller too can take the step back.
     *
     * @throws CollapseException when one sphere has more than 10,000 collisions in a row without time going on: each at
     *   most 1e-13 of the step after the one before
     * @throws IllegalArgumentException when a sphere meets images too far away, when the step has more than 2,000,000
     *   collisions and 1000 for each sphere, or when sizes, speeds and duration are too far apart to compute contacts.
     *   Like the state, whether a step fails, and with which exception, is the same for every engine; not so an
     *   [Error], which a parallel engine throws on from wherever it came
     * @throws IllegalStateException after [close]
     */
    @EngineApi
    public fun advance(step: CollisionStep)

    /**
     * Ends the engine's threads, if it has any; from then on [advance] and [loop] throw and start nothing. A step under
     * way ends well, or throws with everything as before. Closing twice is allowed.
     */
    override fun close(): Unit = Unit

    public companion object {
        internal const val CLOSED = "the engine is closed"
    }
}
