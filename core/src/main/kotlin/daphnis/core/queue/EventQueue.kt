package daphnis.core.queue

import daphnis.core.api.EngineApi

/** Takes the potential collisions that a search finds. */
public interface EventSink {
    /** Queues the potential collision of [first] with [second] (a slot, or a negative partner number). */
    public fun add(time: Double, first: Int, second: Int, image: Int)
}

/**
 * Potential collisions of one step, handed out in the order (time, lower id, higher id, image).
 *
 * The calls of a step are [reset]; any number of [add]; then [pop] until it returns false, each time followed by
 * [removeAllOf] for the spheres that the collision changed and by [add] for what they can now hit. Times lie in `[0,
 * duration]`; an event added while another is processed is not earlier than that one. Spheres are addressed by slot;
 * ids only break ties. Single-threaded.
 */
public interface EventQueue : Schedule {
    /** Time of the event that [pop] handed out, from the start of the step. */
    public val time: Double

    /** One slot of the event that [pop] handed out. */
    public val first: Int

    /** The other slot, or the negative partner number of a wall. */
    public val second: Int

    /** Image code of [second] as seen from [first]. */
    public val image: Int

    /** Forgets everything and prepares for a step of [duration] with [count] slots whose ids are `ids[slot]`. */
    public fun reset(duration: Double, ids: IntArray, count: Int)

    /** Removes the earliest event and puts it into [time], [first], [second], [image]; false when none is left. */
    public fun pop(): Boolean
}

/** Potential collisions to come: takes those that a search finds, and drops those of a sphere that has changed. */
@EngineApi
public interface Schedule : EventSink {
    /** Drops every potential collision that involves [slot]. */
    public fun removeAllOf(slot: Int)
}
