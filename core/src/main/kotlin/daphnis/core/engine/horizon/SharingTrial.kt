package daphnis.core.engine.horizon

import java.util.function.LongSupplier

/**
 * Finds out by trial whether threads are to share steps, or one does better alone. That depends on what no plan knows:
 * how long it takes to wake a thread, whether the machine gives it a processor, and whether the compilers of a JVM that
 * has just started need that. The bits of a step are the same either way.
 *
 * The present way is measured all the time. Now and then the other one is tried for two epochs or more, and the one
 * with the shorter steps goes on. A way that has won is tried against the other soon, and each time it wins again it
 * lasts twice as long.
 *
 * ```
 *   alone ──▶ shared? ──▶ alone ──────▶ shared? ──▶ shared ──▶ alone? ──▶ shared ──────▶ alone? ──▶ …
 *             slower                    quicker                slower
 * ```
 *
 * A step begins with [begin] and ends with [finish], or without when it fails.
 *
 * @param isAlone how the first steps are taken
 * @param clock in nanoseconds, from any moment
 */
internal class SharingTrial(isAlone: Boolean, private val clock: LongSupplier = LongSupplier { System.nanoTime() }) {
    /** Whether one thread takes the next step alone. */
    var isAlone = isAlone
        private set

    private var begin = 0L

    /** Whether the other way is being tried. */
    private var isTrial = false

    // Nanoseconds, steps and epochs that have been measured last, all in one way; before an epoch begins there are none.
    private var time = 0L
    private var steps = 0
    private var epochs = 0

    /** Nanoseconds that the present way is to last until the other is tried, and those of them that have passed. */
    private var spell = MEASURED
    private var spent = 0L

    /** Nanoseconds per step of the present way, as measured last. */
    private var present = 0.0

    /** Begins a step. */
    fun begin() {
        begin = clock.asLong
    }

    /** Ends a step, which [beganEpoch] when its spheres were searched for anew, or it was not taken in an epoch. */
    fun finish(beganEpoch: Boolean) {
        val taken = clock.asLong - begin
        if (beganEpoch) {
            val way = isAlone
            if (epochs >= LEAST_EPOCHS && time >= MEASURED) judge(time.toDouble() / steps)
            // An epoch that began in the way before is not measured.
            if (isAlone == way) epochs++
        }
        if (epochs == 0) return
        time += taken
        steps++
    }

    private fun judge(perStep: Double) {
        if (isTrial) endTrial(perStep) else goOn(perStep)
        time = 0
        steps = 0
        epochs = 0
    }

    private fun goOn(perStep: Double) {
        present = perStep
        spent += time
        if (spent < spell) return
        isTrial = true
        isAlone = !isAlone
    }

    private fun endTrial(perStep: Double) {
        isTrial = false
        spent = 0
        if (perStep < present * CLEARLY) {
            spell = AFTER_CHANGE
        } else {
            isAlone = !isAlone
            spell = minOf(2 * spell, LONGEST)
        }
    }

    internal companion object {
        /** Nanoseconds, and epochs, that are measured at least. */
        const val MEASURED = 20_000_000L
        const val LEAST_EPOCHS = 2

        /** Nanoseconds that a way lasts when it has just won, and at most. */
        const val AFTER_CHANGE = 4 * MEASURED
        const val LONGEST = 128 * MEASURED

        /** How much shorter the steps of the other way must be. */
        const val CLEARLY = 0.97
    }
}
