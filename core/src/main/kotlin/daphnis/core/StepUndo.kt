package daphnis.core

import daphnis.core.collision.CollisionCounters
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.Population

/**
 * What a population and its counters were before the step under way, so that the step can be taken back. The engine
 * writes to the population's second set of arrays, so of the first set only the velocities, which forces change, have
 * to be kept. Taking back allocates nothing, calls no other object's code and uses no other thread.
 */
internal class StepUndo(private val population: Population, private val counters: CollisionCounters?) {
    private var vx = DoubleArray(0)
    private var vy = DoubleArray(0)
    private var vz = DoubleArray(0)
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
        if (vx.size != size) vx = DoubleArray(size)
        if (vy.size != size) vy = DoubleArray(size)
        if (vz.size != size) vz = DoubleArray(size)
        loop.runLight(size) { _, from, to ->
            population.vx.copyInto(vx, from, from, to)
            population.vy.copyInto(vy, from, from, to)
            population.vz.copyInto(vz, from, from, to)
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
        if (hasVelocities) {
            vx.copyInto(population.vx)
            vy.copyInto(population.vy)
            vz.copyInto(population.vz)
        }
        counters?.set(counted)
    }
}
