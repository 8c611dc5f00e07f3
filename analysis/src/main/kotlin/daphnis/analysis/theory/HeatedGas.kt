package daphnis.analysis.theory

import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.pow
import kotlin.math.sqrt

/**
 * The steady state of equal smooth spheres which white noise heats everywhere alike and collisions cool (van Noije &
 * Ernst 1998, Granular Matter 1, 57), with Enskog's collision rate. For gases without clusters: filling factors below
 * 0.4 or so and coefficients of restitution from 0.6.
 */
public object HeatedGas {
    /**
     * ⟨c²⟩/3, (length/time)², at which ξ² = 2γT + (1 − ε²) (4/3) √π n σ² χ T^{3/2} (1 + 3a₂/16): what noise and drag
     * give and take, and what collisions take. Infinite for elastic spheres without drag.
     *
     * @param intensity ξ² of each component of the acceleration, (length/time)² per unit of time
     * @param drag γ, per unit of time
     * @param restitution ε, of all impacts
     * @param density n, spheres in a unit of volume
     * @param diameter σ
     */
    @JvmStatic
    public fun temperature(
        intensity: Double,
        drag: Double,
        restitution: Double,
        density: Double,
        diameter: Double,
    ): Double {
        val contact = HardSpheres.carnahanStarlingContact(HardSpheres.filling(density, diameter))
        val loss = (1 - restitution * restitution) * (4.0 / 3) * sqrt(PI) * density * diameter * diameter * contact *
            (1 + 3.0 / 16 * fourthCumulant(restitution))
        if (intensity == 0.0) return 0.0
        if (loss == 0.0 && drag == 0.0) return Double.POSITIVE_INFINITY
        // Newton's steps from above, where the speed s of loss s³ + 2 drag s² = intensity is bounded by each term.
        var s = minOf((intensity / loss).pow(1.0 / 3), sqrt(intensity / (2 * drag)))
        repeat(MOST_STEPS) {
            val next = s - (loss * s * s * s + 2 * drag * s * s - intensity) / (3 * loss * s * s + 4 * drag * s)
            if (abs(next - s) <= ROUNDING * s) return next * next
            s = next
        }
        return s * s
    }

    /** a₂ of the velocities at restitution [restitution], to first order, without drag. */
    @JvmStatic
    public fun fourthCumulant(restitution: Double): Double {
        val e2 = restitution * restitution
        return 16 * (1 - restitution) * (1 - 2 * e2) / (241 - 177 * restitution + 30 * e2 * (1 - restitution))
    }

    private const val MOST_STEPS = 100
    private const val ROUNDING = 1e-14
}
