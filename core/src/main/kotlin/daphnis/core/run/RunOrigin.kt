package daphnis.core.run

import daphnis.core.collision.GuardSpec
import daphnis.core.format.Snapshot
import daphnis.core.format.reasonOf
import daphnis.core.input.InputException
import daphnis.core.scenario.ClockSpec
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.Surroundings
import daphnis.core.scenario.TimeStepSpec
import daphnis.core.scenario.WallFacesSpec
import java.io.IOException

/**
 * A state of another run from which a run starts, see [Run.start].
 *
 * Ids, radii, masses, positions and velocities go over, and so do the time, the clock by which it is counted, and which
 * spheres are bodies. Steps, collisions, boxes crossed, sums of outputs, and the times since the last collisions begin
 * anew.
 *
 * @property run which has the state
 * @property state one of its states, of which nothing may be changed
 */
public class RunOrigin(public val run: RecordedRun, public val state: Snapshot) {
    /** The run directory, as the caller named it. */
    public val name: String get() = "${run.directory.path}"

    /** The scenario of the other run; null when that is of a [Program]. */
    internal val scenario: Scenario? by lazy { run.scenario() }

    /** Space and time of the other run; null when it is of a [Program]. */
    internal val around: Surroundings? by lazy { scenario?.let { Surroundings.of(it, "${run.directory.scenario}") } }

    /** What goes over: which pairs are bound says nothing of bridges where the other run had none. */
    internal val start: Snapshot by lazy {
        if (scenario?.interactions.orEmpty().any { it.remembers }) state else state.with(bound = null)
    }

    /** Whether the scenario's [key] is of an initial state, so that a run from this one cannot be given it. */
    public fun isOfState(key: String): Boolean {
        if (key.substringBefore('.').substringBefore('[') in OF_STATE) return true
        val face = OF_PISTON.matchEntire(key)?.groupValues?.get(1) ?: return false
        return WallFacesSpec.NAMES.indexOf(face) in pistonsOf(scenario)
    }

    /** The placement of a scenario that starts from the state. */
    internal fun placement() = PlacementSpec.File(name, state.time, state.step, run = name, clock = clock())

    /** The clock of the other run after its steps to the state; null when its steps have no fixed length. */
    private fun clock(): ClockSpec? {
        val step = around?.timeStep?.takeIf { it.dt != null } ?: return null
        val clock = scenario!!.clock(step)
        return ClockSpec(clock.start, clock.steps + state.step)
    }

    /** What a user should know about a start of [scenario] from the state, one line each. */
    internal fun notices(scenario: Scenario): List<String> = listOfNotNull(
        "$name: the times since the last collisions are not part of a state; guard.duration counts from the start"
            .takeIf { scenario.guard?.remembers == true },
        "$name: bridges are not part of a state; none is there until surfaces meet"
            .takeIf { start.bound == null && scenario.interactions.any { it.remembers } },
    ) + elsewhere(scenario)

    /** Pistons that [scenario] would have elsewhere, or with another speed, than the scenario of the other run. */
    private fun elsewhere(scenario: Scenario): List<String> {
        val before = pistonsOf(this.scenario)
        return pistonsOf(scenario).filter { (face, begin) ->
            before[face]?.let { it != begin } == true
        }.map { (face, _) ->
            "$name: ${WallFacesSpec.KEY}.${WallFacesSpec.NAMES[face]}.motion: the piston goes on from where it is in " +
                "the state, with the speed it has there; position and velocity are not used"
        }
    }

    /** Position and speed of each piston in the state, by face; null where the run does not tell. */
    internal fun pistons(): Map<Int, List<Double>>? {
        CheckpointState(run.directory).meta(state.step)?.let { return it.pistons }
        val series = run.directory.series
        return try {
            SeriesColumns.pistons(series, state)
        } catch (e: IOException) {
            throw InputException("$series", null, "cannot be read: ${reasonOf(e, series)}")
        }
    }

    internal companion object {
        private val OF_STATE = setOf("seed", "particles", "bodies", "placement", "velocities", "spins")
        private val OF_PISTON = Regex("""boundary\.faces\.(\w+)\.motion\.(?:position|velocity)""")

        /** The pistons of [scenario] by face. */
        fun pistonsOf(scenario: Scenario?): Map<Int, List<Double>> = scenario?.boundary?.pistons.orEmpty()
    }
}
