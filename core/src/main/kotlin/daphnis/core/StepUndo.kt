package daphnis.core

import daphnis.core.collision.CollisionCounters
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population
import daphnis.core.population.SphereQuantity
import daphnis.core.population.optional

/**
 * What a population and its counters were before the step under way, so that the step can be taken back. The engine
 * writes to the population's second set of arrays, so of the first set only the velocities, which forces change, have
 * to be kept. Taking back allocates nothing, calls no other object's code and uses no other thread.
 */
internal class StepUndo(private val population: Population, private val counters: CollisionCounters?) {
    /** Places of the columns that forces change. */
    private val kicked = SphereQuantity.present(population.optional)
        .filter { SphereQuantity.at(it).change == SphereQuantity.Change.KICKED }.toIntArray()
    private val kept = Array(kicked.size) { DoubleArray(0) }
    private var hasVelocities = false
    private val counted = CollisionCounters()

    /** A step begins. */
    fun begin() {
        hasVelocities = false
        if (counters != null) counted.set(counters)
        population.beginStep()
    }

    /**
     * To be called before forces change velocities. Allocates when the size of the population has changed since the
     * last time.
     */
    fun keepVelocities(loop: RangeLoop) {
        val size = population.size
        for (k in kept.indices) if (kept[k].size != size) kept[k] = DoubleArray(size)
        loop.runLight(size) { _, from, to ->
            for (k in kept.indices) population.column(kicked[k]).copyInto(kept[k], from, from, to)
        }
        hasVelocities = true
    }

    /** The step stands. */
    fun commit() {
        population.commitStep()
    }

    /** Restores the state at [begin]. */
    fun takeBack() {
        population.takeStepBack()
        // Indexed as before the step, since the arrays are those from before the step.
        if (hasVelocities) for (k in kept.indices) kept[k].copyInto(population.column(kicked[k]))
        counters?.set(counted)
    }
}
