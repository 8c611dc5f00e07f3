package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.compression.GrowingSpheres
import daphnis.core.initial.fillingFactor
import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import kotlinx.serialization.Serializable
import java.util.Locale
import kotlin.math.abs
import kotlin.math.cbrt
import kotlin.math.sqrt

/**
 * All spheres grow in proportion while they collide, see [GrowingSpheres]. The run ends when the first of its ends is
 * reached, at the end of a step.
 *
 * @property rate growth of a radius per unit of time, over its radius at the time [since]; < 0 for spheres that shrink, 0
 *   for none of this
 * @property thermostat whether velocities are rescaled after each step, so that the kinetic energy stays
 * @property untilFillingFactor at which the run ends
 * @property untilPressure reduced pressure P V/(N kT) in a step, at which the run ends
 * @property since a time on the run's clock at which radii had the size over which [rate] is; null for the start
 */
@Serializable
public class GrowthSpec @JvmOverloads constructor(
    @Described("Γ: a radius at time t is its radius at the start times 1 + Γt; below 0 spheres shrink, 0 is no growth")
    public val rate: Double,
    @Described(
        "after each step velocities are rescaled, so that the kinetic energy is that at its start, and the " +
            "momentum is 0; default true",
    )
    public val thermostat: Boolean = true,
    @Described("the run ends with the step in which it is reached; default none")
    public val untilFillingFactor: Double? = null,
    @Described("the same for the reduced pressure PV/(NkT) of a step; default none")
    public val untilPressure: Double? = null,
    @Described("a time at which radii were those that Γ is over; default the start, or that of the run it goes on from")
    public val since: Double? = null,
) {
    /** The same with the rate over radii at the time [since]. */
    internal fun since(since: Double?) = GrowthSpec(rate, thermostat, untilFillingFactor, untilPressure, since)

    /** Whether a run ends where spheres fill the part [fillingFactor] at the [reducedPressure]. */
    internal inline fun isOver(reducedPressure: Double, fillingFactor: () -> Double): Boolean =
        untilFillingFactor != null && (fillingFactor() >= untilFillingFactor) == (rate > 0) ||
            untilPressure != null && reducedPressure >= untilPressure
}

/** Checks the growth of a scenario and puts it into its boundary. */
internal class GrowthSetup(private val scenario: Scenario, private val check: ValueCheck) {
    private val spec = scenario.growth
    private val since = spec?.since ?: scenario.startTime

    /** The [boundary] of the scenario around [box], in which spheres grow if they are to. */
    fun boundary(boundary: BoundaryConditions, box: Box): BoundaryConditions {
        if (spec == null) return boundary
        check.that("growth.rate", spec.rate, spec.rate.isFinite()) { "must be finite" }
        spec.untilFillingFactor?.let { goal ->
            check.that("growth.untilFillingFactor", goal, goal > 0 && goal < 1) { "must be > 0 and < 1" }
        }
        spec.untilPressure?.let { goal ->
            check.that("growth.untilPressure", goal, goal > 1 && goal.isFinite()) {
                "must be > 1, that of an ideal gas"
            }
        }
        val scale = scaleAt(scenario.startTime)
        spec.since?.let { time ->
            check.that("growth.since", time, scale > 0 && scale.isFinite()) {
                "makes radii at the start, time ${scenario.startTime}, $scale times those; must be > 0 and finite"
            }
        }
        fun need(isMet: Boolean, what: String) = check.must("growth", isMet) { "needs $what" }
        need(scenario.boundary.repeatsAtRest, "boundary periodic, and has ${scenario.boundary}")
        need(scenario.frame == null, "a frame that does not turn, and so no frame")
        need(scenario.forces.isEmpty(), "spheres on which no force acts")
        val laws = scenario.contacts.mapNotNull { it.restitution } + scenario.restitution
        val isElastic = laws.all { it.constant == 1.0 }
        need(isElastic, "elastic collisions, restitution constant with the coefficient 1")
        val isSmooth = scenario.roughness == null && scenario.contacts.all { it.roughness == null }
        need(isSmooth, "smooth spheres, without roughness")
        need(scenario.interactions.isEmpty(), "spheres without interaction")
        need(scenario.bonds == null, "spheres that are not bound, without bonds")
        need(scenario.merging == null, "spheres that do not merge, without merging")
        need(scenario.breaking == null, "spheres that do not break, without breaking")
        return if (spec.rate == 0.0) boundary else GrowingSpheres(box, spec.rate, since, spec.thermostat)
    }

