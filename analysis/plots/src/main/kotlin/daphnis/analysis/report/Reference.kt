package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.analysis.theory.DiluteShear
import daphnis.analysis.theory.HeatedGas
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.scenario.Scenario
import daphnis.core.surface.BridgesSpec
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.math.sqrt

/** A number from elsewhere, to stand beside a measured one; it may be off by as much as its [bound]. */
internal class Reference(val value: Double, val bound: Double, val source: String) {
    /** Whether [measured] with the standard error [error] agrees with it, as far as the bound and three errors tell. */
    fun agrees(measured: Double, error: Double): Boolean = abs(measured - value) <= hypot(bound, 3 * error)
}

/**
 * Numbers that are known for some scenarios: steady ring patches and sheared gases measured with an independent
 * event-driven code (docs/validation.md), and gases that noise heats. [ElasticReferences] has elastic ones. By
 * [NumberRow.key]. There are none unless everything that decides the number is as it was there: sizes and masses,
 * restitution with its scale, forces, frame and faces.
 *
 * The independent code gave no errors; the bounds of docs/validation.md hold for all of its numbers.
 */
internal object References {
    private const val INDEPENDENT = "docs/validation.md"

    /**
     * τ, then c, σx, σy, σz in rΩ, H in r, collisions a particle and orbit, ν_trans and ν_coll in r²Ω, midplane filling
     * factor.
     */
    private val PATCHES = listOf(
        doubleArrayOf(0.1, 4.55, 3.53, 1.77, 2.25, 2.32, 1.75, 0.270, 0.065, 0.023),
        doubleArrayOf(0.5, 3.72, 2.79, 1.56, 1.89, 2.21, 8.99, 0.752, 0.402, 0.114),
        doubleArrayOf(1.0, 2.95, 2.10, 1.38, 1.54, 2.16, 18.95, 0.670, 0.859, 0.22),
        doubleArrayOf(2.0, 2.45, 1.62, 1.28, 1.31, 2.49, 44.3, 0.487, 1.859, 0.35),
    )

    /** Bounds of docs/validation.md for the columns above, relative. */
    private val PATCH_BOUNDS = doubleArrayOf(0.0, 0.03, 0.03, 0.03, 0.03, 0.03, 0.03, 0.06, 0.06, 0.05)
    private val PATCH_KEYS = listOf(
        "",
        "velocity_dispersion",
        "sigma_x",
        "sigma_y",
        "sigma_z",
        "scale_height",
        "collisions_per_particle",
        "viscosity_translational",
        "viscosity_collisional",
        "midplane_filling_factor",
    )

    /** e, φ, then T*, p*, τ*. */
    private val SHEARED = listOf(
        doubleArrayOf(0.8, 0.01, 297.0, 3.08, 1.335),
        doubleArrayOf(0.8, 0.1, 3.00, 0.440, 0.170),
        doubleArrayOf(0.8, 0.3, 0.514, 0.596, 0.230),
        doubleArrayOf(0.9, 0.01, 631.0, 6.55, 2.130),
        doubleArrayOf(0.9, 0.1, 6.36, 0.951, 0.275),
        doubleArrayOf(0.9, 0.3, 1.137, 1.339, 0.374),
        doubleArrayOf(0.95, 0.01, 1302.0, 13.54, 3.208),
        doubleArrayOf(0.95, 0.1, 13.06, 1.970, 0.411),
        doubleArrayOf(0.95, 0.3, 2.390, 2.837, 0.565),
    )

    /** Of a ring patch, in units of r and Ω; [last] is its last state. */
    fun ofPatch(
        scenario: Scenario,
        last: State,
        orbits: OrbitalFrequencies,
        opticalDepth: Double,
    ): Map<String, Reference> {
        if (!isPlain(scenario, last)) return emptyMap()
        val speed = last.population.radius[0] * orbits.omega * scenario.units.speedInCmPerSecond
        val same =
            scenario.restitution == BridgesSpec(0.34, -0.234) &&
                scenario.boundary.isSheet &&
                scenario.boundary.narrowing == 0.0 &&
                orbits.radialFactor == 1.0 &&
                orbits.verticalFactor == 1.0 &&
                abs(speed / 0.01948 - 1) < SAME_SCALE
        if (!same) return emptyMap()
        val row = PATCHES.find { abs(opticalDepth / it[0] - 1) < 0.01 } ?: return emptyMap()
        return (1 until row.size).associate {
            PATCH_KEYS[it] to Reference(row[it], PATCH_BOUNDS[it] * row[it], INDEPENDENT)
        }
    }

