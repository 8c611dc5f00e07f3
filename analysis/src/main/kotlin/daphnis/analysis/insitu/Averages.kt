package daphnis.analysis.insitu

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.Output
import daphnis.core.OutputState
import daphnis.core.Simulation
import daphnis.core.orbit.OrbitalFrequencies
import kotlin.math.abs

/**
 * Averages of a [measure] over states, with error bars from block averaging. Also an [Output], so that it can be given
 * to a simulation and fills as the run goes; it keeps the numbers of each sample, not the states. The numbers of a
 * [PooledMeasure] come from its sums over all states; their errors are those of the jackknife pseudovalues that leave
 * out one state each, block-averaged for the correlation between states.
 *
 * @param from states before this time are left out
 * @param every steps between samples when used as an output
 * @param frequencies of orbits in Hill's frame, or null
 */
public class Averages @JvmOverloads constructor(
    private val measure: Measure,
    private val from: Double = Double.NEGATIVE_INFINITY,
    private val every: Long = 1,
    private val frequencies: OrbitalFrequencies? = null,
) : Output {
    private val samples = ArrayList<DoubleArray>()
    private val pooled = measure as? PooledMeasure
    private var pool: Pool? = null

    init {
        require(every >= 1) { "a sample every $every steps; it must be at least 1" }
    }

    /** Number of samples so far. */
    public val size: Int get() = samples.size

    /** Numbers in a sample; 0 before the first. */
    public val width: Int get() = if (samples.isEmpty()) 0 else numbers(0).size

    override fun write(simulation: Simulation) {
        if (simulation.time >= from && simulation.step % every == 0L) add(State.of(simulation, frequencies))
    }

    override fun save(state: OutputState) {
        state.put(COUNT, longArrayOf(size.toLong()))
        state.put(SAMPLES, DoubleArray(samples.sumOf { it.size }).also { all -> fill(all) })
    }

    private fun fill(all: DoubleArray) {
        for ((k, sample) in samples.withIndex()) sample.copyInto(all, k * sample.size)
    }

    override fun restore(state: OutputState) {
        val all = state.doubles(SAMPLES)
        val count = state.longs(COUNT).single().toInt()
        samples.clear()
        for (k in 0 until count) samples += all.copyOfRange(k * (all.size / count), (k + 1) * (all.size / count))
        pool = null
    }

    /**
     * Takes in one more state.
     *
     * @throws IllegalStateException when the measure gives another number of numbers than before
     */
    public fun add(state: State) {
        val sample = if (pooled != null) pooled.sums(state) else measure.of(state)
        check(samples.isEmpty() || sample.size == samples[0].size) {
            "a sample has ${sample.size} numbers, those before had ${samples[0].size}"
        }
        samples += sample
        pool = null
    }

    /**
     * Average and error of number [k]. Of a [PooledMeasure]: of all particles of all states together; there is no error
     * where fewer than [BlockAverage.FEWEST_NUMBERS] states have a say. Of any other: samples in which it is NaN are
     * left out.
     */
    public fun average(k: Int): BlockAverage {
        if (pooled == null || samples.isEmpty()) {
            return BlockAverage.of(series(k).filter { !it.isNaN() }.toDoubleArray())
        }
        return (pool ?: Pool(pooled, samples).also { pool = it }).average(k)
    }

    /** Number [k] by sample. */
    public fun series(k: Int): DoubleArray = DoubleArray(samples.size) { numbers(it)[k] }

    private fun numbers(sample: Int) = if (pooled != null) pooled.finish(samples[sample], 1) else samples[sample]

    /** The sums of all samples, and what they come to without each one of them. */
    private class Pool(measure: PooledMeasure, samples: List<DoubleArray>) {
        private val n = samples.size
        private val all = DoubleArray(samples[0].size).also { for (s in samples) for (k in s.indices) it[k] += s[k] }
        private val whole = measure.finish(all, n)
        private val without = List(if (n > 1) n else 0) { i ->
            measure.finish(DoubleArray(all.size) { all[it] - samples[i][it] }, n - 1)
        }

        fun average(k: Int): BlockAverage {
            if (n == 1 || whole[k].isNaN()) return BlockAverage(whole[k], Double.NaN, n)
            val pseudovalues = DoubleArray(n) { whole[k] + (n - 1) * (whole[k] - without[it][k]) }
            val result = BlockAverage.of(pseudovalues, whole[k])
            // A state without a particle there says nothing, and its pseudovalue is the average itself.
            val telling = pseudovalues.count { abs(it - whole[k]) > ROUNDING * n * abs(whole[k]) }
            return if (telling in 1 until BlockAverage.FEWEST_NUMBERS) result.withoutError() else result
        }
    }

    private companion object {
        const val ROUNDING = 1e-12

        // Names of what is saved.
        const val COUNT = "count"
        const val SAMPLES = "samples"
    }
}
