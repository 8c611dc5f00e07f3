package daphnis.core.engine

import java.util.function.LongSupplier

/** How a step is taken. */
internal enum class Way { SERIAL, OWN }

/**
 * Finds out by trial whether an engine's own way of taking a step is worth its cost. It gives the same bits as the
 * serial way, so only the time depends on it. Where most collisions depend on one another, as around a moonlet on which
 * particles lie, the serial way is quicker.
 *
 * The serial way is tried now and then and compared with the quickest step of the own way since the last trial. The
 * quickest is right because other work of the machine makes single steps slow, never quick. When the serial way has
 * clearly won, the own way rests, and the more it lost by, the longer it rests.
 *
 * A step begins with [choose] and ends with [finish], with [giveUp], or with neither when it fails.
 *
 * @param clock in nanoseconds, from any moment
 */
internal class QuickerWay(private val clock: LongSupplier = LongSupplier { System.nanoTime() }) {
    private var steps = 0L
    private var way = Way.OWN
    private var begin = 0L

    /** Nanoseconds of the quickest step of the own way since the last trial of the serial way. */
    private var own = UNMEASURED

    /** Nanoseconds of the last trial of the serial way, or of the quickest step of the rest that followed. */
    private var serial = UNMEASURED
    private var restUntil = 0L

    /** Nanoseconds after which a step of the own way is to be given up, [NEVER] at first. */
    private var patience = NEVER

    /** Begins a step and returns how it is to be taken. */
    fun choose(): Way {
        val step = steps++
        way = if (step < restUntil || step % STEPS_PER_TRIAL == TRIAL) Way.SERIAL else Way.OWN
        patience = if (way == Way.SERIAL || serial == UNMEASURED) NEVER else maxOf(serial * MOST_LOSS, LEAST_PATIENCE)
        begin = clock.asLong
        return way
    }

    /** Whether the own way takes so long in the present step that it is to be given up. */
    val isLate: Boolean get() = patience != NEVER && clock.asLong - begin > patience

    /** Ends a step that was taken in the way which [choose] returned. */
    fun finish() {
        val time = clock.asLong - begin
        if (way == Way.OWN) {
            own = minOf(own, time)
        } else if (steps <= restUntil) {
            // At rest: the quickest of these steps gives the patience for the next trial of the own way.
            serial = minOf(serial, time)
        } else {
            serial = time
            if (own != UNMEASURED && own > serial * CLEARLY) rest(own.toDouble() / serial)
            own = UNMEASURED
        }
    }

    /** Ends a step in which the own way was given up. */
    fun giveUp() {
        rest(MOST_LOSS.toDouble())
        own = UNMEASURED
    }

    private fun rest(worse: Double) {
        restUntil = steps + (STEPS_PER_TRIAL * minOf(worse, MOST_LOSS.toDouble())).toLong()
    }

    companion object {
        /** In place of a shortest time, where there was none to measure: every time is shorter. */
        private const val UNMEASURED = Long.MAX_VALUE

        /** A patience that no time exceeds. */
        private const val NEVER = Long.MAX_VALUE

        /** One of so many steps is taken the serial way to try it. */
        const val STEPS_PER_TRIAL = 64L

        /** Which of them that is. */
        const val TRIAL = 8L

        /** How much slower the own way may be than the serial way before it rests. */
        private const val CLEARLY = 1.25

        /** In units of the serial way's time; an own way that takes longer is given up. */
        private const val MOST_LOSS = 4L

        /** Nanoseconds. */
        const val LEAST_PATIENCE = 20_000_000L
    }
}
