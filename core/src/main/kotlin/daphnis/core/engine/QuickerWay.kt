package daphnis.core.engine

import java.util.function.LongSupplier

/**
 * Finds out by trial in which of several ways steps are taken soonest. All give the same bits, so only the time depends
 * on it, and that depends on what no plan knows: how long it takes to wake a thread, whether the machine gives it a
 * processor, what has been compiled, how many collisions depend on one another.
 *
 * The present way is measured all the time. Now and then another is tried, for 20 ms and two stretches of steps that
 * belong together, and the one with the shorter steps goes on. A way that has won is tried against the one before
 * soon, and one that loses waits twice as long each time, eight times as long as its trial took at least.
 *
 * ```
 *   A ──▶ B? ──▶ A ──────▶ B? ──▶ B ──▶ A? ──▶ B ──────▶ A? ──▶ …
 *         slower           quicker      slower
 * ```
 *
 * A step begins with [choose] and ends with [finish] or [giveUp], or with neither when it fails.
 *
 * @param waits nanoseconds that the present way lasts before each of the ways, which are numbered from 0 on, is tried
 *   for the first time
 * @param clock in nanoseconds, from any moment
 */
internal class QuickerWay(waits: LongArray, private val clock: LongSupplier = LongSupplier { System.nanoTime() }) {
    /** How the step is taken that was begun last. */
    var way = NONE
        private set

    /** The way that has won; another is being tried where that is not [way]. */
    private var winner = NONE

    /** The ways that the present step can be taken in. */
    private var allowed = IntArray(0)
    private var begin = 0L

    /** Nanoseconds after which the present step is late. */
    private var patience = Double.POSITIVE_INFINITY

    // Nanoseconds, steps and stretches that have been measured last, all in one way; none before a stretch begins.
    private var time = 0L
    private var steps = 0
    private var stretches = 0

    /** Nanoseconds per step of each way, as measured last. */
    private val known = DoubleArray(waits.size) { Double.POSITIVE_INFINITY }

    /** Nanoseconds of the winner until each way is tried, and how long that was to take. */
    private val left = waits.copyOf()
    private val spell = LongArray(waits.size) { MEASURED }

    /**
     * Begins a step, which can be taken in the [allowed] ways only. The first of them is taken until another has won.
     *
     * @return the way to take it
     */
    fun choose(allowed: IntArray): Int {
        this.allowed = allowed
        if (winner !in allowed) winner = allowed[0]
        if (way !in allowed) turnTo(winner)
        patience = maxOf(MOST_LOSS * (quickestOther()?.let { known[it] } ?: Double.POSITIVE_INFINITY), LEAST_PATIENCE)
        begin = clock.asLong
        return way
    }

    /** Whether the present step takes far longer than in another way, so that it is better given up. */
    val isLate: Boolean get() = clock.asLong - begin > patience

    /**
     * Ends a step with which a stretch [begins], or which belongs to the stretch before.
     *
     * @param ends whether the stretch ends with the step, too; then a way that is far slower is not tried any longer
     */
    fun finish(begins: Boolean, ends: Boolean = false) {
        val taken = clock.asLong - begin
        if (begins) {
            val before = way
            if (isEnough()) judge()
            // A stretch that began in another way is not measured.
            if (way == before) stretches++
        }
        if (stretches == 0) return
        time += taken
        steps++
        if (!ends) return
        if (way != winner && time > MOST_LOSS * known[winner] * steps) {
            lose(time)
        } else if (isEnough()) {
            judge()
        }
    }

    private fun isEnough() = stretches >= LEAST_STRETCHES && time >= MEASURED

    /** Ends a step that was given up, and was then taken in another way. */
    fun giveUp() {
        val taken = clock.asLong - begin
        if (way == winner) winner = quickestOther() ?: return
        lose(taken)
    }

    private fun judge() {
        val perStep = time.toDouble() / steps
        known[way] = perStep
        when {
            way == winner -> goOn()
            perStep < known[winner] * CLEARLY -> win()
            else -> lose(time)
        }
        forget()
    }

    /** The winner goes on, or another way is to be tried. */
    private fun goOn() {
        for (w in allowed) left[w] -= time
        way = allowed.filter { it != winner && left[it] <= 0 }.minByOrNull { left[it] } ?: winner
    }

    private fun win() {
        left[winner] = AFTER_CHANGE
        spell[winner] = AFTER_CHANGE
        winner = way
    }

    /** The present way has lost, after it was [tried] for so long. */
    private fun lose(tried: Long) {
        val longest = maxOf(LONGEST, tried * MOST_TIMES_A_TRIAL)
        spell[way] = (2 * spell[way]).coerceIn(tried * TIMES_A_TRIAL, longest)
        left[way] = spell[way]
        turnTo(winner)
    }

    private fun turnTo(way: Int) {
        this.way = way
        forget()
    }

    private fun forget() {
        time = 0
        steps = 0
        stretches = 0
    }

    private fun quickestOther(): Int? = allowed.filter { it != way }.minByOrNull { known[it] }

    companion object {
        private const val NONE = -1

        /** Nanoseconds, and stretches, that are measured at least. */
        const val MEASURED = 20_000_000L
        private const val LEAST_STRETCHES = 2

        /** Nanoseconds that a way lasts when it has just won, and at most, but for trials that are long themselves. */
        const val AFTER_CHANGE = 4 * MEASURED
        const val LONGEST = 128 * MEASURED
        private const val TIMES_A_TRIAL = 8
        private const val MOST_TIMES_A_TRIAL = 64

        /** How much shorter the steps of another way must be. */
        private const val CLEARLY = 0.97

        /** In units of another way's time; what takes longer is given up. */
        private const val MOST_LOSS = 4.0

        /** Nanoseconds. */
        const val LEAST_PATIENCE = 2e7
    }
}
