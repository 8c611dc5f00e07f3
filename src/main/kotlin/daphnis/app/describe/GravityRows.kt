package daphnis.app.describe

import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.granularTemperature
import daphnis.core.scenario.ScenarioSetup
import kotlin.math.sqrt

/**
 * Forces with their numbers, and the scales that gravity sets: Hill radii, Toomre's wavelength and Q.
 */
internal class GravityRows(private val setup: ScenarioSetup, private val say: Quantities, private val rows: Rows) {
    private val scenario = setup.scenario
    private val population = setup.population
    private val orbits = setup.frequencies

    fun write() {
        setup.forcesInWords(say).forEachIndexed { k, text -> rows.add("forces", "[$k] $text") }
        val constant = scenario.gravitationalConstant
        if (constant != null && orbits != null) scales(constant, orbits)
    }

    private fun scales(g: Double, orbits: OrbitalFrequencies) {
        val kappa = orbits.kappa
        val particles = population.radius.indices.filter { !scenario.isBody(population.id[it]) }
        if (particles.isEmpty()) return
        val off = if (scenario.forces.none { it.isAmongAll }) " (no self-gravity in this run)" else ""
        val mass = particles.sumOf { population.mass[it] } / particles.size
        val radius = Math.cbrt(particles.sumOf { Math.pow(population.radius[it], 3.0) } / particles.size)
        // Two spheres of the mean mass: their mutual Hill radius over the distance of their centres when they touch.
        val ratio = orbits.hillRadius(2 * g * mass) / (2 * radius)
        rows.add(
            "Hill radius",
            "${say.length(orbits.hillRadius(g * mass))} of a sphere of mean mass; " +
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

    private companion object {
        /** Toomre 1964 (ApJ 139, 1217), for stars: Q = c κ / (3.36 G Σ). */
        const val TOOMRE = 3.36
    }
}
