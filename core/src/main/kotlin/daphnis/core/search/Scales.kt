package daphnis.core.search

/**
 * The lengths, speeds and durations with which a step can be computed. The contact time uses squares of lengths times
 * speeds, b² and a·c of [daphnis.core.collision.contactTime]. Where those leave the range of a double, spheres would
 * pass through one another unnoticed. Within these bounds an underflow moves a sphere by less than the round-off of its
 * position.
 */
internal object Scales {
    private const val MEND = "choose other units"
    private const val MOST = 1e70
    private const val LEAST_SQUARE_A_TIME = 1e-130

    /**
     * Requires that contacts can be computed with the [fastest] component of a velocity, the [smallest] radius and the
     * [duration] of a step.
     */
    fun requireSpeeds(fastest: Double, smallest: Double, duration: Double) {
        require(fastest <= MOST) {
            "the fastest sphere has a speed of $fastest along an axis; contacts can be computed up to $MOST: $MEND"
        }
        require(smallest >= 1 / MOST) {
            "the smallest radius is $smallest; contacts can be computed from ${1 / MOST} on: $MEND"
        }
        require(smallest * (smallest / duration) >= LEAST_SQUARE_A_TIME) {
            "a radius of $smallest and a step of $duration are too far apart to compute contacts: " +
                "$MEND, or a smaller dt"
        }
    }

    /**
     * Requires that contacts can be computed for spheres with radii up to [largest] at positions between [low] and
     * [high] along [axis].
     */
    fun requireLengths(axis: Int, low: Double, high: Double, largest: Double) {
        require(low >= -MOST && high <= MOST && largest <= MOST) {
            "positions along ${"xyz"[axis]} from $low to $high, radii up to $largest: contacts can be computed up to " +
                "$MOST: $MEND"
        }
    }
}
