package daphnis.core.cluster

import daphnis.core.RemoteSteps
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.EngineFactory
import daphnis.core.population.Population
import daphnis.core.scenario.ScenarioSetup
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

    /** The steps of the run of [setup], from [state] at [time] after [step]. */
    internal fun steps(
        setup: ScenarioSetup,
        state: Population,
        forcing: CollisionForcing,
        time: Double,
        step: Long,
    ): RemoteSteps = NodeSteps(fleet, setup, state, forcing, time, step, patience, copies) { log.accept(it) }
}
