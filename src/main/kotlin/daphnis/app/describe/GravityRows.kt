package daphnis.app.describe

import daphnis.core.force.MeshGravity
import daphnis.core.force.MutualGravity
import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.granularTemperature
import daphnis.core.scenario.ForceSpec
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.FrameSpec
import daphnis.core.scenario.GravityMethod
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.ThermostatSpec
import daphnis.core.scenario.gravitationalParameter
import kotlin.math.sqrt

/**
 * Forces with their numbers, and the scales that gravity sets: Hill radii, Toomre's wavelength and Q, the wakes of
 * satellites.
 */
internal class GravityRows(private val setup: ScenarioSetup, private val say: Quantities, private val rows: Rows) {
    private val scenario = setup.scenario
    private val population = setup.population
    private val orbits = setup.frequencies
    private val omega = orbits?.omega
    private val constant: Double? =
        scenario.forces.firstNotNullOfOrNull { given(it) } ?: scenario.units.gravitationalConstant

    fun write() {
        scenario.forces.forEachIndexed { k, force -> force(k, force) }
        if (constant != null && orbits != null) scales(constant, orbits)
    }

    private fun given(force: ForceSpec): Double? = when (force) {
        is ForceSpec.SelfGravity -> force.constant
        is ForceSpec.BodyGravity -> force.constant
        is ForceSpec.Satellite -> force.constant
        is ForceSpec.UniformAcceleration, is ThermostatSpec -> null
    }

    private fun force(k: Int, force: ForceSpec) {
        val text = when (force) {
            is ForceSpec.UniformAcceleration ->
                "uniform-acceleration, ${force.acceleration.joinToString { say.acceleration(it) }}"
            is ForceSpec.SelfGravity -> selfGravity(force)
            is ForceSpec.BodyGravity -> "body-gravity, softening ${say.length(force.softening)}"
            is ForceSpec.Satellite -> satellite(force)
            is ThermostatSpec -> force.inWords(say)
        }
        rows.add("forces", "[$k] $text")
    }

    private fun selfGravity(force: ForceSpec.SelfGravity) = when (force.method) {
        GravityMethod.TREE ->
            "self-gravity, opening angle ${number(force.openingAngle)}, " +
                "softening ${say.length(force.softening)}, reaches ${say.length(reach(force))}"
        GravityMethod.MESH ->
            "self-gravity by a mesh, points ${say.length(spacing(force))} apart, " +
                "softening ${say.length(force.softening)}, with all images"
        GravityMethod.RADIAL_MODES -> {
            val shortest = setup.boundary.box.length(0) / force.modes!!
            "self-gravity along x alone, ${force.modes} waves down to ${say.length(shortest)}"
        }
    }

    private fun spacing(force: ForceSpec.SelfGravity): Double {
        val gravity = MeshGravity(setup.boundary, 0.0, force.softening, force.spacing ?: 0.0)
        return gravity.spacingFor(population)
    }

    private fun satellite(moon: ForceSpec.Satellite): String {
        val planet = scenario.frame as FrameSpec.Hill
        val g = moon.constant ?: scenario.units.gravitationalConstant
        val mass =
            moon.mass
                ?: planet.gravitationalParameter(scenario.units)?.let { gm -> g?.let { moon.massRatio!! * gm / it } }
        val size = if (moon.radius > 0) "radius ${say.length(moon.radius)}" else "a point"
        return listOfNotNull(
            "satellite of ${mass?.let { say.mass(it) } ?: "mass ratio ${number(moon.massRatio!!)}"}",
            size,
            "${say.length(Math.abs(moon.x))} ${if (moon.x < 0) "inside" else "outside"} the middle of the box",
            "e a = ${say.length(moon.e)}",
            "wakes ${say.length(2 * Math.PI * orbits!!.shearFactor / orbits.radialFactor * Math.abs(moon.x))} long",
            if (moon.inclination > 0) "i a = ${say.length(moon.inclination)}" else null,
            returns(moon, orbits),
            mass?.let { m -> g?.let { "Hill radius ${say.length(hillRadius(it * m, omega!!))}" } },
        ).joinToString(", ")
    }

    /** After how long a moon passes again, and how many of its wakes go round the planet until then. */
    private fun returns(moon: ForceSpec.Satellite, orbits: OrbitalFrequencies): String? {
        if (!moon.returns) return null
        val period = FrameSetup.orbitsBetweenPassages(scenario, orbits, moon) ?: return null
        return "returns every ${number(period)} orbits, ${number(period * orbits.radialFactor)} epicycles"
    }

    private fun scales(g: Double, orbits: OrbitalFrequencies) {
        val omega = orbits.omega
        val kappa = orbits.kappa
        val particles = population.radius.indices.filter { !scenario.isBody(population.id[it]) }
        if (particles.isEmpty()) return
        val off = if (scenario.forces.none { it is ForceSpec.SelfGravity }) " (no self-gravity in this run)" else ""
        val mass = particles.sumOf { population.mass[it] } / particles.size
        val radius = Math.cbrt(particles.sumOf { Math.pow(population.radius[it], 3.0) } / particles.size)
        // Two spheres of the mean mass: their mutual Hill radius over the distance of their centres when they touch.
        val ratio = hillRadius(2 * g * mass, omega) / (2 * radius)
        rows.add(
            "Hill radius",
            "${say.length(hillRadius(g * mass, omega))} of a sphere of mean mass; " +
                "of two, r_p = r_h / (r_1 + r_2) = ${number(ratio)}$off",
        )
        val area = setup.boundary.box.length(0) * setup.boundary.box.length(1)
        val surface = particles.sumOf { population.mass[it] } / area
        val dispersion = sqrt(granularTemperature(population, setup.boundary.meanFlow, scenario.firstBody))
        val wavelength = 4 * Math.PI * Math.PI * g * surface / (kappa * kappa)
        val q = dispersion * kappa / (TOOMRE * g * surface)
        // Of spheres so light that numbers end.
        if (wavelength == 0.0 || q.isInfinite()) return
        val fits = (0..1).joinToString(" × ") { number(setup.boundary.box.length(it) / wavelength) }
        rows.add(
            "Toomre",
            "critical wavelength ${say.length(wavelength)}, the box $fits of it, Q = ${number(q)} at the start$off",
        )
    }

    /** How far self-gravity reaches around each particle; infinite in a box that repeats nowhere. */
    private fun reach(force: ForceSpec.SelfGravity) = setup.forces.filterIsInstance<MutualGravity>()
        .getOrNull(scenario.forces.filterIsInstance<ForceSpec.SelfGravity>().indexOf(force))?.range ?: Double.NaN

    /** (G m / 3 Ω²)^⅓, in Hill's frame of a planet much heavier than [strength] = G m. */
    private fun hillRadius(strength: Double, omega: Double) = Math.cbrt(strength / (3 * omega * omega))

    private companion object {
        /** Toomre 1964 (ApJ 139, 1217), for stars: Q = c κ / (3.36 G Σ). */
        const val TOOMRE = 3.36
    }
}
