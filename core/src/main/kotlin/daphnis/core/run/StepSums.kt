package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.parallel.InlineLoop
import daphnis.core.population.PopulationSums

/** The [sums] over a population, taken once after a step for any number of outputs. */
internal class StepSums(private val sums: PopulationSums) {
    private var takenAt = -1L

    /** Sums of the state that [simulation] has after its step. */
    fun of(simulation: Simulation): PopulationSums = if (takenAt == simulation.step) sums else take(simulation)

    /** Takes the sums again. */
    fun take(simulation: Simulation): PopulationSums {
        sums.take(simulation.population, simulation.collisions?.engine?.loop ?: InlineLoop)
        takenAt = simulation.step
        return sums
    }
}

/** Whether something that happens every [every] steps, 0 for never, is due after step [step]. */
internal fun isDue(every: Int, step: Long): Boolean = every > 0 && step % every == 0L
