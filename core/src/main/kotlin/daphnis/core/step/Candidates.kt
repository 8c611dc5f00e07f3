package daphnis.core.step

import daphnis.core.api.EngineApi
import daphnis.core.collision.StepRows
import daphnis.core.queue.EventSink

/**
 * Whom can a sphere touch before the end of the step, walls included? Finds every potential collision of a
 * [PreparedStep], each once, at the time that [daphnis.core.collision.contactTime] gives to the last bit. It relies on
 * the bounds of the step alone: nobody goes farther than [PreparedStep.reach], and velocities that collisions create
 * are put into [PreparedStep.bounds] before anybody searches from them.
 *
 * [GridCandidates] is the fast one; a slow reference stands beside it in the tests. Each object belongs to one thread.
 */
@EngineApi
public interface Candidates {
    /**
     * Adds to [sink] what slots [from] until [to] can have before anybody has moved. When all slots have been asked,
     * each potential collision has been added once, from either of its spheres.
     */
    public fun start(from: Int, to: Int, sink: EventSink)

    /**
     * Adds to [sink] what the sphere at [place] of [own] can have from its local time on with everybody but slot
     * [except]; `first` is [place] there, `second` a slot of the step, or the partner number of a wall.
     *
     * Nobody's local time may be later. A sphere whose local time is NaN, unknown, is added with NaN for a time, as
     * often as it may be an image; so is the sphere itself, if that is what its own slot says.
     */
    public fun around(own: StepRows, place: Int, except: Int, sink: EventSink)

    /**
     * Shows [viewer] the slots of all with whom the sphere in [slot] can have a potential collision from its local time
     * on, whatever their local times are; others, also the sphere itself, may be among them. Without walls.
     *
     * @return false when [viewer] wanted no more
     */
    public fun view(slot: Int, viewer: Viewer): Boolean

    /** Looks at the candidates of [view]. */
    public fun interface Viewer {
        /** Looks at the sphere in slot [other], at [image] of it; false ends the view. */
        public fun look(other: Int, image: Int): Boolean
    }
}
