package daphnis.core.scenario

import daphnis.core.CellCrossingTimeStep
import daphnis.core.FixedTimeStep
import daphnis.core.FreePathTimeStep
import daphnis.core.Interval
import daphnis.core.Stops
import daphnis.core.TimeStep
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.roomIn
import daphnis.core.input.Described
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable

/** How long steps are. */
@Serializable
public sealed interface TimeStepSpec {
    /** The length of steps that are all of one length, which is known; else null. */
    public val dt: Double? get() = null

    /** Whether the length is chosen, since it is no physics, and times of outputs and the end are hit. */
    public val isChosen: Boolean get() = false

    /** The same in units of time, where an orbit takes the time [orbit]; null where there is none. */
    public fun inTime(orbit: Double?, check: ValueCheck): TimeStepSpec = this

    /** The same with what follows from the initial state of [population]. */
    public fun settled(around: Surroundings, population: Population): TimeStepSpec = this

    /** The same with what [found], that of a run, has from its initial state. */
    public fun settledAs(found: TimeStepSpec): TimeStepSpec = this

    /**
     * The steps of [scenario] in [boundary], with their values checked.
     *
     * @param most that no chosen step exceeds
     */
    public fun timeStep(
        scenario: ResolvedScenario,
        boundary: BoundaryConditions,
        most: Double,
        check: ValueCheck,
    ): TimeStep

    /** The key that is to blame for steps that are too many or too short, its value, and the longest step after [first]. */
    public fun longest(first: Double): Triple<String, Double, Double>

    /**
     * Chosen from the state, where no force acts; see [FreePath]. Intervals of outputs and the end are hit exactly.
     *
     * @property path how far the fastest sphere moves in a step at most, a length; null for one that follows from
     *   the initial state
     */
    @Serializable
    @SerialName("automatic")
    @Described("chosen, where no force acts; ends at `until` and at intervals of outputs exactly")
    public class Automatic @JvmOverloads constructor(
        @Described(
            "how far the fastest sphere moves along an axis in a step at most, relative to the mean flow; default " +
                "chosen",
        )
        public val path: Double? = null,
    ) : TimeStepSpec {
        override val isChosen: Boolean get() = true

        override fun settled(around: Surroundings, population: Population): TimeStepSpec =
            if (path != null) this else Automatic(FreePath.length(population, around.box, around.boundary))

        override fun settledAs(found: TimeStepSpec): TimeStepSpec = if (path == null && found.isChosen) found else this

        override fun timeStep(
            scenario: ResolvedScenario,
            boundary: BoundaryConditions,
            most: Double,
            check: ValueCheck,
        ): TimeStep {
            val path = path ?: 0.0
            check.positive("timeStep.path", path)
            val stops = Stops(scenario.output.stops().map { Interval(it) }, scenario.end)
            val longest = minOf(scenario.end - scenario.startTime, FreePath.longest(boundary), most)
            return FreePathTimeStep(path, longest, boundary.meanFlow, stops)
        }

        /** Between stops a chosen step is at least half as long as it may be. */
        override fun longest(first: Double): Triple<String, Double, Double> =
            Triple("timeStep.path", path ?: 0.0, first / 2)
    }

    @Serializable
    @SerialName("fixed")
    @Described("always `dt`")
    public class Fixed(
        @Described("length of a step, in units of time")
        override val dt: Double,
    ) : TimeStepSpec {
        override fun timeStep(
            scenario: ResolvedScenario,
            boundary: BoundaryConditions,
            most: Double,
            check: ValueCheck,
        ): TimeStep {
            check.positive("timeStep.dt", dt)
            return FixedTimeStep(dt)
        }

        override fun longest(first: Double): Triple<String, Double, Double> = Triple("timeStep.dt", dt, dt)
    }

    /** [steps] equal steps per orbit of the frame. */
    @Serializable
    @SerialName("orbit-fraction")
    @Described("equal steps, so many per orbit of the frame")
    public class OrbitFraction(
        @Described("steps per orbit")
        public val steps: Double,
    ) : TimeStepSpec {
        override fun inTime(orbit: Double?, check: ValueCheck): TimeStepSpec {
            check.positive("timeStep.steps", steps)
            val length = orbit ?: check.fail("timeStep", "is part of an orbit; it needs a frame")
            return Fixed(length / steps)
        }

        override fun timeStep(
            scenario: ResolvedScenario,
            boundary: BoundaryConditions,
            most: Double,
            check: ValueCheck,
        ): TimeStep = error("times are written out before")

        override fun longest(first: Double): Triple<String, Double, Double> = error("times are written out before")
    }

    /**
     * The fastest sphere crosses at most [fraction] of [cell] (default: mean distance between spheres); never longer
     * than [longest].
     */
    @Serializable
    @SerialName("cell-crossing")
    @Described("as long as the fastest sphere takes for a part of a length along an axis")
    public class CellCrossing @JvmOverloads constructor(
        @Described("part of `cell` that it crosses in one step; default 0.5")
        public val fraction: Double = 0.5,
        @Described("a length; default the mean distance between spheres")
        public val cell: Double? = null,
        @Described("longest step, in units of time")
        public val longest: Double,
    ) : TimeStepSpec {
        override fun settled(around: Surroundings, population: Population): TimeStepSpec {
            if (cell != null) return this
            val box = around.box
            return CellCrossing(fraction, box.space.edge(around.boundary.roomIn(box) / population.size), longest)
        }

        override fun settledAs(found: TimeStepSpec): TimeStepSpec =
            if (cell == null && found is CellCrossing) CellCrossing(fraction, found.cell, longest) else this

        override fun timeStep(
            scenario: ResolvedScenario,
            boundary: BoundaryConditions,
            most: Double,
            check: ValueCheck,
        ): TimeStep {
            check.positive("timeStep.fraction", fraction)
            check.positive("timeStep.longest", longest)
            val cell = cell ?: 0.0
            check.positive("timeStep.cell", cell)
            return CellCrossingTimeStep(fraction, cell, longest)
        }

        override fun longest(first: Double): Triple<String, Double, Double> =
            Triple("timeStep.longest", longest, longest)
    }
}
