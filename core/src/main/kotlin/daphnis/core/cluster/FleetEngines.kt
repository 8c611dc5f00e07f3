package daphnis.core.cluster

import daphnis.core.Steps
import daphnis.core.engine.CollisionEngine
import daphnis.core.engine.CollisionForcing
import daphnis.core.engine.EngineFactory
import daphnis.core.force.SelfGravity
import daphnis.core.parallel.ClosableLoop
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.scenario.InputException
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
    private val fleet: Fleet,
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

    override val names: List<String> get() = listOf(NAME)

    override fun create(name: String, threads: Int): CollisionEngine = create()

    internal fun create(): CollisionEngine = FleetEngine(fleet, patience, log, copies)

    internal companion object {
        const val NAME = "cluster"
    }
}

/**
 * Stands for the nodes in a simulation. It does not advance a population itself: that is what [steps] are for. Its
 * threads are those of this process, for sums.
 */
internal class FleetEngine(
    private val fleet: Fleet,
    private val patience: Duration,
    private val log: Consumer<String>,
    private val copies: CopyClock,
) : CollisionEngine {
    private val handler = FixedPool(Runtime.getRuntime().availableProcessors())
    private val gate = ClosableLoop(ParallelLoop(handler, LoopStrategy.DYNAMIC), CollisionEngine.CLOSED)
    private var made: NodeSteps? = null
    override val name: String get() = FleetEngines.NAME
    override val loop: RangeLoop get() = gate

    /** Threads of the nodes that compute; 0 before the first step. */
    override val threads: Int
        get() = made?.threads ?: 0

    override fun advance(step: daphnis.core.step.CollisionStep): Unit =
        throw UnsupportedOperationException("nodes advance runs of scenarios only")

    /**
     * The steps of the run of [setup], from [state] at [time] after [step].
     *
     * @throws InputException for a force that needs all spheres in one place
     */
    fun steps(
        setup: ScenarioSetup,
        source: String,
        state: Population,
        forcing: CollisionForcing,
        time: Double,
        step: Long,
    ): Steps {
        requireShareable(setup, source)
        val steps = NodeSteps(fleet, setup, state, forcing, time, step, patience, copies) { log.accept(it) }
        return steps.also { made = it }
    }

    private fun requireShareable(setup: ScenarioSetup, source: String) {
        if (setup.forces.none { it is SelfGravity }) return
        throw InputException(
            source,
            "forces",
            "has self-gravity, which nodes cannot compute yet; run it on one machine",
        )
    }

    override fun close() {
        gate.close()
        handler.close()
        fleet.close()
    }
}
