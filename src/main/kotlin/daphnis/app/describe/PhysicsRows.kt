package daphnis.app.describe

import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.at
import daphnis.core.boundary.isChanging
import daphnis.core.initial.fillingFactor
import daphnis.core.input.Quantities
import daphnis.core.input.Quantities.Companion.number
import daphnis.core.orbit.OrbitalFrequencies
import daphnis.core.population.granularTemperature
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.surface.MaterialLaws
import daphnis.core.surface.SurfaceContact
import java.util.Locale
import kotlin.math.sqrt

/**
 * The system that a scenario describes, with units: what is in it, how large, how fast, and by which laws it collides.
 */
internal class PhysicsRows(private val setup: ScenarioSetup, private val say: Quantities, private val rows: Rows) {
    private val scenario = setup.scenario
    private val population = setup.population
    private val box = setup.boundary.box

    /** Rows of the population besides bodies. */
    private val particles = population.radius.indices.filter { !scenario.isBody(population.id[it]) }

    private val materials = MaterialRows(setup, say, rows)

    fun write() {
        if (particles.isNotEmpty()) describeSpheres()
        materials.materials()
        bodies()
        surroundings()
        if (particles.isNotEmpty()) fullness()
        growth()
        motion()
        collisions()
        criticalLength(setup, say)?.let { rows.add("critical length", it) }
        rows.add("seed", "${scenario.seed}")
    }

    private fun describeSpheres() {
        val radii = particles.map { population.radius[it] }
        val masses = particles.map { population.mass[it] }
        val same = radii.min() == radii.max()
        val size = if (same) {
            say.length(radii[0])
        } else {
            "${say.length(radii.min())} to ${say.length(radii.max())}, mean ${say.length(radii.average())}"
        }
        val then = if (scenario.sources.isEmpty()) "" else " at the start"
        rows.add("particles", "${spheres(particles.size, box.space)}$then, radius $size")
        val mass = if (masses.min() == masses.max()) {
            say.mass(masses[0])
        } else {
            "${say.mass(masses.min())} to ${say.mass(masses.max())}"
        }
        rows.add("mass", "$mass each, ${say.mass(masses.sum())} together")
        val density = masses.sum() / radii.sumOf { box.space.volume(it) }
        rows.add("density", if (box.space.isPlane) say.surfaceDensity(density) else say.density(density))
    }

    private fun bodies() {
        for (k in population.radius.indices) {
            if (!scenario.isBody(population.id[k])) continue
            val at = listOf(population.x[k], population.y[k], population.z[k]).joinToString { say.length(it) }
            rows.add(
                "bodies",
                "radius ${say.length(population.radius[k])}, mass ${say.mass(population.mass[k])}, " +
                    (population.materials.getOrNull(materialOf(k))?.let { "of $it, " } ?: "") + "at $at",
            )
        }
    }

    private fun materialOf(k: Int) = if (population.hasMaterials) population.material[k].toInt() else -1

    private fun surroundings() {
        val edges = scenario.box.lengths.joinToString(" x ") { say.length(it) }
        rows.add("box", "$edges, ${scenario.boundary.inWords(::number, say::speed)}")
        say.unitOfTime()?.let { rows.add("unit of time", it) }
        val orbits = setup.frequencies ?: return
        val where = scenario.frame?.inWords?.let { ", $it" }.orEmpty()
        val orbit = 2 * Math.PI / orbits.omega
        rows.add(
            "orbit",
            "${say.time(orbit)}$where; the run is ${number((scenario.end - scenario.startTime) / orbit)} orbits",
        )
        if (orbits.radialFactor != 1.0 || orbits.verticalFactor != 1.0) {
            rows.add(
                "epicycles",
                "radial frequency ${number(orbits.radialFactor)} Ω, vertical ${number(orbits.verticalFactor)} Ω" +
                    precession(orbits),
            )
        }
    }

    /** Of apses and nodes, in degrees a day where the unit of time is known. */
    private fun precession(orbits: OrbitalFrequencies): String {
        val second = scenario.units.timeInSeconds ?: return ""
        fun rate(perTime: Double) = "${number(Math.toDegrees(perTime / second * SECONDS_A_DAY))} degrees a day"
        return "; apses turn by ${rate(orbits.omega - orbits.kappa)}, nodes by ${rate(orbits.omega - orbits.nu)}"
    }

