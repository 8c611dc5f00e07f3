package daphnis.core.step

import daphnis.core.api.EngineApi
import daphnis.core.queue.EventSink

/**
 * Finds every potential collision of a [PreparedStep], including those with walls, each once, at the time that
 * [daphnis.core.collision.contactTime] gives to the last bit. It relies on the bounds of the step alone: no sphere goes
 * farther than [PreparedStep.reach], and velocities that collisions create are put into [PreparedStep.bounds] before
 * any search with them.
 *
 * [GridCandidates] is the fast one; a slow reference stands beside it in the tests. Each object belongs to one thread.
 */
@EngineApi
public interface Candidates {
    /**
     * Adds to [sink] the potential collisions of slots [from] until [to] before any sphere has moved. When this has
     * been called for all slots, each potential collision has been added once, from either of its spheres.
     */
    public fun start(from: Int, to: Int, sink: EventSink)

    /**
     * Adds to [sink] the potential collisions that the sphere in [slot] has from its local time on with every sphere
     * except slot [except] and with walls. `first` is [slot] there, `second` another slot, or the partner number of a
     * wall.
     *
     * No other local time may be later.
     */
    public fun around(slot: Int, except: Int, sink: EventSink)

    /**
     * Shows [viewer] the slots of all spheres with which the sphere in [slot] can have a potential collision from its
     * local time on, whatever their local times are. Other spheres, even the sphere itself, may be among them. Walls
     * are not.
     *
     * @return false when [viewer] ended the view
     */
    public fun view(slot: Int, viewer: Viewer): Boolean

    /** Looks at the candidates of [view]. */
    public fun interface Viewer {
        /** Looks at the sphere in slot [other], at [image] of it; false ends the view. */
        public fun look(other: Int, image: Int): Boolean
    }
}
