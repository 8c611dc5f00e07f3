package daphnis.core

/** Something that looks at the simulation after every step and writes, draws or sums. It must not change the state. */
public fun interface Output {
    /** Called after each step, and once before the first. */
    public fun write(simulation: Simulation)
}