    private fun growth() {
        val spec = scenario.growth ?: return
        val ends = spec.goals() + "time ${number(scenario.end)}"
        val since = spec.since?.let { "time ${number(it)}" } ?: "the start"
        val energy = if (spec.thermostat) "kept by a thermostat" else "grows with the work of the surfaces"
        rows.add(
            "growth",
            "radii by ${number(spec.rate)} of those at $since per unit of time, to ${ends.joinToString(" or ")}",
        )
        rows.add("kinetic energy", energy)
    }

    private fun fullness() {
        val radii = DoubleArray(particles.size) { population.radius[particles[it]] }
        val open =
            setup.boundary.walls.surfaces.isEmpty() &&
                (0 until box.space.dimensions).any { setup.boundary.contactFaces(it) == ContactFaces.OPEN }
        val name = if (box.space.isPlane) "area fraction" else "filling factor"
        val ofBox = when {
            setup.boundary.isChanging -> " of the box as it is on average"
            open -> " of the box at the start"
            else -> ""
        }
        rows.add(name, number(fillingFactor(radii, setup.boundary)) + ofBox)
        setup.angularSpeed ?: return
        val area = box.length(0) * box.length(1)
        rows.add("optical depth", number(radii.sumOf { Math.PI * it * it } / area))
        rows.add("surface density", say.surfaceDensity(particles.sumOf { population.mass[it] } / area))
    }

    private fun motion() {
        rows.add(
            "velocities",
            "${say.speed(dispersion())} in one direction at the start (root mean square, without the mean flow)",
        )
    }

    /** Of one component: the root of the granular temperature. */
    private fun dispersion() =
        sqrt(granularTemperature(population, setup.boundary.at(scenario.startTime), scenario.firstBody))

    private fun collisions() {
        rows.add("restitution", restitution())
        surfaces()
        scenario.interaction?.let {
            rows.add(
                "interaction",
                it.inWords(say) + ofOthers(scenario.contacts.any { pair -> pair.interaction != null }),
            )
        }
        materials.contacts()
        scenario.bonds?.let { rows.add("bonds", it.inWords()) }
        scenario.merging?.let { rows.add("merging", it.inWords(say)) }
        scenario.breaking?.let { rows.add("breaking", it.inWords(say)) }
        scenario.swaps?.let { rows.add("swaps", it.inWords(population.size, setup.firstStep(), say)) }
        scenario.sources.forEachIndexed { k, source -> rows.add("sources", "[$k] ${source.inWords(say)}") }
        rows.add("guard", scenario.guard.inWords(say))
    }

    private fun restitution(): String {
        val ofAll = setup.restitution.let { (it as? MaterialLaws)?.others ?: it }
        val radius = middle(population.radius)
        val mass = middle(population.mass)

        fun at(speed: Double): String {
            val contact = SurfaceContact.headOn(speed, radius, mass)
            return String.format(Locale.ROOT, "%.3f at %s", ofAll.restitution(contact), say.speed(speed))
        }
        val c = dispersion()
        val centimetre = 1 / scenario.units.speedInCmPerSecond
        val examples = if (c > 0) "${at(c)} (as at the start), ${at(centimetre)}" else at(centimetre)
        val law = scenario.restitution
        val of = if (law.dependsOnSize) "; of two of radius ${say.length(radius)} and mass ${say.mass(mass)}" else ""
        val words = law.inWords(say) + if (law.constant == null) "$of: $examples" else ""
        return words + ofOthers(scenario.contacts.any { it.restitution != null })
    }

    /** Of which impacts a law is where some pairs of materials have another. */
    private fun ofOthers(hasOthers: Boolean) = if (hasOthers) " (pairs with no other in contacts)" else ""

    /** The mean over particles; over bodies where there are none. */
    private fun middle(column: DoubleArray) =
        if (particles.isEmpty()) column.average() else particles.map { column[it] }.average()

    /** Nothing of smooth spheres without spin. */
    private fun surfaces() {
        if (!population.hasSpin) return
        val law = scenario.roughness?.inWords(::number) ?: "smooth"
        val others = ofOthers(scenario.contacts.any { it.roughness != null })
        rows.add("roughness", "$law$others; moment of inertia ${number(setup.momentFactor)} m r^2")
        val squares = particles.sumOf { k ->
            population.wx[k] * population.wx[k] + population.wy[k] * population.wy[k] +
                population.wz[k] * population.wz[k]
        }
        val spin = if (particles.isEmpty()) 0.0 else sqrt(squares / particles.size)
        val size = if (spin == 0.0) {
            "none"
        } else {
            "${say.angularSpeed(spin)} (root mean square of the whole vector, the mean included)"
        }
        rows.add("spins", "$size at the start")
    }

    private companion object {
        const val SECONDS_A_DAY = 86_400.0
    }
}
