package daphnis.core.search

/**
 * The lengths, speeds and durations that a step can be computed with. The contact time takes squares of lengths times
 * speeds, b² and a·c of [daphnis.core.collision.contactTime]; where those run out of the range of a double, spheres
 * would pass through one another without a word. Within these bounds what underflows moves a sphere by less than the
 * round-off of its place.
 */
internal object Scales {
    private const val MEND = "choose other units"
    private const val MOST = 1e70
    private const val LEAST_SQUARE_A_TIME = 1e-130

    /**
     * That the [fastest] component of a velocity, the [smallest] radius and the [duration] of a step can be computed
     * with.
     */
    fun requireSpeeds(fastest: Double, smallest: Double, duration: Double) {
        require(fastest <= MOST) {
            "the fastest sphere has a speed of $fastest along an axis; contacts can be computed up to $MOST: " + MEND
        }
        require(smallest >= 1 / MOST) {
            "the smallest radius is $smallest; contacts can be computed from ${1 / MOST} on: " + MEND
        }
        require(smallest * (smallest / duration) >= LEAST_SQUARE_A_TIME) {
            "a radius of $smallest and a step of $duration are too far apart to compute contacts: $MEND, or a smaller dt"
        }
    }

    /** That spheres up to [largest] in radius at places between [low] and [high] along [axis] can be computed with. */
    fun requireLengths(axis: Int, low: Double, high: Double, largest: Double) {
        require(low >= -MOST && high <= MOST && largest <= MOST) {
            "positions along ${"xyz"[axis]} from $low to $high, radii up to $largest: contacts can be computed up to " +
                "$MOST: $MEND"
        }
    }
}
