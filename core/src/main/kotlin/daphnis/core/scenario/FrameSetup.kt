package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.input.InputException
import daphnis.core.input.UnitsSpec
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies
import kotlinx.serialization.Serializable

/**
 * Zonal harmonics of a planet.
 *
 * @property radiusInKm to which they refer
 */
@Serializable
public class OblatenessSpec @JvmOverloads constructor(
    public val radiusInKm: Double,
    public val j2: Double = 0.0,
    public val j4: Double = 0.0,
    public val j6: Double = 0.0,
)

/** GM of the planet in m³/s². */
internal val FrameSpec.Hill.gravitationalParameterInSi: Double
    get() = gravitationalParameter?.let { it * METRES_PER_KM * METRES_PER_KM * METRES_PER_KM }
        ?: planet.gravitationalParameter

/** GM of the planet in length³/time² of [units]; null when the length is not known. */
public fun FrameSpec.Hill.gravitationalParameter(units: UnitsSpec): Double? {
    val length = units.lengthInMetres ?: return null
    val time = units.timeInSeconds ?: return null
    return gravitationalParameterInSi * time * time / (length * length * length)
}

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
    public fun frequencies(scenario: ScenarioParts, source: String): OrbitalFrequencies? {
        val frame = scenario.frame as? FrameSpec.Hill ?: return null
        val check = ValueCheck(source)
        check.must("frame", (frame.angularSpeed == null) != (frame.distanceInKm == null)) {
            "needs exactly one of angularSpeed and distanceInKm"
        }
        frame.verticalFactor?.let { check.that("frame.verticalFactor", it, it >= 0) { "must be at least 0" } }
        frame.radialFactor?.let { check.that("frame.radialFactor", it, it > 0 && it < 2) { "must be > 0 and < 2" } }
        val speed = frame.angularSpeed
        val around = if (speed == null) around(scenario, frame, check) else given(frame, speed, check)
        return OrbitalFrequencies(
            around.omega,
            frame.radialFactor ?: around.radialFactor,
            frame.verticalFactor ?: around.verticalFactor,
        )
    }

    /**
     * Distance of the middle of the frame from the centre of the planet, in units of length. Where the frame is given
     * by its angular speed, Kepler's.
     *
     * @param frequencies as [frequencies] gives them
     * @return null when it is not known: without a frame, and without a unit of length
     */
    @JvmStatic
    public fun distance(scenario: ScenarioParts, frequencies: OrbitalFrequencies): Double? {
        val frame = scenario.frame as? FrameSpec.Hill ?: return null
        val metres = scenario.units.lengthInMetres ?: return null
        frame.distanceInKm?.let { return it * METRES_PER_KM / metres }
        val planet = frame.gravitationalParameter(scenario.units) ?: return null
        return StrictMath.cbrt(planet / (frequencies.omega * frequencies.omega))
    }

    private fun given(frame: FrameSpec.Hill, speed: Double, check: ValueCheck): OrbitalFrequencies {
        check.positive("frame.angularSpeed", speed)
        check.must("frame.oblateness", frame.oblateness == null) { NEEDS_DISTANCE }
        frame.gravitationalParameter?.let { check.positive("frame.gravitationalParameter", it) }
        return OrbitalFrequencies(speed)
    }

    private fun around(scenario: ScenarioParts, frame: FrameSpec.Hill, check: ValueCheck): OrbitalFrequencies {
        val distance = frame.distanceInKm!!
        check.positive("frame.distanceInKm", distance)
        scenario.units.lengthInMetres?.let { check.positive("units.lengthInMetres", it) }
        check.positive("units.speedInCmPerSecond", scenario.units.speedInCmPerSecond)
        frame.gravitationalParameter?.let { check.positive("frame.gravitationalParameter", it) }
        val second =
            scenario.units.timeInSeconds
                ?: check.fail("units.lengthInMetres", "is missing; frame.distanceInKm needs it")
        val metres = distance * METRES_PER_KM
        val oblate = frame.oblateness
        if (oblate != null) {
            check.must("frame.radialFactor", frame.radialFactor == null) {
                "follows from frame.oblateness; give one of the two"
            }
            check.positive("frame.oblateness.radiusInKm", oblate.radiusInKm)
            check.that("frame.distanceInKm", distance, distance >= oblate.radiusInKm) {
                "is inside the planet, whose radius is ${oblate.radiusInKm} km"
            }
        }
        val inSeconds = try {
            if (oblate == null) {
                OrbitalFrequencies.around(frame.gravitationalParameterInSi, metres)
            } else {
                val radius = oblate.radiusInKm * METRES_PER_KM
                OrbitalFrequencies.around(
                    frame.gravitationalParameterInSi,
                    metres,
                    radius,
                    oblate.j2,
                    oblate.j4,
                    oblate.j6,
                )
            }
        } catch (e: IllegalArgumentException) {
            check.fail(if (oblate == null) "frame.distanceInKm" else "frame.oblateness", "cannot be: ${e.message}")
        }
        val speed = inSeconds.omega * second
        check.that("frame.distanceInKm", distance, speed > 0 && speed.isFinite()) {
            "gives an angular speed of $speed in the scenario's units; it must be > 0 and finite"
        }
        return OrbitalFrequencies(speed, inSeconds.radialFactor, inSeconds.verticalFactor)
    }

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

private const val METRES_PER_KM = 1000.0
private const val NEEDS_DISTANCE = "is that of a planet; it needs frame.distanceInKm"
