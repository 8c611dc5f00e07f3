package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions

/** A scenario's frame in its units, and times given in orbits. */
public object FrameSetup {
    /**
     * Angular speed of the frame in radians per unit of time; null when there is no frame.
     *
     * @param source what to call the scenario in messages
     * @throws InputException when the frame is not determined
     */
    @JvmStatic
    public fun angularSpeed(scenario: ScenarioParts, source: String): Double? {
        val check = ValueCheck(source)
        val frame = scenario.frame as? FrameSpec.Hill ?: return null
        check.must("frame", (frame.angularSpeed == null) != (frame.distanceInKm == null)) {
            "needs exactly one of angularSpeed and distanceInKm"
        }
        check.that("frame.verticalFactor", frame.verticalFactor, frame.verticalFactor >= 0) { "must be at least 0" }
        frame.angularSpeed?.let { return it.also { speed -> check.positive("frame.angularSpeed", speed) } }
        val distance = frame.distanceInKm!!
        check.positive("frame.distanceInKm", distance)
        scenario.units.lengthInMetres?.let { check.positive("units.lengthInMetres", it) }
        check.positive("units.speedInCmPerSecond", scenario.units.speedInCmPerSecond)
        val second =
            scenario.units.timeInSeconds
                ?: check.fail("units.lengthInMetres", "is missing; frame.distanceInKm needs it")
        val speed = frame.planet.angularSpeed(distance) * second
        check.that("frame.distanceInKm", distance, speed > 0 && speed.isFinite()) {
            "gives an angular speed of $speed in the scenario's units; it must be > 0 and finite"
        }
        return speed
    }

    /**
     * In Hill's frame no two radial positions are equivalent: a sphere that leaves at one side enters at the other only
     * with the frame's shear, so images along x must slide with it, or there must be none. Along z the force towards
     * the midplane would change sign at periodic faces.
     *
     * @param boundary the boundary conditions made from [Scenario.boundary]
     */
    internal fun checkFaces(scenario: Scenario, boundary: BoundaryConditions, omega: Double?, check: ValueCheck) {
        val frame = scenario.frame as? FrameSpec.Hill ?: return
        val flow = boundary.meanFlow?.takeIf { boundary.shear?.normalAxis == 0 }
        val fitsRadially = !boundary.repeats(0) || flow?.rate == -1.5 * omega!!
        val fitsVertically = !boundary.repeats(2) || frame.verticalFactor == 0.0
        check.that("boundary.type", scenario.boundary, fitsRadially && fitsVertically) {
            "it cannot be combined with a frame of type hill, whose mean flow v_y = -3/2 Ω x " +
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
        val step = scenario.timeStep
        if (step !is TimeStepSpec.OrbitFraction) return RunTimes(end, step)
        check.positive("timeStep.steps", step.steps)
        val length = orbit ?: check.fail("timeStep", "is part of an orbit; it needs a frame")
        return RunTimes(end, TimeStepSpec.Fixed(length / step.steps))
    }
}

/**
 * When a run ends and how long its steps are, in units of time.
 *
 * @property timeStep not an [TimeStepSpec.OrbitFraction]
 */
public class RunTimes internal constructor(public val end: Double, public val timeStep: TimeStepSpec)
