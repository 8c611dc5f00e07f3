package daphnis.core.run

import daphnis.core.Output
import daphnis.core.Simulation
import daphnis.core.population.Population
import daphnis.core.scenario.OutputSpec

/**
 * A program's own simulation, with laws, forces, boundary and outputs that no scenario file knows, for a run directory
 * with checkpoints: [Run.start] and [Run.resume].
 *
 * A checkpoint holds the population, time, step, counters and what outputs save. Everything else comes from here, is
 * made anew at each resume, and must be the same then. A force that has a state of its own can keep it as an [Output]
 * among [outputs], through [Output.save] and [Output.restore].
 */
public interface Program {
    /** The name of the run in the summary; kept in `run.json`. */
    public val name: String

    /** To be changed with every change that would make another run; a checkpoint of another version is refused. */
    public val version: String

    /** Time at which the run ends. May be different at a resume. */
    public val until: Double

    /**
     * How often each of the usual files is written. The collision log and transport require that collisions are
     * recorded.
     */
    public val output: OutputSpec get() = OutputSpec()

    /** Spheres with this id or a higher one are bodies, which sums over the particles leave out. */
    public val firstBody: Int get() = Int.MAX_VALUE

    /** The population at the start of the run. */
    public fun population(): Population

    /**
     * The simulation of [population], at its first step and without outputs, at the start and at each resume. The run
     * sets it to the time of the checkpoint, and closes it.
     */
    public fun simulation(population: Population): Simulation

    /**
     * Further outputs by name, in the order in which they are called, made anew at the start and at each resume. What
     * they save is found again by name.
     */
    public fun outputs(): Map<String, Output> = emptyMap()
}
