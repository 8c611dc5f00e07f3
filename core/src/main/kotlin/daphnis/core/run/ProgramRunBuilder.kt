package daphnis.core.run

import daphnis.core.input.InputException
import java.nio.file.Path
import java.util.function.BooleanSupplier

/**
 * What a run of a [Program] can be given, by name, from [Run.builder]. It needs a [directory].
 *
 * ```java
 * try (Run run = Run.builder(program).directory(path).replace().start()) {
 *     Summary summary = run.execute();
 * }
 * ```
 */
public class ProgramRunBuilder internal constructor(private val program: Program) {
    private var directory: Path? = null
    private var isReplacing = false
    private var acceptsLoss = false
    private var cancelled: BooleanSupplier? = null

    /** Where the run is written. */
    public fun directory(path: Path): ProgramRunBuilder = apply { directory = path }

    /** [start] replaces a run that is in the directory. */
    public fun replace(): ProgramRunBuilder = apply { isReplacing = true }

    /** [resume] continues with damaged tables as they are; [Run.notices] tell what is lost. */
    public fun acceptLoss(): ProgramRunBuilder = apply { acceptsLoss = true }

    /** What [Run.execute] asks before every step: whether to end the run, with a checkpoint. */
    public fun cancelled(cancelled: BooleanSupplier): ProgramRunBuilder = apply { this.cancelled = cancelled }

    /**
     * Makes the directory and the initial state, as [Run.start] does.
     *
     * @throws IllegalArgumentException without a directory, with [acceptLoss], or for a simulation that is not as
     *   [Program.simulation] requires
     *
     * @throws InputException when the directory is in use or holds something else, which is as it was then
     * @throws RunException when the directory cannot be written
     */
    public fun start(): Run {
        require(!acceptsLoss) { "acceptLoss() is for a run that continues; start() begins one" }
        return Run.start(program, path(), isReplacing).cancelledBy(cancelled)
    }

    /**
     * Continues from the last good checkpoint, as [Run.resume] does.
     *
     * @throws IllegalArgumentException without a directory, with [replace], or for a simulation that is not as
     *   [Program.simulation] requires
     *
     * @throws InputException when there is no run of this program and version, no checkpoint can be used, or a table is
     *   damaged
     *
     * @throws RunException when the directory cannot be written, or an output cannot continue from what it saved
     */
    public fun resume(): Run {
        require(!isReplacing) { "replace() is for a run that starts; resume() continues the one that is there" }
        return Run.resume(program, path(), acceptsLoss).cancelledBy(cancelled)
    }

    private fun path() = requireNotNull(directory) { NO_DIRECTORY }
}
