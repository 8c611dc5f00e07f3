package daphnis.core.physics

import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.math.sqrt

/**
 * What molecular chaos says of the spins of a dilute ring of equal rough spheres, whose velocities are Gaussian with the
 * moments ⟨c_a c_b⟩ [c] (xx, yy, zz, xy) and much larger than r Ω. For an isotropic gas it is Morishima & Salo's ratio
 * of energies, and half of the vorticity.
 *
 * - Spins gain from the tangential speed of an impact what their own lose, so E_rot is in proportion to ⟨g²⟩ over
 *   impacts. At a given relative velocity **u** all places of impact are alike: ⟨g²⟩ is half of ⟨u³⟩/⟨u⟩.
 * - The mean spin is that for which impacts have no torque on average, to first order in the shear over the distance
 *   of the centres.
 */
internal class Ellipsoid(private val c: List<Double>) {
    /** ⟨u³⟩/⟨u⟩ over what it is for the same ⟨u²⟩ without a preferred direction. */
    val excess: Double
        get() {
            // u = L g with L Lᵀ = c and g without a preferred direction.
            val a = sqrt(c[0])
            val b = c[3] / a
            val d = sqrt(c[1] - b * b)
            val means = mean(3) { n, sums ->
                val x = a * n[0]
                val y = b * n[0] + d * n[1]
                val u = sqrt(x * x + y * y + c[2] * n[2] * n[2])
                sums[0] += u
                sums[1] += u * u
                sums[2] += u * u * u
            }
            return means[2] / (means[0] * means[1])
        }

    /** ⟨ω_z⟩/Ω in Hill's frame. */
    val spin: Double
        get() {
            val means = mean(2) { n, sums ->
                val along = c[0] * n[0] * n[0] + c[1] * n[1] * n[1] + c[2] * n[2] * n[2] + 2 * c[3] * n[0] * n[1]
                val s = sqrt(2 * along)
                // Covariance of the speed of approach along n and of (n × u)_z.
                val k = -2 * (c[3] * (n[0] * n[0] - n[1] * n[1]) + (c[1] - c[0]) * n[0] * n[1])
                sums[0] += 1.5 * (n[0] * n[1] * k / s - n[0] * n[0] * s)
                sums[1] += s * (1 - n[2] * n[2])
            }
            return means[0] / means[1]
        }

    /** Means over all directions of what [add] adds. */
    private fun mean(size: Int, add: (DoubleArray, DoubleArray) -> Unit): DoubleArray {
        val sums = DoubleArray(size)
        val n = DoubleArray(3)
        for (k in 0 until DIRECTIONS) {
            n[2] = (2 * k + 1.0) / DIRECTIONS - 1
            val inPlane = sqrt(1 - n[2] * n[2])
            n[0] = inPlane * cos(k * GOLDEN)
            n[1] = inPlane * sin(k * GOLDEN)
            add(n, sums)
        }
        return DoubleArray(size) { sums[it] / DIRECTIONS }
    }

    private companion object {
        const val DIRECTIONS = 100_000
        val GOLDEN = PI * (3 - sqrt(5.0))
    }
}
