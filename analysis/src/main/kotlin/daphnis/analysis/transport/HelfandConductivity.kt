package daphnis.analysis.transport

import daphnis.analysis.statistics.BlockAverage
import daphnis.core.run.TransportColumns
import daphnis.core.run.TransportColumns.COLLISIONAL_HEAT
import daphnis.core.run.TransportColumns.KINETIC_HEAT
import daphnis.core.run.TransportColumns.MEAN_VELOCITY

/**
 * Heat conductivity λ of a gas at rest, of equal smooth elastic spheres in a box that repeats along all axes, by
 * Einstein's and Helfand's formula (Helfand 1960, Phys. Rev. 119, 1), with errors as in [HelfandViscosity].
 *
 * G_a(t) = Σ ΔE δ_a + ∫ Σ ½ m c² c_a dt, with ΔE the energy that a sphere gains in a collision and δ the vector to it
 * from the other, both in the frame of the centre of mass. There the enthalpy that flows with the mass is 0, so none is
 * subtracted. Energy does not change, so no mean is. The flux is −(λ/k) ∇(kT), and 2 V (kT)² λ/k is the slope of
 * ⟨(G(t + s) − G(t))²⟩ between L/2 and L, on average over three axes and all t.
 *
 * **Lag.** L is fifteen mean free times, or the time in which a sphere of thermal speed crosses two diameters, if that
 * is longer. The flux that particles carry decays within some 1.9 mean free times.
 *
 * @property average λ/k, 1/(length · time)
 * @property lag L, in the run's unit of time
 */
public class HelfandConductivity private constructor(public val average: BlockAverage, public val lag: Double) {
    public companion object {
        /** L in mean free times. */
        private const val FREE_TIMES = 15.0
        private val VIRIALS = listOf(listOf("xx", "xy", "xz"), listOf("xy", "yy", "yz"), listOf("xz", "yz", "zz"))

        /** As [HelfandViscosity.of]; null also for a table without the columns of heat. */
        @JvmStatic
        public fun of(table: TransportTable, volume: Double, diameter: Double): HelfandConductivity? {
            val needed =
                KINETIC_HEAT + COLLISIONAL_HEAT + MEAN_VELOCITY + VIRIALS.flatten().map(TransportColumns::virial)
            if (needed.any { it !in table }) return null
            val walk = HelfandWalk.of(table) ?: return null
            val half = walk.half(FREE_TIMES, diameter) ?: return null
            val slope = walk.slope((0..2).map { flux(table, walk, it) }, half) ?: return null
            val average = slope * (1 / (2 * volume * walk.thermal * walk.thermal))
            return if (average.mean.isFinite()) HelfandConductivity(average, 2 * half * walk.step) else null
        }

        /** G along [axis] by row. In the box ΔE has the centre of mass's velocity times Δp on top. */
        private fun flux(table: TransportTable, walk: HelfandWalk, axis: Int): DoubleArray {
            val flux = walk.integral(COLLISIONAL_HEAT[axis], table[KINETIC_HEAT[axis]])
            for ((b, component) in VIRIALS[axis].withIndex()) {
                val virial = walk.integral(TransportColumns.virial(component), null)
                val velocity = table[MEAN_VELOCITY[b]][0]
                for (row in flux.indices) flux[row] -= velocity * virial[row]
            }
            return flux
        }
    }
}
