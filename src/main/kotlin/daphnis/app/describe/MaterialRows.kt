package daphnis.app.describe

import daphnis.core.input.Quantities
import daphnis.core.scenario.ScenarioSetup

/** What spheres are made of, and how materials collide where that is not as for all. */
internal class MaterialRows(private val setup: ScenarioSetup, private val say: Quantities, private val rows: Rows) {
    private val population = setup.population

    /** A row for each material. */
    fun materials() {
        population.materials.forEachIndexed { number, name ->
            val its = population.radius.indices.filter { population.material[it].toInt() == number }
            if (its.isEmpty()) {
                rows.add("materials", "$name: no ${one(setup.boundary.space)}")
                return@forEachIndexed
            }
            val radii = its.map { population.radius[it] }
            val masses = its.map { population.mass[it] }
            val space = setup.boundary.space
            val perVolume = masses.sum() / radii.sumOf { space.volume(it) }
            val density = if (space.isPlane) say.surfaceDensity(perVolume) else say.density(perVolume)
            rows.add(
                "materials",
                "$name: ${spheres(
                    its.size,
                    space,
                )}, radius ${range(radii, say::length)}, mass ${range(masses, say::mass)}, " +
                    "density $density",
            )
        }
    }

    /** A row for each pair that has a law of its own. */
    fun contacts() {
        for (contact in setup.scenario.contacts) {
            val laws = listOfNotNull(
                contact.restitution?.let { "restitution ${it.inWords(say)}" },
                contact.roughness?.let { "roughness ${it.inWords(Quantities::number)}" },
                contact.interaction?.let { "interaction ${it.inWords(say)}" },
            )
            rows.add("contacts", "${contact.between.joinToString(" with ")}: ${laws.joinToString("; ")}")
        }
    }

    private fun range(values: List<Double>, say: (Double) -> String): String =
        if (values.min() == values.max()) say(values[0]) else "${say(values.min())} to ${say(values.max())}"
}
