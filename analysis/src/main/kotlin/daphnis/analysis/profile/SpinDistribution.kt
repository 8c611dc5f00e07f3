package daphnis.analysis.profile

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State
import kotlin.math.PI
import kotlin.math.exp
import kotlin.math.sqrt

/**
 * The distribution of spins beside a Maxwellian: densities of the components s_x, s_y, s_z and of the modulus s, for
 * each of the [groups] by itself. s = √(I/T) (ω − ⟨ω⟩) with I the moment of inertia, ⟨ω⟩ the mean of the group weighted
 * by I, and T = ⟨I (ω − ⟨ω⟩)²⟩/3 of the group: so ⟨s²⟩ = 3, whatever the sizes, and states of a gas that cools can be
 * averaged; of discs ⟨s²⟩ = 1. As a [Measure] it gives 4 · [bins] numbers for each group: x, y, z, modulus, from entry
 * `(4 · group + which) · bins` on. NaN for a group of fewer than two, without spins, or whose spins are all the same.
 *
 * @param bins of equal width, of components from −[reach] to [reach], of the modulus from 0 to [reach]; what is farther
 *   out counts in the number of particles only
 */
public class SpinDistribution @JvmOverloads constructor(
    public val bins: Int = 40,
    public val reach: Double = 5.0,
    private val groups: SphereGroups = SphereGroups.ALL,
) : Measure {
    init {
        require(bins >= 1 && reach > 0 && reach.isFinite()) {
            "$bins bins up to $reach; there must be one at least, up to a number > 0"
        }
    }

    /** Middle of [bin] of a component. */
    public fun component(bin: Int): Double = reach * (2 * (bin + 0.5) / bins - 1)

    /** Middle of [bin] of the modulus. */
    public fun modulus(bin: Int): Double = reach * (bin + 0.5) / bins

    override fun of(state: State): DoubleArray {
        val p = state.population
        val result = DoubleArray(4 * bins * groups.count)
        val group = IntArray(p.size) { if (state.isParticle(it)) groups.of(state, it) else -1 }
        for (g in 0 until groups.count) count(state, group.indices.filter { group[it] == g }, result, g * 4 * bins)
        return result
    }

    private fun count(state: State, of: List<Int>, result: DoubleArray, at: Int) {
        val p = state.population
        val inertia = of.map { p.mass[it] * p.radius[it] * p.radius[it] }
        val whole = inertia.sum()
        val spins = if (p.hasSpin) listOf(p.wx, p.wy, p.wz) else emptyList()
        val peculiar = spins.map { w ->
            val mean = of.indices.sumOf { inertia[it] * w[of[it]] } / whole
            DoubleArray(of.size) { w[of[it]] - mean }
        }
        val temperature =
            peculiar.sumOf { w -> of.indices.sumOf { inertia[it] * w[it] * w[it] } } /
                (state.boundary.space.rotations * of.size)
        if (of.size < 2 || !(temperature > 0)) {
            result.fill(Double.NaN, at, at + 4 * bins)
            return
        }
        for (k in of.indices) {
            val unit = sqrt(inertia[k] / temperature)
            var square = 0.0
            for ((axis, w) in peculiar.withIndex()) {
                val s = unit * w[k]
                square += s * s
                add(result, at + axis * bins, (s / reach + 1) / 2 * bins)
            }
            add(result, at + 3 * bins, sqrt(square) / reach * bins)
        }
        for (k in 0 until 4 * bins) result[at + k] *= bins / (of.size * (if (k < 3 * bins) 2 * reach else reach))
    }

    private fun add(result: DoubleArray, at: Int, place: Double) {
        if (place >= 0 && place < bins) result[at + place.toInt()]++
    }

    public companion object {
        /** Density of a component [s] of a Maxwellian, exp(−s²/2)/√(2π). */
        @JvmStatic
        public fun ofComponent(s: Double): Double = exp(-s * s / 2) / sqrt(2 * PI)

        /** Density of the modulus [s] of a Maxwellian, √(2/π) s² exp(−s²/2). */
        @JvmStatic
        public fun ofModulus(s: Double): Double = sqrt(2 / PI) * s * s * exp(-s * s / 2)
    }
}
