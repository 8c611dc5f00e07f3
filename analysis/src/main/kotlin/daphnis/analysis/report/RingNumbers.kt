package daphnis.analysis.report

import daphnis.analysis.statistics.BlockAverage
import daphnis.analysis.transport.Transport
import kotlin.math.PI

/** The quantities of a patch in Hill's frame of angular speed [omega], in units of r and Ω. */
internal class RingNumbers(private val study: Study, private val omega: Double) {
    private val units = study.units
    private val bulk = study.bulk
    private val motion = study.motion
    private val r = bulk.meanRadius
    private val scenario = study.input.scenario
    private val rows =
        NumberRows(scenario?.let { References.ofPatch(it, omega, bulk.opticalDepth) } ?: emptyMap())

    fun rows(): List<NumberRow> {
        patch()
        motion()
        motion.transport?.let { collisions(it) }
        bulk.selfGravity?.let { gravity(it) }
        return rows.list()
    }

    private fun patch() {
        rows.exact("optical depth τ", bulk.opticalDepth, "", "Σ π r² over the area")
        rows.exact("surface density Σ", bulk.surfaceDensity, units.surfaceDensity)
        rows.exact("mean radius r", r, units.length)
        rows.exact("r Ω", r * omega, units.speed)
    }

    private fun motion() {
        val speed = r * omega
        rows.average("velocity dispersion c", motion.dispersion per speed, "r Ω")
        for (axis in listOf("x", "y", "z")) {
            rows.average("σ_$axis", motion.moment("$axis$axis").root() per speed, "r Ω")
        }
        rows.average(
            "orientation of the velocity ellipsoid",
            motion.orientation per Math.toRadians(1.0),
            "degrees",
            "from the radial direction toward the orbit",
        )
        rows.average("scale height H", motion.scaleHeight per r, "r")
        rows.average("filling factor in the middle plane", motion.middlePlane per 1.0, "")
    }

    private fun collisions(transport: Transport) {
        rows.average("collisions of a particle", transport.collisionRate per (omega / (2 * PI)), "1/orbit")
        val centimetre = 1 / (scenario?.units?.speedInCmPerSecond ?: 1.0)
        rows.average("mean impact speed", transport.impactSpeed per centimetre, "cm/s")
        val unit = r * r * omega
        rows.average("viscosity, translational", transport.translational per unit, "r² Ω")
        rows.average("viscosity, collisional", transport.collisional per unit, "r² Ω")
        if (transport.gravitational.mean != 0.0) {
            rows.average("viscosity, gravitational", transport.gravitational per unit, "r² Ω")
        }
        rows.average("viscosity, total", transport.viscosity per unit, "r² Ω")
        rows.average("viscosity, total, in the run's units", transport.viscosity per 1.0, units.viscosity)
        rows.average("(9/4) Ω² ν over dissipation", transport.energyBalance per 1.0, "", "1 in a steady state")
    }

    private fun gravity(constant: Double) {
        val marginal = 3.36 * constant * bulk.surfaceDensity / omega
        rows.average("Toomre's Q", motion.moment("xx").root() per marginal, "", "σ_x Ω / (3.36 G Σ)")
        rows.exact("critical wavelength 4π² G Σ/Ω²", bulk.criticalWavelength, units.length)
    }

    private infix fun BlockAverage.per(unit: Double) = this * (1 / unit)
}
