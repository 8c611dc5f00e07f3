package daphnis.core.run

import daphnis.core.Engines
import daphnis.core.Output
import daphnis.core.engine.EngineFactory
import daphnis.core.input.InputException
import java.nio.file.Path
import java.util.function.BooleanSupplier

/**
 * What the run of a scenario can be given when it continues, by name, from [Run.resuming].
 *
 * ```java
 * try (Run run = Run.resuming(path).until(6.0).resume()) {
 *     Summary summary = run.execute();
 * }
 * ```
 */
public class ResumeBuilder internal constructor(private val path: Path) {
    private var until: Double? = null
    private var engines: EngineFactory = Engines
    private val outputs = OwnOutputs()
    private var acceptsLoss = false
    private var cancelled: BooleanSupplier? = null

    /** Ends at [time], in units of time, in place of the scenario's end. */
    public fun until(time: Double): ResumeBuilder = apply { until = time }

    /** Who makes the engine; those of this module unless given. */
    public fun engines(engines: EngineFactory): ResumeBuilder = apply { this.engines = engines }

    /** An output as at the start; it gets back what one of the same [name] saved. */
    public fun output(name: String, output: Output): ResumeBuilder = apply { outputs.add(name, output) }

    /** Continues with damaged tables as they are; [Run.notices] tell what is lost. */
    public fun acceptLoss(): ResumeBuilder = apply { acceptsLoss = true }

    /** What [Run.execute] asks before every step: whether to end the run, with a checkpoint. */
    public fun cancelled(cancelled: BooleanSupplier): ResumeBuilder = apply { this.cancelled = cancelled }

    /**
     * Continues from the last good checkpoint, as [Run.resume] does.
     *
     * @throws InputException when there is no run, no checkpoint can be used, a table is damaged, or the scenario was
     *   changed in a way that makes another run
     *
     * @throws RunException when the directory cannot be written, or an output cannot continue from what it saved
     */
    public fun resume(): Run = Run.resume(path, until, engines, acceptsLoss, outputs.byName).cancelledBy(cancelled)
}
