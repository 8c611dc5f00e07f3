package daphnis.core.cluster

import daphnis.core.RemoteSteps
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.EngineFactory
import daphnis.core.force.MutualGravity
import daphnis.core.force.RadialGravity
import daphnis.core.input.InputException
import daphnis.core.population.Population
import daphnis.core.scenario.ScenarioSetup
import daphnis.core.scenario.WallFacesSpec
import java.time.Duration
import java.util.function.Consumer

/**
 * Lets a run of a scenario be computed by the nodes of [fleet], whatever engine the scenario names. Given to
 * [Run.start][daphnis.core.run.Run.start] or [Run.resume][daphnis.core.run.Run.resume]. For one run, which closes the
 * fleet.
 *
 * ```
 * Run.start(scenario, "ring.json", path, engines = FleetEngines(fleet)).use { it.execute() }
 * ```
 *
 * @param patience how long to wait for another node when none is left
 * @param log is told, in a line each, what a user should know, such as the loss of a node
 */
public class FleetEngines internal constructor(
    internal val fleet: Fleet,
    private val patience: Duration,
    private val log: Consumer<String>,
    private val copies: CopyClock,
) : EngineFactory {
    @JvmOverloads
    public constructor(
        fleet: Fleet,
        patience: Duration = Duration.ofSeconds(60),
        log: Consumer<String> = Consumer { },
    ) : this(fleet, patience, log, CopyClock())

    override val names: List<String> get() = emptyList()

    /** None: nodes compute, in place of the engines of this process. */
    override fun create(name: String, threads: Int): CollisionEngine? = null

    /**
     * The steps of the run of [setup], from [state] at [time] after [step].
     *
     * @throws InputException for a force that needs all spheres in one place, for spheres that grow, and for a piston
     */
    internal fun steps(
        setup: ScenarioSetup,
        source: String,
        state: Population,
        forcing: CollisionForcing,
        time: Double,
        step: Long,
    ): RemoteSteps {
        if (!setup.boundary.walls.areKnownAhead) {
            throw InputException(
                source,
                WallFacesSpec.KEY,
                "has a piston, which nodes do not move yet; run it on one machine",
            )
        }
        if (setup.boundary.growth != null) {
            throw InputException(source, "growth", "is not computed by nodes yet; run it on one machine")
        }
        if (setup.forces.any { it is MutualGravity && it !is RadialGravity }) {
            val mend = "has self-gravity, which nodes cannot compute yet; run it on one machine, or take radial-modes"
            throw InputException(source, "forces", mend)
        }
        return NodeSteps(fleet, setup, state, forcing, time, step, patience, copies) { log.accept(it) }
    }
}
