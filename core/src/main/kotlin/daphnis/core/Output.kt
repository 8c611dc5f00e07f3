package daphnis.core

/** Something that looks at the simulation after every step and writes, draws or sums. It must not change the state. */
public fun interface Output {
    /**
     * Called after each step, and once before the first. When it throws, the step is taken back as a whole; if the step
     * is done again, those outputs are asked that have not yet seen it.
     */
    public fun write(simulation: Simulation)
}
