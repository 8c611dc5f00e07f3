package daphnis.analysis.profile

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.PeculiarVelocities
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State

/**
 * How far the velocities of particles, and their spins, are from a Maxwellian: the fourth cumulants, which are 0 for it.
 * As a [Measure] it gives [COLUMNS] for each of the [groups], entry `group · COLUMNS.size + column`.
 *
 * | column | what |
 * |---|---|
 * | count | particles in the group |
 * | a2 | of velocities: ⟨c⁴⟩ = (5/3) ⟨c²⟩² (1 + a₂) (of discs 2 ⟨c²⟩²), which is (15/4) v₀⁴ (1 + a₂) with v₀² = 2T/m |
 * | spin_a2 | of spins: ⟨w⁴⟩ = (5/3) ⟨w²⟩² (1 + a₀₂) |
 * | mixed_a2 | of both: ⟨c² w²⟩ = ⟨c²⟩ ⟨w²⟩ (1 + a₁₁) |
 *
 * c is the peculiar velocity, around the mean flow as it is measured, and w the spin around the mean weighted by the
 * moments of inertia. Where masses or radii differ, √m c and √I w stand for c and w: then equilibrium has 0, whatever
 * the sizes. Numbers are without bias for Maxwellians of any number of particles, also where that of a state is small.
 * A plain mean of few would be too small, by 2/(3N).
 *
 * NaN for fewer than three particles in a group, for a group at rest, and of spins where there are none.
 *
 * Velocities: van Noije & Ernst 1998, Granular Matter 1, 57. Spins: Santos, Kremer & dos Santos 2011, Phys. Fluids 23,
 * 030604.
 */
public class FourthCumulants @JvmOverloads constructor(private val groups: SphereGroups = SphereGroups.ALL) : Measure {
    override fun of(state: State): DoubleArray {
        val p = state.population
        val result = DoubleArray(groups.count * WIDTH) { if (it % WIDTH == 0) 0.0 else Double.NaN }
        if (p.size == 0) return result
        val velocities = PeculiarVelocities(state)
        val of = velocities.particles
        val group = IntArray(of.size) { groups.of(state, of[it]) }
        val c2 = DoubleArray(of.size) { k -> velocities.components.sumOf { it[k] * it[k] } * p.mass[of[k]] }
        val energy = of.sumOf { p.mass[it] * (p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it]) }
        val space = state.boundary.space
        val c = Squares(c2, ROUNDING * energy) { k, axis ->
            if (axis < space.dimensions) velocities.freedom(k, axis) else 0.0
        }
        val w = if (p.hasSpin) spins(state, of) else null
        for (g in 0 until groups.count) {
            val members = group.indices.filter { group[it] == g }
            val at = g * WIDTH
            result[at] = members.size.toDouble()
            if (members.size < FEWEST) continue
            result[at + 1] = c.cumulant(members)
            if (w == null) continue
            result[at + 2] = w.cumulant(members)
            result[at + 3] = c.mixed(w, members)
        }
        return result
    }

    private fun spins(state: State, of: IntArray): Squares {
        val p = state.population
        // The factor of the moment of inertia cancels.
        val inertia = DoubleArray(of.size) { p.mass[of[it]] * p.radius[of[it]] * p.radius[of[it]] }
        val whole = inertia.sum()
        val w2 = DoubleArray(of.size)
        var energy = 0.0
        for (w in listOf(p.wx, p.wy, p.wz)) {
            val mean = of.indices.sumOf { inertia[it] * w[of[it]] } / whole
            for (k in of.indices) {
                w2[k] += inertia[k] * (w[of[k]] - mean) * (w[of[k]] - mean)
                energy += inertia[k] * w[of[k]] * w[of[k]]
            }
        }
        return Squares(w2, ROUNDING * energy) { k, axis ->
            if (axis >= 3 - state.boundary.space.rotations) maxOf(0.0, 1 - inertia[k] / whole) else 0.0
        }
    }

    /**
     * @param least sum of [values] below which they are nothing but round-off
     * @param freedom of particle k along an axis: its mean square over that around the true mean
     */
    private class Squares(
        private val values: DoubleArray,
        private val least: Double,
        private val freedom: (k: Int, axis: Int) -> Double,
    ) {
        private fun sum(of: List<Int>) = of.sumOf { values[it] }.let { if (it > least) it else Double.NaN }

        /**
         * Gaussian components fill the sphere of n = Σ freedom dimensions evenly, whatever its radius R. So the mean of
         * a fourth power is that of a Gaussian times R⁴/(n(n + 2)), and a₂ is 0 on average.
         */
        fun cumulant(of: List<Int>): Double {
            var n = 0.0
            var fourth = 0.0
            for (k in of) {
                val (x, y, z) = List(3) { freedom(k, it) }
                n += x + y + z
                fourth += 3 * (x * x + y * y + z * z) + 2 * (x * y + y * z + z * x)
            }
            val square = sum(of)
            return of.sumOf { values[it] * values[it] } / (square * square) * (n * (n + 2) / fourth) - 1
        }

        /** Each particle has the share of the squares that its freedoms have of all, whatever the other quantity is. */
        fun mixed(other: Squares, of: List<Int>): Double {
            val both = of.sumOf { values[it] * other.values[it] } / sum(of) / other.sum(of)
            val alone = of.sumOf { free(it) * other.free(it) } / of.sumOf { free(it) } / of.sumOf { other.free(it) }
            return both / alone - 1
        }

        private fun free(k: Int) = freedom(k, 0) + freedom(k, 1) + freedom(k, 2)
    }

    public companion object {
        @JvmField
        public val COLUMNS: List<String> = listOf("count", "a2", "spin_a2", "mixed_a2")
        private val WIDTH = COLUMNS.size
        private const val FEWEST = 3

        /** Energy of peculiar motion over that of all motion which is none. */
        private const val ROUNDING = 1e-26
    }
}
