package daphnis.core.queue

import daphnis.core.api.EngineApi

/** Potential collisions to come: takes those that a search finds, and drops those of a sphere that has changed. */
@EngineApi
public interface Schedule : EventSink {
    /** Drops every potential collision that involves [slot]. */
    public fun removeAllOf(slot: Int)
}