    /** Of a Lees–Edwards box, in the units of its table. */
    fun ofShear(scenario: Scenario, last: State, filling: Double): Map<String, Reference> {
        val restitution = scenario.restitution.constant ?: return emptyMap()
        val isSheared = scenario.boundary.shearRate != null
        if (!isSheared || !isPlain(scenario, last)) return emptyMap()
        if (last.dimensions != 3) return emptyMap()
        val row = SHEARED.find { it[0] == restitution && abs(filling / it[1] - 1) < 0.01 } ?: return emptyMap()
        return mapOf(
            "reduced_temperature" to Reference(row[2], 0.03 * row[2], INDEPENDENT),
            "reduced_pressure" to Reference(row[3], 0.04 * row[3], INDEPENDENT),
            "reduced_shear_stress" to Reference(row[4], 0.04 * row[4], INDEPENDENT),
        )
    }

    /** Of a dilute gas in a Lees–Edwards box: its stresses over the pressure. */
    fun ofDiluteShear(scenario: Scenario, last: State, filling: Double): Map<String, Reference> {
        val restitution = scenario.restitution.constant ?: return emptyMap()
        val isSheared = scenario.boundary.shearRate != null
        if (!isSheared || !isPlain(scenario, last) || restitution < LEAST_SHEARED || filling > MOST_DILUTE) {
            return emptyMap()
        }
        val shear = DiluteShear(restitution, last.dimensions)
        fun grad(value: Double) = Reference(value, DILUTE_BOUND, "Grad, Santos, Garzó & Dufty 2004")
        return mapOf(
            "normal_stress_xx" to grad(shear.alongFlow),
            "normal_stress_yy" to grad(shear.acrossFlow),
            "normal_stress_zz" to grad(shear.acrossFlow),
            "shear_stress_ratio" to grad(shear.shearStress),
        )
    }

    /** Temperature and a₂ of a gas that white noise heats, van Noije & Ernst 1998. */
    fun ofHeated(scenario: Scenario, last: State, numberDensity: Double): Map<String, Reference> {
        val restitution = scenario.restitution.constant ?: return emptyMap()
        val noise = scenario.forces.singleOrNull()?.noise ?: return emptyMap()
        val isPeriodic = scenario.boundary.repeatsAtRest && (0..2).all { last.boundary.repeats(it) }
        if (!isPeriodic || scenario.frame != null || restitution < LEAST_HEATED) return emptyMap()
        if (!isPlain(scenario, last, forces = 1)) return emptyMap()
        val intensity = noise.intensity(last.population.mass[0])
        val diameter = 2 * last.population.radius[0]
        val t = HeatedGas.temperature(intensity, noise.drag, restitution, numberDensity, diameter)
        if (!(t > 0 && t.isFinite())) return emptyMap()
        val temperature = mapOf("granular_temperature" to Reference(t, HEATED_BOUND * t, NOIJE))
        if (noise.drag > 0) return temperature
        val a2 = HeatedGas.fourthCumulant(restitution)
        return temperature + ("velocity_a2" to Reference(a2, CUMULANT_BOUND, NOIJE))
    }

    /**
     * Whether equal spheres meet each other and nothing else: so many [forces], no body, no guard that is felt.
     */
    fun isPlain(scenario: Scenario, last: State, forces: Int = 0): Boolean = scenario.forces.size == forces &&
        scenario.contacts.isEmpty() &&
        ElasticGas.isSmooth(scenario) &&
        scenario.bodies.isEmpty() &&
        ElasticGas.areEqual(last.population.radius) &&
        ElasticGas.areEqual(last.population.mass) &&
        // A run has resolved what is relative to a speed.
        (scenario.guard == null || rms(last).let { scenario.guard!!.floor(it) <= FELT * it })

    /** Root mean square of a component of the velocities. */
    private fun rms(state: State): Double {
        val p = state.population
        val sum = (0 until p.size).sumOf { p.vx[it] * p.vx[it] + p.vy[it] * p.vy[it] + p.vz[it] * p.vz[it] }
        return sqrt(sum / (state.dimensions * p.size))
    }

    /** r Ω by which the restitution law is scaled: c changes by a tenth of this. */
    private const val SAME_SCALE = 0.005

    /** Floor speed of a guard, in rms speeds, that nothing measured depends on. */
    private const val FELT = 1e-4

    /**
     * Filling factor up to which a gas counts as dilute, least restitution, and what Grad's approximation and collisions
     * at this density make of P_ab/p: P_yy is smaller than P_zz by terms of second order.
     */
    private const val MOST_DILUTE = 0.011
    private const val LEAST_SHEARED = 0.8
    private const val DILUTE_BOUND = 0.03
    private const val NOIJE = "van Noije & Ernst 1998"
    private const val LEAST_HEATED = 0.6

    /**
     * What Enskog's rate leaves out in an inelastic gas, relative (1.6 % at filling factor 0.1 and ε = 0.8), and what
     * is left out of a₂, at the same filling factor 0.0037: velocities of spheres that are near each other are
     * correlated.
     */
    private const val HEATED_BOUND = 0.05
    private const val CUMULANT_BOUND = 0.005
}
