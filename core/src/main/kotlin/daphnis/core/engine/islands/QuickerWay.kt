package daphnis.core.engine.islands

import java.util.function.LongSupplier

/** How a step is taken. */
internal enum class Way { SERIAL, ISLANDS }

/**
 * Finds out by trial whether islands are worth growing. Both ways give the same bits, so only the time depends on it.
 * Where most collisions depend on one another, as around a moonlet on which particles lie, all spheres are one island
 * and the serial way is quicker.
 *
 * The serial way is tried now and then and compared with the quickest step in islands since the last trial. The
 * quickest is right because other work of the machine makes single steps slow, never quick. When the serial way has
 * clearly won, islands rest, and the more they lost by, the longer they rest.
 *
 * A step begins with [choose] and ends with [finish], with [giveUp], or with neither when it fails.
 *
 * @param clock in nanoseconds, from any moment
 */
internal class QuickerWay(private val clock: LongSupplier = LongSupplier { System.nanoTime() }) {
    private var steps = 0L
    private var way = Way.ISLANDS
    private var begin = 0L

    /** Nanoseconds of the quickest step in islands since the last trial of the serial way. */
    private var islands = UNMEASURED

    /** Nanoseconds of the last trial of the serial way, or of the quickest step of the rest that followed. */
    private var serial = UNMEASURED
    private var restUntil = 0L

    /** Nanoseconds after which a step in islands is to be given up. */
    private var patience = NEVER

    /** Begins a step and returns how it is to be taken. */
    fun choose(): Way {
        val step = steps++
        way = if (step < restUntil || step % STEPS_PER_TRIAL == TRIAL) Way.SERIAL else Way.ISLANDS
        patience = if (way == Way.SERIAL || serial == UNMEASURED) NEVER else maxOf(serial * MOST_LOSS, LEAST_PATIENCE)
        begin = clock.asLong
        return way
    }

    /** Whether growing islands in the present step takes so long that it is to be given up. */
    val isLate: Boolean get() = patience != NEVER && clock.asLong - begin > patience

    /** Ends a step that was taken in the way which [choose] returned. */
    fun finish() {
        val time = clock.asLong - begin
        if (way == Way.ISLANDS) {
            islands = minOf(islands, time)
        } else if (steps <= restUntil) {
            // At rest: the quickest of these steps gives the patience for the next trial of islands.
            serial = minOf(serial, time)
        } else {
            serial = time
            if (islands != UNMEASURED && islands > serial * CLEARLY) rest(islands.toDouble() / serial)
            islands = UNMEASURED
        }
    }

    /** Ends a step in which islands were given up. */
    fun giveUp() {
        rest(MOST_LOSS.toDouble())
        islands = UNMEASURED
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

        /** How much slower islands may be than the serial way before they rest. */
        private const val CLEARLY = 1.25

        /** In units of the serial way's time; islands that take longer are given up. */
        private const val MOST_LOSS = 4L

        /** Nanoseconds. */
        const val LEAST_PATIENCE = 20_000_000L
    }
}
