package daphnis.core.wave

import daphnis.core.population.ExactSum
import daphnis.core.population.ParticleBlock

/**
 * Σ w, Σ w cos(k_m x) and Σ w sin(k_m x) of some spheres, for m up to [order], as exact sums: threads may take parts of
 * a population and merge them.
 */
internal class HarmonicSums(val order: Int) {
    private val cosines = Array(order + 1) { ExactSum() }
    private val sines = Array(order + 1) { ExactSum() }
    private val terms = DoubleArray(ParticleBlock.SPHERES)

    /** Σ w cos(k_m x); Σ w for [m] = 0. */
    fun cosine(m: Int): Double = cosines[m].value()

    /** Σ w sin(k_m x). */
    fun sine(m: Int): Double = sines[m].value()

    fun clear() {
        for (sum in cosines) sum.clear()
        for (sum in sines) sum.clear()
    }

    fun merge(other: HarmonicSums) {
        for (m in 0..order) {
            cosines[m].add(other.cosines[m])
            sines[m].add(other.sines[m])
        }
    }

    /** Adds the first [size] of [weights], whose spheres are at the [phases] of harmonic m. */
    fun add(phases: HarmonicPhases, weights: DoubleArray, size: Int) {
        val m = phases.harmonic
        if (m == 0) {
            cosines[0].addAll(weights, 0, size)
            return
        }
        for (i in 0 until size) terms[i] = weights[i] * phases.cosine[i]
        cosines[m].addAll(terms, 0, size)
        for (i in 0 until size) terms[i] = weights[i] * phases.sine[i]
        sines[m].addAll(terms, 0, size)
    }
}

/**
 * cos(k_m x) and sin(k_m x) of a block of spheres, for one m after another. Those of m = 1 are of [StrictMath], each
 * further one is a product with them, so they have the same bits on every machine.
 */
internal class HarmonicPhases(private val wavenumber: Double) {
    private val cosineOfFirst = DoubleArray(ParticleBlock.SPHERES)
    private val sineOfFirst = DoubleArray(ParticleBlock.SPHERES)
    private var size = 0

    /** m. */
    var harmonic = 0
        private set
    val cosine = DoubleArray(ParticleBlock.SPHERES)
    val sine = DoubleArray(ParticleBlock.SPHERES)

    /** Takes over where the spheres of [block] are [along] the wave, at m = 0. */
    fun begin(block: ParticleBlock, along: DoubleArray) {
        size = block.size
        for (i in 0 until size) {
            val phase = wavenumber * along[block.index[i]]
            cosineOfFirst[i] = StrictMath.cos(phase)
            sineOfFirst[i] = StrictMath.sin(phase)
        }
        rewind()
    }

    /** Back to m = 0. */
    fun rewind() {
        harmonic = 0
        cosine.fill(1.0, 0, size)
        sine.fill(0.0, 0, size)
    }

    /** On to the next m. */
    fun next() {
        harmonic++
        for (i in 0 until size) {
            val c = cosine[i]
            val s = sine[i]
            cosine[i] = c * cosineOfFirst[i] - s * sineOfFirst[i]
            sine[i] = s * cosineOfFirst[i] + c * sineOfFirst[i]
        }
    }
}
