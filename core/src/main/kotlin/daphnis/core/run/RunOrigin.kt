package daphnis.core.run

import daphnis.core.collision.GuardSpec
import daphnis.core.force.ForceSpec
import daphnis.core.format.Snapshot
import daphnis.core.format.reasonOf
import daphnis.core.hill.Moon
import daphnis.core.input.InputException
import daphnis.core.scenario.ClockSpec
import daphnis.core.scenario.PlacementSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.Surroundings
import daphnis.core.scenario.TimeStepSpec
import daphnis.core.scenario.WallFacesSpec
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

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
        OF_FORCE.matchEntire(key)?.destructured?.let { (index, own) ->
            val force = scenario?.forces?.getOrNull(index.toInt())
            return force?.carried != null && own in force.keysOfCarried
        }
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
    ) + elsewhere(scenario) + begunAnew(scenario.forces)

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

    /** Which force of the other run, by its index, each of [forces] is that goes on as it, by its own. */
    internal fun goingOn(forces: List<ForceSpec>): Map<Int, Int> {
        val before = scenario?.forces.orEmpty()
        val left = before.indices.filterTo(ArrayList()) { before[it].carried != null }
        return forces.indices.mapNotNull { k ->
            left.find { forces[k].goesOnAs(before[it]) }?.let { k to it.also(left::remove) }
        }.toMap()
    }

    /** Forces with a state of their own that begin anew, and those of the other run that are no more. */
    private fun begunAnew(given: List<ForceSpec>): List<String> {
        val goOn = goingOn(given)
        val anew = given.indices.filter { given[it].carried != null && it !in goOn }.map {
            val keys = given[it].keysOfCarried.joinToString()
            "$name: forces[$it] begins anew; none there had the same $keys"
        }
        val left = scenario?.forces.orEmpty().withIndex().filter { (j, it) -> it.carried != null && j !in goOn.values }
        return anew + left.map { "$name: its forces[${it.index}] is no more" }
    }

    private val checkpoint by lazy {
        try {
            CheckpointState(run.directory).meta(state.step)
        } catch (e: InputException) {
            // It is damaged, and a table may tell.
            null
        }
    }

    /** Position and speed of each piston in the state, by face; null where the run does not tell. */
    internal fun pistons(): Map<Int, List<Double>>? =
        checkpoint?.pistons ?: read(run.directory.series) { SeriesColumns.pistons(it, state) }

    /** What each force carries in the state that carries something, by its index; not where the run does not tell. */
    internal fun forces(): Map<Int, List<Double>> {
        val all = scenario?.forces.orEmpty()
        val carriers = all.indices.filter { all[it].carried != null }
        if (carriers.isEmpty()) return emptyMap()
        if (state.step == 0L) return carriers.associateWith { all[it].carried!! }
        checkpoint?.forces?.takeIf { it.size == carriers.size }?.let { return carriers.zip(it).toMap() }
        val satellites = read(run.directory.bodies) { BodyColumns.satellites(it, state) }
        return carriers.mapNotNull { k ->
            val row = -1 - all.take(k).count { it is Moon }
            satellites[row]?.let { k to it }
        }.toMap()
    }

    /** What is [read] of a table, which has to be as the run wrote it. */
    private fun <T> read(path: Path, read: (Path) -> T): T = try {
        if (Files.exists(path)) {
            RunRecord.of(run.directory).problems(path).firstOrNull()?.let { throw InputException("", null, it) }
        }
        read(path)
    } catch (e: IOException) {
        throw InputException("$path", null, "cannot be read: ${reasonOf(e, path)}")
    }

    internal companion object {
        private val OF_STATE = setOf("seed", "particles", "bodies", "placement", "velocities", "spins")
        private val OF_FORCE = Regex("""forces\[(\d{1,9})]\.(\w+)""")
        private val OF_PISTON = Regex("""boundary\.faces\.(\w+)\.motion\.(?:position|velocity)""")

        /** The pistons of [scenario] by face. */
        fun pistonsOf(scenario: Scenario?): Map<Int, List<Double>> = scenario?.boundary?.pistons.orEmpty()
    }
}
