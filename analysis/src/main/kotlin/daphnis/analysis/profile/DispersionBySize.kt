package daphnis.analysis.profile

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.SizeGroups
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State

/**
 * Velocity dispersion, partial temperature and height of particles by size, or by any other [groups]. As a [Measure] it
 * gives [COLUMNS] for each group, entry `group · COLUMNS.size + column`.
 *
 * | column | what |
 * |---|---|
 * | count | particles in the group |
 * | mean_radius | their mean radius |
 * | c_xx, c_yy, c_zz | ⟨c_a²⟩ by number, c around the mean flow and the centre of mass of all particles |
 * | c2 | ⟨c²⟩, the sum of the three |
 * | h2 | ⟨(z − z₀)²⟩, z₀ the centre of mass of all |
 * | temperature | ⟨m c²⟩/3 (in the plane /2), the partial temperature, an energy: the same for all in equilibrium |
 *
 * A sphere with a share μ of all mass moves the centre of mass along, which reduces the plain mean square by about 2μ.
 * This is corrected, for spheres with independent velocities as well as for those that share one temperature. Means of
 * an empty group are NaN. All means are NaN if a group has spheres with half of all mass each.
 */
public class DispersionBySize(private val groups: SphereGroups) : Measure {
    /**
     * By classes of radii.
     *
     * @param edges lower edges of the classes and the upper edge of the last, ascending; the last class includes its
     *   upper edge
     */
    public constructor(edges: DoubleArray) : this(SizeGroups(edges))

    /** Number of groups. */
    public val classes: Int = groups.count

    override fun of(state: State): DoubleArray {
        val p = state.population
        val all = (0 until p.size).filter { state.isParticle(it) }.toIntArray()
        val share = all.sumOf { p.mass[it] }.let { mass -> DoubleArray(p.size) { p.mass[it] / mass } }
        val group = IntArray(p.size) { if (state.isParticle(it)) groups.of(state, it) else -1 }
        val result = DoubleArray(classes * WIDTH)
        for (k in all) {
            val at = group[k] * WIDTH
            if (at < 0) continue
            result[at]++
            result[at + 1] += p.radius[k]
        }
        for (c in 0 until classes) result[c * WIDTH + 1] /= result[c * WIDTH]
        for (axis in 0..2) put(result, 2 + axis, meanSquares(group, share, all, null) { state.againstFlow(it, axis) })
        for (c in 0 until classes) result[c * WIDTH + C2] = (2..4).sumOf { result[c * WIDTH + it] }
        put(result, H2, meanSquares(group, share, all, null) { p.z[it] })
        val energies = List(3) { axis -> meanSquares(group, share, all, p.mass) { state.againstFlow(it, axis) } }
        put(
            result,
            TEMPERATURE,
            DoubleArray(classes) { c ->
                energies.sumOf { it[c] } / state.boundary.space.dimensions
            },
        )
        return result
    }

    private fun put(result: DoubleArray, column: Int, values: DoubleArray) {
        for (c in 0 until classes) result[c * WIDTH + column] = values[c]
    }

    /**
     * ⟨w (v − V)²⟩ by group, V = Σ μ_k v_k, w the [weight] of a particle or 1, freed of what the particles themselves
     * put into V: with w_k ⟨v_k²⟩ = s the same for all of a group of n, its sum is s Σ (1 − 2μ_k) + W Σ w_k, where
     * W = ⟨V²⟩ = Σ_all μ_k² s/w_k: solved for the s of all groups at once.
     */
    private inline fun meanSquares(
        group: IntArray,
        share: DoubleArray,
        all: IntArray,
        weight: DoubleArray?,
        value: (Int) -> Double,
    ): DoubleArray {
        var centre = 0.0
        for (k in all) centre += share[k] * value(k)
        val count = DoubleArray(classes)
        val square = DoubleArray(classes)
        val free = DoubleArray(classes)
        val pull = DoubleArray(classes)
        for (k in all) {
            val c = group[k]
            if (c < 0) continue
            val d = value(k) - centre
            val w = if (weight == null) 1.0 else weight[k]
            count[c] += w
            square[c] += w * (d * d)
            free[c] += 1 - 2 * share[k]
            pull[c] += share[k] * share[k] / w
        }
        val filled = (0 until classes).filter { count[it] > 0 }
        if (filled.any { free[it] <= 0 }) return DoubleArray(classes) { Double.NaN }
        val ofCentre =
            filled.sumOf { pull[it] * square[it] / free[it] } / (1 + filled.sumOf { pull[it] * count[it] / free[it] })
        return DoubleArray(classes) {
            if (count[it] == 0.0) {
                Double.NaN
            } else {
                maxOf(0.0, (square[it] - count[it] * ofCentre) / free[it])
            }
        }
    }

    public companion object {
        @JvmField
        public val COLUMNS: List<String> =
            listOf("count", "mean_radius", "c_xx", "c_yy", "c_zz", "c2", "h2", "temperature")
        private val WIDTH = COLUMNS.size
        private const val C2 = 5
        private const val H2 = 6
        private const val TEMPERATURE = 7

        /**
         * By classes for the particles of [sample]: one for each radius when there are at most [most], else [most] of
         * equal width in ln r. Null for one size.
         */
        @JvmStatic
        @JvmOverloads
        public fun of(sample: State, most: Int = 8): DispersionBySize? =
            SizeGroups.of(sample, most)?.let { DispersionBySize(it) }
    }
}
