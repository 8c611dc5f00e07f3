package daphnis.analysis.correlation

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State
import kotlin.math.sqrt

/**
 * Static structure factor S(k) = |Σ exp(i k·r)|²/N of the wave vectors of space that fit the box, averaged over
 * directions in bins of |k| from 0 to [largest]. Wave vectors go along the axes that have images, so those of discs are
 * in their plane, and lean with images that slide. As a [Measure] it gives S by bin. With more than one of the
 * [groups], the partial structure factors of Ashcroft & Langreth (1967, Phys. Rev. 156, 685) follow:
 * S_ab(k) = Re Σ_a exp(i k·r) Σ_b exp(−i k·r)/√(N_a N_b), from [first] (a, b) on. These go to 1 for a = b at large k,
 * to 0 otherwise; S is Σ √(x_a x_b) S_ab over all ordered pairs. Particles in no group count nowhere.
 *
 * NaN in a bin without a wave vector, and without particles. Time goes with particles times wave vectors: where these
 * are more than 6 · 10⁶, each bin has as many vectors, spread over its directions: some 30 at least up to 10⁵ particles,
 * fewer of more, and the same ones in every state. In a fluid another choice is another sample of the same mean. In a
 * crystal S is that of a few vectors, which may be among those left out: then the bins of its peaks are wrong.
 *
 * @param largest largest |k|, in 1/length
 */
public class SpatialStructureFactor @JvmOverloads constructor(
    public val largest: Double,
    public val bins: Int,
    private val groups: SphereGroups = SphereGroups.ALL,
) : Measure {
    init {
        require(largest > 0 && largest.isFinite() && bins >= 1) { "$bins bins up to $largest; both must be positive" }
    }

    /** Mean |k| of the wave vectors that are taken of [state], by bin; the middle of a bin without any. */
    public fun waveNumbers(state: State): DoubleArray =
        vectors(state, (0 until state.population.size).count { isMember(state, it) }).meanLengths()

    /**
     * Where the bins of the groups [a] and [b] begin among the numbers, for two groups or more; both orders are one.
     */
    public fun first(a: Int, b: Int): Int {
        val low = minOf(a, b)
        require(low >= 0 && maxOf(a, b) < groups.count) { "groups $a and $b; there are ${groups.count}, from 0 on" }
        return if (groups.count == 1) 0 else (1 + low * (2 * groups.count - low - 1) / 2 + maxOf(a, b)) * bins
    }

    override fun of(state: State): DoubleArray {
        val n = groups.count
        val members = List(n) { ArrayList<Int>() }
        for (i in 0 until state.population.size) {
            if (isMember(state, i)) members[groups.of(state, i)] += i
        }
        val particles = members.sumOf { it.size }
        val vectors = vectors(state, particles)
        val sums = WaveSums(state, vectors).let { w -> members.map { w.over(it.toIntArray(), listOf(null))[0] } }
        val result = DoubleArray(bins * (if (n == 1) 1 else 1 + n * (n + 1) / 2))
        val count = IntArray(bins).also { for (s in vectors.shell) it[s]++ }
        for (j in 0 until vectors.size) {
            val bin = vectors.shell[j]
            val c = sums.sumOf { it[0][j] }
            val s = sums.sumOf { it[1][j] }
            result[bin] += (c * c + s * s) / particles
            if (n == 1) continue
            for (a in 0 until n) {
                for (b in a until n) {
                    val both = sums[a][0][j] * sums[b][0][j] + sums[a][1][j] * sums[b][1][j]
                    result[first(a, b) + bin] += both / sqrt(members[a].size.toDouble() * members[b].size)
                }
            }
        }
        for (k in result.indices) result[k] = if (count[k % bins] == 0) Double.NaN else result[k] / count[k % bins]
        return result
    }

    private fun isMember(state: State, index: Int) = state.isParticle(index) && groups.of(state, index) >= 0

    private fun vectors(state: State, particles: Int) =
        WaveVectors(state.boundary, state.time, largest, bins, WaveVectors.most(MOST_WORK, particles, bins))

    private companion object {
        /** Particles times wave vectors: some 20 ms. */
        const val MOST_WORK = 6_000_000L
    }
}
