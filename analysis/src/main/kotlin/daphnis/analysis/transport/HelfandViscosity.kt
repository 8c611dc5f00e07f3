package daphnis.analysis.transport

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.run.TransportColumns
import daphnis.core.run.TransportColumns.MASS
import kotlin.math.sqrt

/**
 * Shear viscosity of a gas at rest, of smooth elastic spheres in a box that repeats along all axes, by Einstein's and
 * Helfand's formula (Helfand 1960, Phys. Rev. 119, 1): how fast the integral of the stress walks away.
 *
 * G_ab(t) = Σ Δp_a δ_b + ∫ M⟨c_a c_b⟩ dt is taken from the rows of a [TransportTable], by the trapezium rule, for the
 * five shears of space: xy, xz, yz, (xx − yy)/2 and (xx + yy − 2zz)/√12. The gas is at rest, so their means are 0, and
 * none is subtracted. Then 2 V kT η is the slope of ⟨(G(t + s) − G(t))²⟩ between the lags s = L/2 and L, on average
 * over the five and all t. What is correlated over times shorter than L/2 counts in full.
 *
 * **Lag.** L is ten mean free times of a particle, or twice the time in which one of thermal speed √(⟨c²⟩/3) crosses a
 * diameter, if that is longer. The stress that particles carry decays within some 1.3 mean free times. A longer lag
 * adds noise: the error grows as √L.
 *
 * **Error.** From blocks of time as long as L ([BlockAverage]), so there is none below 16 of them.
 *
 * Rows must be evenly spaced and at most half a mean free time apart: with longer spaces, and the trapezium rule, what
 * particles carry would seem to be correlated for longer than it is. At half a mean free time that part of η is 1.3 %
 * too large.
 *
 * @property average η, mass/(length · time)
 * @property lag L, in the run's unit of time
 */
public class HelfandViscosity private constructor(public val average: BlockAverage, public val lag: Double) {
    public companion object {
        /** L in mean free times. */
        private const val FREE_TIMES = 10.0
        private val COMPONENTS = listOf("xx", "yy", "zz", "xy", "xz", "yz")

        /**
         * From all rows of [table]; null where these are too few, too far apart or not even, or without collisions. The
         * last row may be nearer: it is then left out.
         *
         * @param volume of the box
         * @param diameter mean of the spheres
         */
        @JvmStatic
        public fun of(table: TransportTable, volume: Double, diameter: Double): HelfandViscosity? {
            if (COMPONENTS.any { TransportColumns.moment(it) !in table }) return null
            val walk = HelfandWalk.of(table) ?: return null
            val half = walk.half(FREE_TIMES, diameter) ?: return null
            val slope = walk.slope(shears(table, walk), half) ?: return null
            val average = slope * (1 / (2 * volume * walk.thermal))
            return if (average.mean.isFinite()) HelfandViscosity(average, 2 * half * walk.step) else null
        }

        /** G of the five shears by row: what momentum particles carry, without what corrects a temperature of few. */
        private fun shears(table: TransportTable, walk: HelfandWalk): List<DoubleArray> {
            val mass = table[MASS]
            val all = COMPONENTS.map { component ->
                val carried = TransportColumns.kinetic(component).takeIf { it in table }
                val moment = table[carried ?: TransportColumns.moment(component)]
                walk.integral(TransportColumns.virial(component), DoubleArray(walk.rows) { mass[it] * moment[it] })
            }
            val (xx, yy, zz) = all
            val across = DoubleArray(walk.rows) { (xx[it] - yy[it]) / 2 }
            val upright = DoubleArray(walk.rows) { (xx[it] + yy[it] - 2 * zz[it]) / sqrt(12.0) }
            return all.drop(3) + listOf(across, upright)
        }
    }
}
