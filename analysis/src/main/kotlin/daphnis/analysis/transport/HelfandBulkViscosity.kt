package daphnis.analysis.transport

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.run.TransportColumns

/**
 * Bulk viscosity of a gas at rest, of smooth elastic spheres in a box that repeats along all axes, by Einstein's and
 * Helfand's formula, as [HelfandViscosity] has the shear viscosity and with its lags and errors.
 *
 * G(t) = Σ Δp·δ/3 − p̄ V t, with p̄ so that G is the same at the first row and the last. The part of the pressure that
 * particles carry is 2E/(3V), which does not change. Number and energy are constant, so the formula needs no terms in
 * their fluctuations (McQuarrie 1976, Statistical Mechanics, ch. 21-8). 2 V kT κ is the slope of ⟨(G(t + s) − G(t))²⟩.
 * A mean that is taken from the same rows makes it smaller by the factor 1 − 3L/2T in a time T, by which it is divided.
 *
 * @property average κ, mass/(length · time)
 * @property lag L, in the run's unit of time
 */
public class HelfandBulkViscosity private constructor(public val average: BlockAverage, public val lag: Double) {
    public companion object {
        /** L in mean free times. */
        private const val FREE_TIMES = 10.0
        private val DIAGONAL = listOf("xx", "yy", "zz")

        /** As [HelfandViscosity.of]. */
        @JvmStatic
        public fun of(table: TransportTable, volume: Double, diameter: Double): HelfandBulkViscosity? {
            if (DIAGONAL.any { TransportColumns.virial(it) !in table }) return null
            val walk = HelfandWalk.of(table) ?: return null
            val half = walk.half(FREE_TIMES, diameter) ?: return null
            val parts = DIAGONAL.map { walk.integral(TransportColumns.virial(it), null) }
            val sum = DoubleArray(walk.rows) { row -> parts.sumOf { it[row] } / 3 }
            val mean = sum.last() / (walk.rows - 1)
            val slope = walk.slope(listOf(DoubleArray(walk.rows) { sum[it] - mean * it }), half) ?: return null
            val kept = 1 - 3.0 * half / (walk.rows - 1)
            val average = slope * (1 / (2 * volume * walk.thermal * kept))
            return if (average.mean.isFinite()) HelfandBulkViscosity(average, 2 * half * walk.step) else null
        }
    }
}
