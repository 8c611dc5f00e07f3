package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.transport.PerturbedTransport
import daphnis.analysis.transport.Transport
import daphnis.core.orbit.OrbitalFrequencies
import kotlin.math.PI

/** The quantities of a patch in Hill's frame with these [orbits], in units of r and Ω. */
internal class RingNumbers(private val study: Study, private val orbits: OrbitalFrequencies) {
    private val omega = orbits.omega
    private val isKeplerian = orbits.radialFactor == 1.0
    private val units = study.units
    private val bulk = study.bulk
    private val motion = study.motion
    private val r = bulk.meanRadius
    private val scenario = study.input.scenario
    private val speedUnit = SpeedUnit(scenario, units.speed)
    private val rows =
        NumberRows(study.physics?.let { References.ofPatch(it, study.last, orbits, bulk.opticalDepth) } ?: emptyMap())

    fun rows(): List<NumberRow> {
        patch()
        if (study.input.hasVelocities) motion()
        SpinNumbers(study, rows, omega).add()
        heights()
        motion.transport?.let { collisions(it) }
        bulk.selfGravity?.let { gravity(it) }
        return rows.list()
    }

    private fun patch() {
        rows.exact("optical_depth", "optical depth τ", bulk.opticalDepth, "", "Σ π r² over the area")
        rows.exact("surface_density", "surface density Σ", bulk.surfaceDensity, units.surfaceDensity)
        if (PerturbedSheet.isSeen(study.last)) {
            val q = PerturbedSheet.q(study.last)
            rows.exact("perturbation", "perturbation q", q, "", "τ and Σ are for the mean width")
            rows.exact(
                "surface_density_ratio",
                "largest over least surface density",
                (1 + q) / (1 - q),
                "",
                "(1 + q)/(1 − q)",
            )
        }
        rows.exact("mean_radius", "mean radius r", r, units.length)
        rows.exact("r_omega", "r Ω", r * omega * speedUnit.factor, speedUnit.name)
    }

    private fun motion() {
        val speed = r * omega
        rows.average(
            "velocity_dispersion",
            "velocity dispersion c",
            motion.dispersion per speed,
            "r Ω",
            "around the mean flow by radius, in slabs${bulk.byMass}" + if (isShared()) SHARED else "",
        )
        rows.average(
            "velocity_dispersion_thermal",
            "velocity dispersion, thermal",
            motion.thermalDispersion per speed,
            "r Ω",
            "of near neighbours, without waves",
        )
        rows.average(
            "velocity_dispersion_total",
            "velocity dispersion, total",
            motion.totalDispersion per speed,
            "r Ω",
            "around the ${if (PerturbedSheet.isSeen(
                    study.last,
                )
            ) {
                "flow of streamlines"
            } else {
                "orbital shear"
            }}, with waves" +
                bulk.byMass,
        )
        for (axis in listOf("x", "y", "z")) {
            rows.average("sigma_$axis", "σ_$axis", motion.moment("$axis$axis").root() per speed, "r Ω")
        }
        val isTurned = AxesInPlane.isSeen(motion, bulk.particles)
        val none = BlockAverage(Double.NaN, Double.NaN, 0)
        rows.average(
            "ellipsoid_orientation",
            "orientation of the velocity ellipsoid",
            if (isTurned) motion.orientation per Math.toRadians(1.0) else none,
            "degrees",
            if (isTurned) "from the radial direction toward the orbit" else "none: its axes differ as by chance",
        )
    }

    /** Whether most of the motion around the mean flow by radius is that of whole neighbourhoods. */
    private fun isShared() = motion.thermalDispersion.mean < motion.dispersion.mean * THERMAL_PART

    private fun heights() {
        rows.average("scale_height", "scale height H", motion.scaleHeight per r, "r", bulk.byMass.removePrefix(", "))
        rows.average("midplane_filling_factor", "filling factor in the middle plane", motion.middlePlane per 1.0, "")
    }

    private fun collisions(transport: Transport) {
        rows.average(
            "collisions_per_particle",
            "collisions per particle",
            transport.collisionRate per (omega / (2 * PI)),
            "1/orbit",
        )
        val impactSpeed = transport.impactSpeed * speedUnit.factor
        rows.average("mean_impact_speed", "mean impact speed", impactSpeed, speedUnit.name)
        if (PerturbedSheet.isSeen(study.last)) {
            motion.perturbed?.let { perturbed(it) }
            return
        }
        val unit = r * r * omega
        rows.average("viscosity_translational", "viscosity, translational", transport.translational per unit, "r² Ω")
        rows.average("viscosity_collisional", "viscosity, collisional", transport.collisional per unit, "r² Ω")
        if (transport.gravitational.mean != 0.0) {
            rows.average(
                "viscosity_gravitational",
                "viscosity, gravitational",
                transport.gravitational per unit,
                "r² Ω",
            )
        }
        rows.average("viscosity_total", "viscosity, total", transport.viscosity per unit, "r² Ω")
        rows.average(
            "viscosity_total_in_run_units",
            "viscosity, total, in the run's units",
            transport.viscosity per 1.0,
            units.viscosity,
        )
        rows.average(
            "shear_work_over_dissipation",
            if (isKeplerian) "(9/4) Ω² ν over dissipation" else "s² ν over dissipation, s = (2 − ½ κ²/Ω²) Ω",
            transport.energyBalance per 1.0,
            "",
            "1 in a steady state",
        )
    }

    private fun perturbed(transport: PerturbedTransport) {
        val unit = r * r * omega * omega
        rows.average(
            "angular_momentum_flux",
            "flux of angular momentum",
            transport.angularMomentumFlux per unit,
            "Σ r² Ω²",
            "P_xy over the height, mean over periods; s ν without perturbation, negative inward",
        )
        rows.average(
            "angular_momentum_flux_translational",
            "flux of angular momentum, translational",
            transport.translationalFlux per unit,
            "Σ r² Ω²",
        )
        rows.average(
            "shear_work_over_dissipation",
            "work of the images over dissipation",
            transport.energyBalance per 1.0,
            "",
            "1 in a steady state",
        )
    }

    private fun gravity(constant: Double) {
        val marginal = 3.36 * constant * bulk.surfaceDensity / orbits.kappa
        if (study.input.hasVelocities) {
            rows.average(
                "toomre_q",
                "Toomre's Q",
                motion.moment("xx").root() per marginal,
                "",
                if (isKeplerian) "σ_x Ω / (3.36 G Σ)" else "σ_x κ / (3.36 G Σ)",
            )
        }
        rows.exact(
            "critical_wavelength",
            if (isKeplerian) "critical wavelength 4π² G Σ/Ω²" else "critical wavelength 4π² G Σ/κ²",
            bulk.criticalWavelength,
            units.length,
        )
        rows.exact("hill_ratio", "r_h, mutual Hill radius over the distance in contact", bulk.hillRatio, "")
        val wakes = bulk.viscosityOfWakes / (r * r * omega)
        // To be held against the total, which is not known without these rows.
        if (motion.transport != null) {
            rows.exact("viscosity_of_wakes", "viscosity of wakes by Daisaka et al.", wakes, "r² Ω", WAKES)
        }
    }

    private infix fun BlockAverage.per(unit: Double) = this * (1 / unit)

    private companion object {
        /** Part of the dispersion below which the thermal one is the lesser part of its square. */
        const val THERMAL_PART = 0.7
        const val SHARED = "; most of it is motion that neighbours share, as in waves"
        const val WAKES = "26 r_h⁵ G² Σ²/Ω³, for r_h from 0.7 on where there are wakes"
    }
}
