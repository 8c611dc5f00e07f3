package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.input.InputException
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies

/** A scenario's frame in its units, and times given in orbits. */
public object FrameSetup {
    /**
     * Angular speed of the frame in radians per unit of time; null when there is no frame.
     *
     * @param source what to call the scenario in messages
     * @throws InputException when the frame is not determined
     */
    @JvmStatic
    public fun angularSpeed(scenario: ScenarioParts, source: String): Double? = frequencies(scenario, source)?.omega

    /**
     * Frequencies of orbits in the frame, in radians per unit of time; null when there is no frame.
     *
     * @param source what to call the scenario in messages
     * @throws InputException when the frame is not determined
     */
    @JvmStatic
    public fun frequencies(scenario: ScenarioParts, source: String): OrbitalFrequencies? =
        scenario.frame?.frequencies(scenario.units, ValueCheck(source))

    /**
     * Distance of the middle of the frame from the centre of the planet, in units of length. Where the frame is given
     * by its angular speed, Kepler's.
     *
     * @param frequencies as [frequencies] gives them
     * @return null when it is not known: without a frame, and without a unit of length
     */
    @JvmStatic
    public fun distance(scenario: ScenarioParts, frequencies: OrbitalFrequencies): Double? =
        scenario.frame?.distance(scenario.units, frequencies)

    /**
     * In Hill's frame no two radial positions are equivalent: a sphere that leaves at one side enters at the other only
     * with the frame's shear, so images along x must slide with it, or there must be none. Along z the force towards
     * the midplane would change sign at periodic faces.
     *
     * @param boundary the boundary conditions made from [Scenario.boundary]
     * @param frequencies null without a frame
     */
    internal fun checkFaces(
        scenario: Scenario,
        boundary: BoundaryConditions,
        frequencies: OrbitalFrequencies?,
        check: ValueCheck,
    ) {
        if (frequencies == null) return
        val flow = boundary.meanFlow?.takeIf { boundary.shear?.normalAxis == 0 }
        val fitsRadially = !boundary.repeats(0) || flow?.rate == -frequencies.shearRate
        val fitsVertically = !boundary.repeats(2) || frequencies.verticalFactor == 0.0
        check.that("boundary.type", scenario.boundary, fitsRadially && fitsVertically) {
            "it cannot be combined with a frame of type hill, whose mean flow shears along x and " +
                "is not the same at both faces; it must be hill-sheet or open (or walls across x and z)"
        }
    }

    /**
     * The end of the run and its steps in units of time, where the scenario may give them in orbits.
     *
     * @throws InputException when they are not determined
     */
    @JvmStatic
    public fun times(scenario: Scenario, source: String): RunTimes {
        val check = ValueCheck(source)
        val omega = angularSpeed(scenario, source)
        val orbit = if (omega == null) null else 2 * Math.PI / omega
        scenario.untilOrbits?.let { orbits ->
            check.positive("untilOrbits", orbits)
            check.that("untilOrbits", orbits, orbit != null) {
                "it needs a frame of type hill; give until, a time, instead"
            }
        }
        val until = scenario.until ?: scenario.untilOrbits?.let { it * orbit!! }
        val end = until ?: check.fail("until", "is missing; it must be a finite number (or give untilOrbits)")
        return RunTimes(end, scenario.timeStep.inTime(orbit, check))
    }
}

/**
 * When a run ends and how long its steps are, in units of time.
 *
 * @property timeStep not an [TimeStepSpec.OrbitFraction]
 */
public class RunTimes internal constructor(public val end: Double, public val timeStep: TimeStepSpec)
