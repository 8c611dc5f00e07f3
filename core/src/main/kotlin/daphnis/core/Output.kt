package daphnis.core

/**
 * Something that looks at the simulation after every step and writes, draws or sums: the one way out of a run for
 * series, snapshots, progress and whatever a program adds. It must not change the state.
 *
 * An output lives between [open] and [close]. In a run with a directory ([daphnis.core.run.Run]) it may also keep its
 * state in the checkpoint: [save] gives it, [restore] takes it back before [open]. All calls come from the thread that
 * drives the simulation; [close] comes from the thread that closes it, never while another call is under way. An output
 * that is a lambda has [write] only.
 */
public fun interface Output {
    /**
     * Called after each step, and once before the first of a simulation that starts. When it throws in a step of a
     * [Simulation] that was given it, the step is taken back as a whole; if the step is done again, those outputs are
     * asked that have not yet seen it. When it throws in a run, the step stands, the run ends, and its last checkpoint
     * is that from before.
     */
    public fun write(simulation: Simulation)

    /** Called once, before the first [write]. What throws here is thrown on, and [close] is not called. */
    public fun open(simulation: Simulation, opening: Opening) {}

    /** Called when the run has come to its end, after the last [write]; not by a [Simulation] alone. */
    public fun finish(simulation: Simulation) {}

    /**
     * Puts all that the output needs to go on from here into [state], before each checkpoint of a run. What it has
     * written elsewhere by now must be safe when this returns, since the checkpoint vouches for it.
     */
    public fun save(state: OutputState) {}

    /**
     * Takes over what [save] put into [state] in the checkpoint that a run goes on from; not called when that was
     * nothing.
     */
    public fun restore(state: OutputState) {}

    /** Called once at the end, however it came to it, if [open] was. */
    public fun close() {}
}

/** How an output begins. */
public enum class Opening {
    /** At the start of a run: nothing was written before. */
    START,

    /** At a later step of a run: what was written up to there stands. */
    RESUME,
}
