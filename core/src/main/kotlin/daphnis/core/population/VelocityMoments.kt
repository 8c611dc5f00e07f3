package daphnis.core.population

import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.space.Space
import kotlin.math.sqrt

/**
 * Second moments of the velocities of a population, weighted by mass, around two mean flows.
 *
 * @property moments ⟨c_a c_b⟩ in (length/time)²: xx, yy, zz, xy, xz, yz; c is the peculiar velocity, which is the
 *   velocity minus the measured mean flow, and the result is corrected for the degrees of freedom that the fit takes
 *   ([granularTemperature] is a third of xx + yy + zz)
 * @property kinetic ⟨w_a w_b⟩ in the same order; w is the velocity without the boundary's [MeanFlow] (with its rate, a
 *   straight line through the origin) and without the mean of the remainder. Times mass over volume it is the kinetic
 *   part of the pressure tensor, for which the energy balance of a shear flow holds
 * @property mean ⟨velocity − the boundary's flow⟩ along x, y, z
 * @property centreZ mean height
 * @property scaleHeight √⟨(z − centre)²⟩
 * @property guidingX Σ m X / Σ m with X the guiding centre in Hill's frame; otherwise the mean of x
 */
public class VelocityMoments private constructor(
    public val moments: DoubleArray,
    public val kinetic: DoubleArray,
    public val mean: DoubleArray,
    public val centreZ: Double,
    public val scaleHeight: Double,
    public val guidingX: Double,
    private val space: Space,
) {
    /** √(⟨w_x²⟩ + ⟨w_y²⟩ + ⟨w_z²⟩): of all motion against the boundary's flow, that of waves too. */
    public val totalDispersion: Double get() = sqrt(kinetic[XX] + kinetic[YY] + kinetic[ZZ])

    /** √(⟨c_x²⟩ + ⟨c_y²⟩ + ⟨c_z²⟩), the velocity dispersion of ring dynamics. */
    public val dispersion: Double get() = sqrt(moments[XX] + moments[YY] + moments[ZZ])

    /** ⟨c²⟩/3, in the plane ⟨c²⟩/2. */
    public val temperature: Double get() = (moments[XX] + moments[YY] + moments[ZZ]) / space.dimensions

    public companion object {
        public const val XX: Int = 0
        public const val YY: Int = 1
        public const val ZZ: Int = 2
        public const val XY: Int = 3
        public const val XZ: Int = 4
        public const val YZ: Int = 5

        /** The components of the moments in their order. */
        @JvmField
        public val COMPONENTS: List<String> = listOf("xx", "yy", "zz", "xy", "xz", "yz")

        /**
         * The moments of [population], where the boundary drives [flow], from exact sums. All zero for no spheres.
         *
         * @param frequencies of orbits in Hill's frame, or null
         * @param leastId spheres with this id or a higher one are left out, such as moonlets; [Int.MAX_VALUE] for none
         */
        @JvmStatic
        @JvmOverloads
        public fun of(
            population: Population,
            flow: MeanFlow?,
            frequencies: OrbitalFrequencies? = null,
            leastId: Int = Int.MAX_VALUE,
        ): VelocityMoments = of(population, PopulationSums(flow, frequencies, leastId))

        /** The moments of [population] where flow and space are those of [within]. */
        @JvmStatic
        @JvmOverloads
        public fun within(
            within: Kinematics,
            population: Population,
            frequencies: OrbitalFrequencies? = null,
            leastId: Int = Int.MAX_VALUE,
        ): VelocityMoments = of(population, PopulationSums(within.meanFlow, frequencies, leastId, within.space))

        private fun of(population: Population, sums: PopulationSums): VelocityMoments {
            sums.take(population)
            return VelocityMoments(
                sums.moments,
                sums.kinetic,
                sums.mean,
                sums.centreZ,
                sums.scaleHeight,
                sums.guidingX,
                sums.space,
            )
        }
    }
}
