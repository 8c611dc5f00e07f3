package daphnis.app.describe

import daphnis.analysis.theory.ShearInstability
import daphnis.core.initial.fillingFactor
import daphnis.core.input.Quantities
import daphnis.core.scenario.ScenarioSetup

/**
 * The box length from which on vortices grow in a gas of equal smooth spheres or discs that cools by itself, in words;
 * null for other systems, and where theory does not reach.
 */
internal fun criticalLength(setup: ScenarioSetup, say: Quantities): String? {
    val space = setup.boundary.space
    val radii = setup.population.radius
    val restitution = setup.scenario.restitutionAtRest ?: return null
    val isFree = (0 until space.dimensions).all { setup.boundary.repeats(it) }
    if (!isFree || !areEqual(radii) || !areEqual(setup.population.mass)) return null
    val filling = fillingFactor(radii, setup.boundary.box)
    if (restitution < ShearInstability.LEAST_RESTITUTION || restitution >= 1) return null
    if (!(filling > 0 && filling <= ShearInstability.MOST_FILLED)) return null
    val length = 2 * radii[0] * ShearInstability.criticalLength(restitution, filling, space)
    val longest = (0 until space.dimensions).maxOf { setup.boundary.box.length(it) }
    val seen = if (longest > length) "vortices will form" else "none form in this box"
    return "${say.length(length)}; in longer boxes vortices form as the gas cools (Garzó 2005): $seen"
}

private fun areEqual(values: DoubleArray) = values.isNotEmpty() && values.min() == values.max()
