package daphnis.core.run

import daphnis.core.Simulation

/** Watches a run from outside. */
public fun interface RunObserver {
    /** Called after every step, in the thread of the run. [wallSeconds] since the run (or its resume) began. */
    public fun afterStep(simulation: Simulation, until: Double, wallSeconds: Double)
}
