package daphnis.analysis.insitu

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.Output
import daphnis.core.Simulation

/** Something that turns a state into numbers, always equally many. Everything in this module that can be averaged is one. */
public fun interface Measure {
    /** The numbers of [state], which stays as it is. */
    public fun of(state: PatchState): DoubleArray
}

/**
 * Averages of a [measure] over states, with error bars from block averaging. Also an [Output], so that it can be given to a simulation and fills as the run
 * goes; it keeps the numbers of each sample, not the states.
 *
 * @param from states before this time are left out
 * @param every steps between samples when used as an output
 * @param omega angular speed of Hill's frame, or null
 */
public class Averages(
    private val measure: Measure,
    private val from: Double = Double.NEGATIVE_INFINITY,
    private val every: Long = 1,
    private val omega: Double? = null,
) : Output {
    private val samples = ArrayList<DoubleArray>()

    init {
        require(every >= 1) { "a sample every $every steps; it must be at least 1" }
    }

    /** Number of samples so far. */
    public val size: Int get() = samples.size

    /** Numbers in a sample; 0 before the first. */
    public val width: Int get() = if (samples.isEmpty()) 0 else samples[0].size

    override fun write(simulation: Simulation) {
        if (simulation.time >= from && simulation.step % every == 0L) add(PatchState.of(simulation, omega))
    }

    /** Takes in one more state. @throws IllegalStateException when the measure gives another number of numbers than before */
    public fun add(state: PatchState) {
        val sample = measure.of(state)
        check(samples.isEmpty() || sample.size == width) { "a sample has ${sample.size} numbers, those before had $width" }
        samples += sample
    }

    /** Average and error of number [k]; samples in which it is NaN, such as the mean of an empty bin, are left out. */
    public fun average(k: Int): BlockAverage = BlockAverage.of(DoubleArray(samples.size) { samples[it][k] }.filter { !it.isNaN() }.toDoubleArray())

    /** Number [k] by sample. */
    public fun series(k: Int): DoubleArray = DoubleArray(samples.size) { samples[it][k] }
}
