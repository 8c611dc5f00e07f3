package daphnis.app.describe

import daphnis.app.describe.Quantities.Companion.number
import daphnis.core.boundary.ContactFaces
import daphnis.core.initial.fillingFactor
import daphnis.core.population.granularTemperature
import daphnis.core.scenario.FrameSpec
import daphnis.core.scenario.GuardSpec
import daphnis.core.scenario.RestitutionSpec
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
        motion()
        collisions()
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
        rows.add("particles", "${spheres(particles.size)}, radius $size")
        val mass = if (masses.min() == masses.max()) {
            say.mass(masses[0])
        } else {
            "${say.mass(masses.min())} to ${say.mass(masses.max())}"
        }
        rows.add("mass", "$mass each, ${say.mass(masses.sum())} together")
        rows.add("density", say.density(masses.sum() / radii.sumOf { VOLUME * it * it * it }))
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
        val omega = setup.angularSpeed ?: return
        val frame = scenario.frame as FrameSpec.Hill
        val where = frame.distanceInKm?.let {
            ", ${"%.0f".format(Locale.ROOT, it)} km from ${frame.planet.name.lowercase()}"
        }.orEmpty()
        val orbit = 2 * Math.PI / omega
        rows.add(
            "orbit",
            "${say.time(orbit)}$where; the run is ${number((scenario.end - scenario.startTime) / orbit)} orbits",
        )
    }

    private fun fullness() {
        val radii = DoubleArray(particles.size) { population.radius[particles[it]] }
        val open = (0..2).any { setup.boundary.contactFaces(it) == ContactFaces.OPEN }
        rows.add("filling factor", number(fillingFactor(radii, box)) + if (open) " of the box at the start" else "")
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
    private fun dispersion() = sqrt(granularTemperature(population, setup.boundary.meanFlow, scenario.firstBody))

    private fun collisions() {
        rows.add("restitution", restitution())
        surfaces()
        materials.contacts()
        when (val guard = scenario.guard) {
            is GuardSpec.None -> rows.add("guard", "none")
            is GuardSpec.FloorSpeed -> rows.add("guard", "elastic below ${say.speed(guard.speed ?: 0.0)}")
            is GuardSpec.ContactDuration -> rows.add(
                "guard",
                "elastic within ${say.time(guard.duration)} of the last collision",
            )
        }
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
        return when (val law = scenario.restitution) {
            is RestitutionSpec.Constant -> "${number(law.coefficient)} at every speed"
            is RestitutionSpec.Bridges ->
                "bridges, ${number(law.prefactor)} v^${number(law.exponent)} with v in cm/s: $examples"
            is RestitutionSpec.Borderies -> "borderies, elastic below ${number(law.criticalSpeed)} cm/s: $examples"
            is RestitutionSpec.Step ->
                "step, ${number(
                    law.below,
                )} below ${number(law.speed)} cm/s, ${number(law.coefficient)} from there on: " +
                    examples
            is RestitutionSpec.Table -> "table of ${law.points.size} points from ${law.points.first().inWords()} " +
                "to ${law.points.last().inWords()}: $examples"
            is RestitutionSpec.Viscoelastic ->
                "viscoelastic; of two spheres of radius ${say.length(radius)} and mass ${say.mass(mass)}: $examples"
        }
    }

    private fun List<Double>.inWords() = "${number(this[1])} at ${number(this[0])} cm/s"

    /** The mean over particles; over bodies where there are none. */
    private fun middle(column: DoubleArray) =
        if (particles.isEmpty()) column.average() else particles.map { column[it] }.average()

    /** Nothing of smooth spheres without spin. */
    private fun surfaces() {
        if (!population.hasSpin) return
        val law = scenario.roughness?.inWords(::number) ?: "smooth"
        rows.add("roughness", "$law; moment of inertia ${number(setup.momentFactor)} m r^2")
        val squares = particles.sumOf { k ->
            population.wx[k] * population.wx[k] + population.wy[k] * population.wy[k] +
                population.wz[k] * population.wz[k]
        }
        val spin = if (particles.isEmpty()) 0.0 else sqrt(squares / particles.size)
        val size = if (spin == 0.0) "none" else "${say.angularSpeed(spin)} (root mean square)"
        rows.add("spins", "$size at the start")
    }

    private companion object {
        const val VOLUME = 4.0 / 3.0 * Math.PI
    }
}
