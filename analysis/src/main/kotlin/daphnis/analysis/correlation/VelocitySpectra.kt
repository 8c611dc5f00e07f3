package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.State

/**
 * Spectra of momentum and density of a gas, as of one that cools and forms vortices and clusters (van Noije, Ernst,
 * Brito & Orza 1997, Phys. Rev. Lett. 79, 411): with j = Σ m (v − ⟨v⟩) exp(i k·r), the part of j across k is vorticity,
 * that along k compression. As a [Measure] it gives three numbers for each bin of |k| from 0 to [largest], from entries
 * 0, [bins] and 2 [bins] on:
 *
 * - S_⊥(k) = |j_⊥|²/((d − 1) N τ) and S_∥(k) = |j_∥|²/(N τ) with τ = ⟨m² (v − ⟨v⟩)²⟩/d: both are 1 where velocities of
 *   different particles have nothing in common;
 * - S(k) = |Σ exp(i k·r)|²/N, the structure factor.
 *
 * ⟨v⟩ is by mass; of sheared boxes v is around the straight flow. NaN in bins without a wave vector, and for fewer than
 * two particles or particles at rest. Time and the choice of wave vectors are those of [SpatialStructureFactor].
 *
 * @param largest largest |k|, in 1/length
 */
public class VelocitySpectra(public val largest: Double, public val bins: Int) : Measure {
    init {
        require(largest > 0 && largest.isFinite() && bins >= 1) { "$bins bins up to $largest; both must be positive" }
    }

    /** Mean |k| of the wave vectors that are taken of [state], by bin; the middle of a bin without any. */
    public fun waveNumbers(state: State): DoubleArray =
        vectors(state, (0 until state.population.size).count(state::isParticle)).meanLengths()

    override fun of(state: State): DoubleArray {
        val p = state.population
        val d = state.dimensions
        val particles = (0 until p.size).filter { state.isParticle(it) }.toIntArray()
        val result = DoubleArray(3 * bins) { Double.NaN }
        val momenta = momenta(state, particles)
        val unit = particles.sumOf { i -> momenta.sumOf { it[i] * it[i] } } / d
        if (particles.size < 2 || !(unit > 0)) return result
        val vectors = vectors(state, particles.size)
        val sums = WaveSums(state, vectors).over(particles, listOf(null) + momenta)
        val count = IntArray(bins)
        val total = DoubleArray(3 * bins)
        for (j in 0 until vectors.size) {
            val bin = vectors.shell[j]
            count[bin]++
            var whole = 0.0
            var along = 0.0
            for (part in 0..1) {
                var projected = 0.0
                for (axis in 0 until d) {
                    val q = sums[1 + axis][part][j]
                    whole += q * q
                    projected += q * vectors.component(axis, j) / vectors.length(j)
                }
                along += projected * projected
                total[2 * bins + bin] += sums[0][part][j].let { it * it } / particles.size
            }
            total[bin] += (whole - along) / ((d - 1) * unit)
            total[bins + bin] += along / unit
        }
        for (k in total.indices) if (count[k % bins] > 0) result[k] = total[k] / count[k % bins]
        return result
    }

    private fun vectors(state: State, particles: Int) =
        WaveVectors(state.boundary, state.time, largest, bins, WaveVectors.most(MOST_WORK, particles, bins))

    private fun momenta(state: State, particles: IntArray): List<DoubleArray> {
        val p = state.population
        val mass = particles.sumOf { p.mass[it] }
        return List(state.dimensions) { axis ->
            val mean = particles.sumOf { p.mass[it] * state.againstFlow(it, axis) } / mass
            DoubleArray(p.size) { p.mass[it] * (state.againstFlow(it, axis) - mean) }
        }
    }

    private companion object {
        const val MOST_WORK = 15_000_000L
    }
}
