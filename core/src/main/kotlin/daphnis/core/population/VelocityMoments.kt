package daphnis.core.population

import kotlin.math.sqrt

/**
 * Second moments of the peculiar velocities of a population, weighted by mass: c is what is left of the velocity when the mean [MeanFlow] (with its rate, a
 * straight line through the origin) and the mean of the rest are taken out.
 *
 * @property moments ⟨c_a c_b⟩ in (length/time)²: xx, yy, zz, xy, xz, yz
 * @property mean ⟨velocity − flow⟩ along x, y, z
 * @property centreZ mean height
 * @property scaleHeight √⟨(z − centre)²⟩
 * @property guidingX Σ m X / Σ m, X = 4x + 2 v_y/Ω, in Hill's frame; else the mean of x
 */
public class VelocityMoments private constructor(
    public val moments: DoubleArray,
    public val mean: DoubleArray,
    public val centreZ: Double,
    public val scaleHeight: Double,
    public val guidingX: Double,
) {
    /** √(σ_x² + σ_y² + σ_z²), the velocity dispersion of ring dynamics. */
    public val dispersion: Double get() = sqrt(moments[XX] + moments[YY] + moments[ZZ])

    public companion object {
        public const val XX: Int = 0
        public const val YY: Int = 1
        public const val ZZ: Int = 2
        public const val XY: Int = 3
        public const val XZ: Int = 4
        public const val YZ: Int = 5

        /** The components of the moments in the order in which they stand. */
        public val COMPONENTS: List<String> = listOf("xx", "yy", "zz", "xy", "xz", "yz")

        private val FIRST = intArrayOf(0, 1, 2, 0, 0, 1)
        private val SECOND = intArrayOf(0, 1, 2, 1, 2, 2)

        /**
         * The moments of [population] around [flow]; sums in the order of ids. All zero for no spheres.
         *
         * @param omega angular speed of Hill's frame, or null
         * @param leastId spheres with ids from this on are left out, such as moonlets
         */
        public fun of(population: Population, flow: MeanFlow?, omega: Double? = null, leastId: Int = Int.MAX_VALUE): VelocityMoments {
            val p = population
            val positions = arrayOf(p.x, p.y, p.z)
            val across = positions[flow?.normalAxis ?: 0]
            val rate = DoubleArray(3).also { if (flow != null) it[flow.flowAxis] = flow.rate }
            var mass = 0.0
            var height = 0.0
            var guiding = 0.0
            val mean = DoubleArray(3)
            val bound = minOf(p.idBound, leastId)
            for (id in 0 until bound) {
                val k = p.indexOf(id)
                if (k < 0) continue
                val m = p.mass[k]
                mass += m
                mean[0] += m * (p.vx[k] - rate[0] * across[k])
                mean[1] += m * (p.vy[k] - rate[1] * across[k])
                mean[2] += m * (p.vz[k] - rate[2] * across[k])
                height += m * p.z[k]
                guiding += m * if (omega != null) 4 * p.x[k] + 2 * p.vy[k] / omega else p.x[k]
            }
            if (mass == 0.0) return VelocityMoments(DoubleArray(6), mean, 0.0, 0.0, 0.0)
            for (axis in 0..2) mean[axis] /= mass
            val centre = height / mass
            val moments = DoubleArray(6)
            val c = DoubleArray(3)
            var square = 0.0
            for (id in 0 until bound) {
                val k = p.indexOf(id)
                if (k < 0) continue
                val m = p.mass[k]
                c[0] = p.vx[k] - rate[0] * across[k] - mean[0]
                c[1] = p.vy[k] - rate[1] * across[k] - mean[1]
                c[2] = p.vz[k] - rate[2] * across[k] - mean[2]
                for (e in 0 until 6) moments[e] += m * c[FIRST[e]] * c[SECOND[e]]
                square += m * (p.z[k] - centre) * (p.z[k] - centre)
            }
            for (e in 0 until 6) moments[e] /= mass
            return VelocityMoments(moments, mean, centre, sqrt(square / mass), guiding / mass)
        }
    }
}