    /** Radii at [time] over those at the time since which they grow. */
    private fun scaleAt(time: Double) = 1 + (spec?.rate ?: 0.0) * (time - since)

    /** The longest step. */
    fun longest(): Double = if (spec == null || spec.rate == 0.0) Double.MAX_VALUE else PART / abs(spec.rate)

    /**
     * Checks that [population], with which a run to the time [end] begins with a step of [duration], has room to grow
     * in [box].
     */
    fun checkStart(population: Population, box: Box, duration: Double, end: Double) {
        if (spec == null || spec.rate == 0.0 || population.size == 0) return
        val change = abs(spec.rate) * duration / scaleAt(scenario.startTime)
        check.that("growth.rate", spec.rate, change <= GrowingSpheres.MOST) {
            "changes radii by more than a tenth in a step of $duration; take a smaller rate or dt"
        }
        val wide = 2 * population.radius.max() * (1 + 2 * change) * SLIGHTLY_MORE
        check.that("growth.rate", spec.rate, (0 until box.space.dimensions).all { wide < box.length(it) }) {
            "makes the largest sphere touch its own image in a box of ${scenario.box.lengths}"
        }
        val goal = spec.untilFillingFactor
        if (goal != null) {
            val what = if (box.space.isPlane) "discs" else "spheres"
            val now = fillingFactor(population.radius, box)
            val most = most(population, box)
            check.that("growth.untilFillingFactor", goal, goal < most) { "equal ones fill $most at most" }
            check.that("growth.untilFillingFactor", goal, (goal > now) == (spec.rate > 0)) {
                "$what fill $now at the start, and the rate is ${spec.rate}"
            }
        }
        checkEnd(population, box, duration, scenario.startTime, end)
    }

    /**
     * Checks that [population], at time [now], can have the radii of the time [end], in steps of [duration]. Spheres
     * that shrink do so the faster the smaller they are.
     */
    fun checkEnd(population: Population, box: Box, duration: Double, now: Double, end: Double) {
        if (spec == null || spec.rate == 0.0 || population.size == 0 || end <= now) return
        val what = if (box.space.isPlane) "discs" else "spheres"
        val scale = scaleAt(end) / scaleAt(now)
        val filling = fillingFactor(population.radius, box)
        val goal = spec.untilFillingFactor
        if (goal == null) {
            check.that("growth.rate", spec.rate, scale > 0) { "makes $what vanish before the end at time $end" }
        }
        if (spec.rate < 0) {
            // Over the radii at the start, when the last step begins.
            fun edge(part: Double) = if (box.space.isPlane) sqrt(part) else cbrt(part)
            val least = goal?.let { scaleAt(now) * edge(it / filling) } ?: 0.0
            val last = maxOf(scaleAt(end - minOf(duration, end - now)), least)
            val change = abs(spec.rate) * duration / last
            check.that("growth.rate", spec.rate, change <= GrowingSpheres.MOST) {
                val part = "%.2g".format(Locale.ROOT, change)
                "shrinks radii by $part of what they are in the last step of $duration; " +
                    "a tenth is the most; take a smaller dt or an earlier end"
            }
        } else if (goal == null && spec.untilPressure == null) {
            val last = filling * if (box.space.isPlane) scale * scale else scale * scale * scale
            check.that("growth.rate", spec.rate, last < most(population, box)) {
                "makes $what fill $last of the box by the end at time $end; give an earlier end, or " +
                    "growth.untilFillingFactor or growth.untilPressure"
            }
        }
    }

    /** Filling factor that [population] cannot exceed. */
    private fun most(population: Population, box: Box) =
        if (population.radius.all { it == population.radius[0] }) box.space.closestPacking else 1.0

    private companion object {
        /** By how much radii grow at most in a step of which the scenario does not say how long it is. */
        const val PART = 0.02

        const val SLIGHTLY_MORE = 1 + 1e-6
    }
}
