package daphnis.analysis.profile

import daphnis.analysis.insitu.Measure
import daphnis.analysis.insitu.SphereGroups
import daphnis.analysis.insitu.State
import daphnis.core.surface.SurfaceContact

/**
 * How particles spin, by [groups], such as classes of size; in Hill's frame relative to the frame. As a [Measure] it
 * gives [COLUMNS] for each group, entry `group · COLUMNS.size + column`.
 *
 * | column | what |
 * |---|---|
 * | count | particles in the group |
 * | mean_radius, mean_mass | their mean radius and mass |
 * | mean_wx, mean_wy, mean_wz | ⟨ω_a⟩ by number, 1/time |
 * | w2 | ⟨ω²⟩ by number, 1/time² |
 * | temperature | ⟨I ω²⟩/3 (in the plane ⟨I ω²⟩), the partial temperature of rotation, an energy; the mean spin is not taken off |
 *
 * `temperature` over `mean_mass` is what `series.csv` calls `rotational_temperature`. Means of an empty group are NaN,
 * and all means of spheres without spins.
 *
 * @param momentFactor moment of inertia of spheres over mass · radius²
 */
public class RotationByGroup @JvmOverloads constructor(
    private val groups: SphereGroups = SphereGroups.ALL,
    private val momentFactor: Double = SurfaceContact.SOLID,
) : Measure {
    override fun of(state: State): DoubleArray {
        val p = state.population
        val result = DoubleArray(groups.count * WIDTH)
        val rotations = state.boundary.space.rotations
        for (k in 0 until p.size) {
            val group = if (state.isParticle(k)) groups.of(state, k) else -1
            if (group < 0) continue
            val at = group * WIDTH
            result[at]++
            result[at + 1] += p.radius[k]
            result[at + 2] += p.mass[k]
            if (!p.hasSpin) continue
            val square = p.wx[k] * p.wx[k] + p.wy[k] * p.wy[k] + p.wz[k] * p.wz[k]
            result[at + SPIN] += p.wx[k]
            result[at + SPIN + 1] += p.wy[k]
            result[at + SPIN + 2] += p.wz[k]
            result[at + SQUARE] += square
            result[at + SQUARE + 1] += momentFactor * p.mass[k] * p.radius[k] * p.radius[k] * square / rotations
        }
        for (group in 0 until groups.count) {
            val at = group * WIDTH
            for (column in 1 until WIDTH) {
                val isKnown = p.hasSpin || column < SPIN
                result[at + column] = if (isKnown) result[at + column] / result[at] else Double.NaN
            }
        }
        return result
    }

    public companion object {
        @JvmField
        public val COLUMNS: List<String> =
            listOf("count", "mean_radius", "mean_mass", "mean_wx", "mean_wy", "mean_wz", "w2", "temperature")
        private val WIDTH = COLUMNS.size
        private const val SPIN = 3
        private const val SQUARE = 6
    }
}
