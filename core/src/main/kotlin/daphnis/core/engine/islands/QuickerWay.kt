package daphnis.core.engine.islands

/**
 * Whether islands are worth growing, found out by trying: both ways give the same bits, so nothing but the time hangs on it. Where most collisions hang together, as
 * around a moonlet on which particles lie, all are one island and the serial way is quicker.
 *
 * The serial way is tried early and then now and then; when it has won, islands are tried again later, the later the more clearly they had lost.
 */
internal class QuickerWay {
    private var steps = 0L
    private var grown = Double.NaN
    private var alone = Double.NaN
    private var aloneUntil = 0L

    /** Whether to go the serial way in the step that begins. */
    fun isAlone(): Boolean {
        val step = steps++
        if (step < aloneUntil) return true
        // A new look at islands, unless the serial way is due for one.
        return step != aloneUntil && (step == FIRST_LOOK || step % STEPS_A_LOOK == STEPS_A_LOOK / 2)
    }

    /** Seconds after which growing islands in this step is to be given up. */
    val patience: Double get() = if (alone.isNaN()) Double.POSITIVE_INFINITY else maxOf(alone * MOST_LOSS, LEAST_PATIENCE)

    /** Notes how long the step took, the islands' one also when it was given up. */
    fun took(seconds: Double, wasAlone: Boolean) {
        if (wasAlone) {
            alone = seconds
            // Of what the machine does beside, the quicker of two is the better measure.
            if (steps <= aloneUntil) return
        } else {
            grown = seconds
        }
        if (!(grown > alone * CLEARLY)) return
        val worse = (grown / alone).coerceIn(1.0, MOST_WORSE)
        aloneUntil = steps + (STEPS_A_LOOK * worse).toLong()
        grown = Double.NaN
    }

    private companion object {
        const val FIRST_LOOK = 3L
        const val STEPS_A_LOOK = 64L
        const val CLEARLY = 1.1
        const val MOST_LOSS = 4.0
        const val LEAST_PATIENCE = 0.02
        const val MOST_WORSE = 16.0
    }
}
