package daphnis.analysis.report

import daphnis.analysis.insitu.State
import daphnis.analysis.plot.Curve
import daphnis.analysis.theory.CoolingGas
import daphnis.analysis.theory.EnskogGas
import daphnis.core.scenario.Scenario

/** What theory knows of a gas of equal smooth spheres that nothing but collisions of one restitution cools. */
internal object CoolingReferences {
    /** What correlated velocities add to a₂ and leave out of the rate, as in a heated gas. */
    private const val CUMULANT_BOUND = 0.005
    private const val SOURCE = "van Noije & Ernst 1998"

    /** a₂ while it cools evenly. */
    fun of(scenario: Scenario, last: State): Map<String, Reference> {
        val restitution = restitution(scenario, last) ?: return emptyMap()
        val a2 = CoolingGas.fourthCumulant(restitution)
        return mapOf("velocity_a2" to Reference(a2, CUMULANT_BOUND, SOURCE))
    }

    /** Haff's law from the first point of the [temperature] on, both in units of [scale]; null for another gas. */
    fun line(study: Study, temperature: Curve): Curve? {
        val scenario = study.physics ?: return null
        val restitution = restitution(scenario, study.last) ?: return null
        val filling = study.bulk.fillingFactor
        if (filling > EnskogGas.MOST_FILLED) return null
        val unit = study.scale.speed * study.scale.speed
        val start = temperature.y.first()
        val diameter = 2 * study.last.population.radius[0]
        val rate = CoolingGas.coolingRate(diameter, restitution, filling, start * unit) * study.scale.time
        val begin = temperature.x.first()
        val law = DoubleArray(temperature.x.size) { CoolingGas.temperature(start, rate, temperature.x[it] - begin) }
        return Curve("Haff's law", temperature.x, law)
    }

    /** The coefficient of such a gas in space; null for another. */
    private fun restitution(scenario: Scenario, last: State): Double? {
        val restitution = scenario.restitutionAtRest ?: return null
        val isFree = (0..2).all { last.boundary.repeats(it) }
        val isKnown = restitution < 1 && restitution >= CoolingGas.LEAST_RESTITUTION
        return if (isFree && isKnown && References.isPlain(scenario, last)) restitution else null
    }
}
