package daphnis.app.describe

import daphnis.analysis.theory.ShearInstability
import daphnis.core.initial.fillingFactor
import daphnis.core.scenario.BoundarySpec
import daphnis.core.scenario.RestitutionSpec
import daphnis.core.scenario.RoughnessSpec
import daphnis.core.scenario.ScenarioSetup

/**
 * The box length from which on vortices grow in a gas of equal smooth spheres or discs that cools by itself, in words;
 * null for other systems, and where theory does not reach.
 */
internal fun criticalLength(setup: ScenarioSetup, say: Quantities): String? {
    val scenario = setup.scenario
    val space = setup.boundary.space
    val radii = setup.population.radius
    val law = scenario.restitution as? RestitutionSpec.Constant ?: return null
    val isPlain = scenario.boundary is BoundarySpec.Periodic &&
        (0 until space.dimensions).all { setup.boundary.repeats(it) } &&
        listOf(scenario.forces, scenario.contacts, scenario.bodies).all { it.isEmpty() } &&
        scenario.frame == null &&
        scenario.growth == null &&
        (scenario.roughness == null || scenario.roughness is RoughnessSpec.Smooth)
    if (!isPlain || !areEqual(radii) || !areEqual(setup.population.mass)) return null
    val filling = fillingFactor(radii, setup.boundary.box)
    if (law.coefficient < ShearInstability.LEAST_RESTITUTION || law.coefficient >= 1) return null
    if (!(filling > 0 && filling <= ShearInstability.MOST_FILLED)) return null
    val length = 2 * radii[0] * ShearInstability.criticalLength(law.coefficient, filling, space)
    val longest = (0 until space.dimensions).maxOf { setup.boundary.box.length(it) }
    val seen = if (longest > length) "vortices will form" else "none form in this box"
    return "${say.length(length)}; in longer boxes vortices form as the gas cools (Garzó 2005): $seen"
}

private fun areEqual(values: DoubleArray) = values.isNotEmpty() && values.min() == values.max()
