package daphnis.core.engine.islands

/**
 * How much one worker may keep of a window in a step of [spheres] spheres. Ordinary windows keep a few hundredths of
 * it. Where thousands of spheres touch, all hang together and islands gain nothing, so the serial engine takes the
 * step.
 */
internal class IslandLimits(spheres: Int) {
    /** Pieces of path left behind, including those of dropped attempts: 68 bytes each. */
    val pieces: Long = LEAST_PIECES + PIECES_A_SPHERE * spheres

    /** Potential collisions of one island, including those that did not happen: 24 bytes each. */
    val events: Long = LEAST_EVENTS + EVENTS_A_SPHERE * spheres

    /** Potential collisions of the step that lie beyond the window: 24 bytes each. */
    val hints: Long = LEAST_HINTS + HINTS_A_SPHERE * spheres

    /** Collisions of one attempt at an island: beyond it the path is a false one, or most spheres hang together. */
    val collisions: Long = LEAST_COLLISIONS + COLLISIONS_A_SPHERE * spheres

    /**
     * Checks an attempt at one island that has had [collisions] and has found [events] potential ones.
     *
     * @throws IslandsTooLargeException when either is too many
     */
    fun checkIsland(collisions: Long, events: Int) {
        if (collisions > this.collisions) throw IslandsTooLargeException("collisions of one island", this.collisions)
        if (events > this.events) throw IslandsTooLargeException("potential collisions of one island", this.events)
    }

    private companion object {
        const val LEAST_COLLISIONS = 4_000L
        const val COLLISIONS_A_SPHERE = 4L
        const val LEAST_PIECES = 500_000L
        const val PIECES_A_SPHERE = 2L
        const val LEAST_EVENTS = 1_000_000L
        const val EVENTS_A_SPHERE = 8L
        const val LEAST_HINTS = 2_000_000L
        const val HINTS_A_SPHERE = 32L
    }
}

/** Thrown when islands have grown beyond what [IslandLimits] allow; the step is to be taken in another way. */
internal class IslandsTooLargeException(what: String, most: Long) :
    RuntimeException("islands need more than $most $what in a window")
