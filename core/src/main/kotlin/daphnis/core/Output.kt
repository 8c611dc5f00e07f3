package daphnis.core

/**
 * Something that looks at the simulation after every step and writes, draws or sums. Series, snapshots, progress and
 * whatever a program adds leave a run in this one way. It must not change the state.
 *
 * An output lives between [open] and [close]. In a run with a directory ([daphnis.core.run.Run]) it may also keep its
 * state in the checkpoint: [save] gives it, [restore] takes it back before [open]. All calls come from the thread that
 * drives the simulation; [close] comes from the thread that closes it, never while another call is under way. An output
 * given as a lambda has [write] only.
 *
 * A run writes its own files on a further thread, so a snapshot or a row of a step may reach the disk after later steps
 * were shown to this output.
 *
 * An exception from any of these functions ends a run, with a [daphnis.core.run.RunException] that names the output and
 * the step and has it as its cause. A [Simulation] alone passes it on as it is.
 */
public fun interface Output {
    /**
     * Called after each step, and once before the first of a simulation that starts. When it throws in a step of a
     * [Simulation] which owns it, the whole step is taken back. If the step is done again, only the outputs that have
     * not yet seen it are called. When it throws in a run, the step stands and the run ends; the last checkpoint is the
     * one from before.
     */
    public fun write(simulation: Simulation)

    /**
     * Called before the first [write]. When it throws, the output is not open: [close] is not called for it, and a
     * [Simulation] that is advanced again calls this again. After it has returned it is not called again.
     */
    public fun open(simulation: Simulation, opening: Opening) {}

    /** Called when the run has come to its end, after the last [write]. A [Simulation] alone does not call it. */
    public fun finish(simulation: Simulation) {}

    /**
     * Puts everything that the output needs to continue from here into [state]. Called before each checkpoint of a run.
     * What the output has written elsewhere must be safe when this returns, since the checkpoint relies on it.
     */
    public fun save(state: OutputState) {}

    /**
     * Takes over what [save] put into [state] in the checkpoint from which a run continues. Not called when [save] put
     * nothing.
     */
    public fun restore(state: OutputState) {}

    /** Called once at the end, whatever ended the run, provided that [open] has returned. */
    public fun close() {}
}

/** How an output starts. */
public enum class Opening {
    /** At the start of a run: nothing was written before. */
    START,

    /** At a later step of a run: what was written up to there stands. */
    RESUME,
}
