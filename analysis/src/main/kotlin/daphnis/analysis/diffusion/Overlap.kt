package daphnis.analysis.diffusion

import daphnis.analysis.statistics.OfMeans

/**
 * How much of a state is where it was: the overlap Q(t), the part of the particles which are no farther than [reach]
 * from where they were a lag t before, averaged over origins, and the dynamic susceptibility χ₄(t) = N (⟨Q²⟩ − ⟨Q⟩²),
 * which is large where particles move in groups (Lačević, Starr, Schrøder & Glotzer 2003, J. Chem. Phys. 119, 7372).
 * Particles that move independently have χ₄ = Q (1 − Q). [trajectories] hold all N particles of an isotropic gas, with
 * all its coordinates, relative to their centre of mass. χ₄ is that of a box with constant number and energy, and lower
 * than that of an open system (Berthier et al. 2005, Science 310, 1797).
 *
 * Lags are those of [SelfScattering]. Errors are from blocks of time as long as the lag. The variance of a run is freed
 * of the bias that the measured mean brings. NaN where the time is shorter than five lags.
 *
 * @param reach in length; 0.3 diameters by custom
 * @throws IllegalArgumentException for fewer than [MeanSquareDisplacement.FEWEST_TIMES] times or 2 particles, or a reach
 *   that is not positive
 */
public class Overlap(trajectories: Trajectories, public val reach: Double) {
    /** Lags in units of time, ascending. */
    public val lag: DoubleArray

    /** Q by lag. */
    public val overlap: DoubleArray

    /** One standard error of [overlap]; NaN at lags that are too long for the time. */
    public val overlapError: DoubleArray

    /** χ₄ by lag; NaN at lags that are too long for the time. */
    public val susceptibility: DoubleArray

    /** One standard error of [susceptibility]; NaN at lags that are too long for the time. */
    public val susceptibilityError: DoubleArray

    init {
        require(trajectories.size >= MeanSquareDisplacement.FEWEST_TIMES) {
            "${trajectories.size} times; there must be ${MeanSquareDisplacement.FEWEST_TIMES} at least"
        }
        require(trajectories.particles >= 2) { "one particle; there must be 2 at least" }
        require(reach > 0 && reach.isFinite()) { "the reach is $reach; it must be positive" }
        val steps = Lags.upToHalf(trajectories.size)
        val n = trajectories.particles
        lag = DoubleArray(steps.size) { Lags.mean(trajectories.size, steps[it], trajectories::time) }
        overlap = DoubleArray(steps.size)
        overlapError = DoubleArray(steps.size)
        susceptibility = DoubleArray(steps.size)
        susceptibilityError = DoubleArray(steps.size)
        for ((l, step) in steps.withIndex()) {
            val q = DoubleArray(trajectories.size - step) { share(trajectories, it, it + step) }
            overlap[l] = q.average()
            overlapError[l] = OverOrigins.error(q, step)
            // Around the mean: no digits are lost where nothing fluctuates.
            val apart = DoubleArray(q.size) { q[it] - overlap[l] }
            val squares = DoubleArray(q.size) { apart[it] * apart[it] }
            susceptibility[l] = n * (squares.average() + overlapError[l] * overlapError[l])
            susceptibilityError[l] = n * OverOrigins.error(arrayOf(apart, squares), step, function = VARIANCE)
        }
    }

    private fun share(t: Trajectories, first: Int, second: Int): Double {
        var near = 0
        for (k in 0 until t.particles) {
            var square = 0.0
            for (axis in t.coordinates.indices) {
                val d = t.at(second, axis)[k] - t.at(first, axis)[k]
                square += d * d
            }
            if (square <= reach * reach) near++
        }
        return near.toDouble() / t.particles
    }

    private companion object {
        val VARIANCE = OfMeans { it[1] - it[0] * it[0] }
    }
}
