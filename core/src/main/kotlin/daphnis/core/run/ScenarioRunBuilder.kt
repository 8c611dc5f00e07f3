package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.Output
import daphnis.core.engine.EngineFactory
import daphnis.core.input.InputException
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.ScenarioJson
import daphnis.core.scenario.TimeStepSpec
import java.nio.file.Path
import java.util.function.BooleanSupplier

/**
 * What a run of a scenario can be given, by name, from [Run.builder]; as much as `daphnis run` can. It needs a
 * [directory]. What is given again replaces the former; settings and outputs are added.
 *
 * ```java
 * try (Run run = Run.builder(scenario).directory(path).engine("islands").threads(2).until(3.0).start()) {
 *     Summary summary = run.execute();
 * }
 * ```
 */
public class ScenarioRunBuilder internal constructor(private val scenario: Scenario) {
    private var directory: Path? = null
    private var source = scenario.name
    private val settings = ArrayList<String>()
    private var until: Double? = null
    private var steps: Long? = null
    private var engines: EngineFactory = Engines
    private val outputs = OwnOutputs()
    private var from: RunOrigin? = null
    private var isReplacing = false
    private var cancelled: BooleanSupplier? = null

    /** Where the run is written; made by [start]. */
    public fun directory(path: Path): ScenarioRunBuilder = apply { directory = path }

    /** What to call the scenario in messages; its name unless given. */
    public fun source(source: String): ScenarioRunBuilder = apply { this.source = source }

    /** Replaces a key of the scenario, such as `timeStep.dt=0.05` or `forces[0].x=-167`. */
    public fun set(setting: String): ScenarioRunBuilder = apply { settings += setting }

    /** The engine by its name, in place of the scenario's. */
    public fun engine(name: String): ScenarioRunBuilder = set("engine.name=$name")

    /** Threads of the engine, in place of the scenario's; 0 for one per core, see [daphnis.core.parallel.Cores]. */
    public fun threads(threads: Int): ScenarioRunBuilder = set("engine.threads=$threads")

    /** Who makes the engine; those of this module unless given. */
    public fun engines(engines: EngineFactory): ScenarioRunBuilder = apply { this.engines = engines }

    /** Ends at [time], in units of time, in place of the scenario's end. */
    public fun until(time: Double): ScenarioRunBuilder = apply { until = time }

    /** Ends after [steps] steps, which must be of fixed length. */
    public fun steps(steps: Long): ScenarioRunBuilder = apply { this.steps = steps }

    /** A further output, which is called after those given before; what it saves is found again by its [name]. */
    public fun output(name: String, output: Output): ScenarioRunBuilder = apply { outputs.add(name, output) }

    /** Starts from a state of another run, see [Run.start]. */
    public fun from(origin: RunOrigin): ScenarioRunBuilder = apply { from = origin }

    /** Replaces a run that is in the directory. */
    public fun replace(): ScenarioRunBuilder = apply { isReplacing = true }

    /** What [Run.execute] asks before every step: whether to end the run, with a checkpoint. */
    public fun cancelled(cancelled: BooleanSupplier): ScenarioRunBuilder = apply { this.cancelled = cancelled }

    /**
     * Makes the directory and the initial state, as [Run.start] does.
     *
     * @throws IllegalArgumentException without a directory, or with both [until] and [steps]
     * @throws InputException for wrong input; what was in the directory is as it was
     * @throws RunException when the directory cannot be written
     */
    public fun start(): Run {
        val path = requireNotNull(directory) { NO_DIRECTORY }
        require(until == null || steps == null) {
            "until(…) and steps(…) both say where the run ends; give one of them"
        }
        val changed = if (settings.isEmpty()) scenario else ScenarioJson.changed(scenario, source, settings)
        return Run.start(withEnd(changed), source, path, isReplacing, engines, outputs.byName, from)
            .cancelledBy(cancelled)
    }

    private fun withEnd(scenario: Scenario): Scenario {
        until?.let { return scenario.copy(until = it) }
        val steps = steps ?: return scenario
        if (steps < 1) throw InputException("steps", null, "is $steps; it must be at least 1", isArgument = true)
        val step = FrameSetup.times(scenario.copy(until = 1.0), source).timeStep.dt
            ?: throw InputException("steps", null, "needs a fixed time step; give an end", isArgument = true)
        return scenario.copy(until = (from?.state?.time ?: scenario.startTime) + steps * step)
    }
}

/** Outputs by name, each name once. */
internal class OwnOutputs {
    val byName = LinkedHashMap<String, Output>()

    fun add(name: String, output: Output) {
        require(byName.putIfAbsent(name, output) == null) { "two outputs are called '$name'; each needs its own name" }
    }
}

internal fun Run.cancelledBy(given: BooleanSupplier?): Run = apply { if (given != null) cancelled = given }

internal const val NO_DIRECTORY = "the run has no directory; give directory(…)"
