package daphnis.core

import daphnis.core.population.Population
import kotlin.math.abs

/**
 * Chooses the length of the next step. Must be a pure function of the population, so that a resumed run chooses the
 * same.
 */
public fun interface TimeStep {
    /** @return the length of a step that starts with [population], > 0, in units of time */
    public fun next(population: Population): Double
}

/** Every step is [duration] long. */
public class FixedTimeStep(public val duration: Double) : TimeStep {
    init {
        require(duration > 0 && duration.isFinite()) { "dt is $duration; it must be > 0" }
    }

    override fun next(population: Population): Double = duration
}

/**
 * Steps so short that the fastest sphere crosses no more than [fraction] of [cell] along any axis, and never longer
 * than [longest].
 *
 * @property cell the length that counts as a cell, such as the mean distance between spheres
 */
public class CellCrossingTimeStep(public val fraction: Double, public val cell: Double, public val longest: Double) :
    TimeStep {
    init {
        require(fraction > 0 && fraction.isFinite()) { "fraction of a cell is $fraction; it must be > 0" }
        require(cell > 0 && cell.isFinite()) { "cell is $cell; it must be > 0" }
        require(longest > 0 && longest.isFinite()) { "longest dt is $longest; it must be > 0" }
    }

    override fun next(population: Population): Double {
        var fastest = 0.0
        for (k in 0 until population.size) {
            fastest = maxOf(fastest, maxOf(abs(population.vx[k]), abs(population.vy[k]), abs(population.vz[k])))
        }
        return if (fastest * longest <= fraction * cell) longest else fraction * cell / fastest
    }
}
