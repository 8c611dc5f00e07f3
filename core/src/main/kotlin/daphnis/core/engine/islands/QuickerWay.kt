package daphnis.core.engine.islands

/**
 * Whether islands are worth growing, found out by trying: both ways give the same bits, so nothing but the time hangs
 * on it. Where most collisions hang together, as around a moonlet on which particles lie, all are one island and the
 * serial way is quicker.
 *
 * The serial way is tried now and then and compared with the quickest of the islands' steps since the last trial, since
 * what the machine does beside makes single steps slow, never quick. When the serial way has clearly won, islands rest,
 * the longer the more they had lost.
 */
internal class QuickerWay {
    private var steps = 0L
    private var grown = Double.POSITIVE_INFINITY
    private var alone = Double.NaN
    private var aloneUntil = 0L

    /** Whether to go the serial way in the step that begins. */
    fun takeTurnAlone(): Boolean {
        val step = steps++
        return step < aloneUntil || step % STEPS_A_LOOK == LOOK
    }

    /** Seconds after which growing islands in this step is to be given up. */
    val patience: Double get() = if (alone.isNaN()) {
        Double.POSITIVE_INFINITY
    } else {
        maxOf(
            alone * MOST_LOSS,
            LEAST_PATIENCE,
        )
    }

    /** A step was done the serial way in [seconds]. */
    fun wentAlone(seconds: Double) {
        if (steps <= aloneUntil) {
            // At rest: the quickest of these steps is what the next trial of islands is given as patience.
            alone = minOf(alone, seconds)
            return
        }
        alone = seconds
        if (grown.isFinite() && grown > alone * CLEARLY) rest(grown / alone)
        grown = Double.POSITIVE_INFINITY
    }

    /** A step was done in islands in [seconds]. */
    fun grew(seconds: Double) {
        grown = minOf(grown, seconds)
    }

    /** Islands took so long that they were given up. */
    fun gaveUp() {
        rest(MOST_LOSS)
        grown = Double.POSITIVE_INFINITY
    }

    private fun rest(worse: Double) {
        aloneUntil = steps + (STEPS_A_LOOK * minOf(worse, MOST_LOSS)).toLong()
    }

    private companion object {
        const val STEPS_A_LOOK = 64L

        /** The step of each such stretch in which the serial way is tried. */
        const val LOOK = 8L
        const val CLEARLY = 1.25
        const val MOST_LOSS = 4.0
        const val LEAST_PATIENCE = 0.02
    }
}
