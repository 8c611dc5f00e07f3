@file:JvmName("TimeSteps")

package daphnis.core

import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.MeanFlow
import daphnis.core.population.Population
import kotlin.math.abs

/**
 * Chooses the length of the next step. Must be a pure function of the population, so that a resumed run chooses the
 * same length, and must not depend on the order of its arrays. A time step which looks at every sphere should be a
 * [PerSphereTimeStep].
 */
public fun interface TimeStep {
    /** @return the length of a step that starts with [population], > 0, in units of time */
    public fun next(population: Population): Double
}

/**
 * A step whose length depends on one number to which every sphere contributes, such as the greatest speed. Different
 * threads or machines measure parts of a population. The results are combined in any order and give the same bits.
 */
public interface PerSphereTimeStep : TimeStep {
    /**
     * The number for the spheres of [population] at the indices [from] until [to]; for an empty range the neutral
     * element of [combine].
     */
    public fun measure(population: Population, from: Int, to: Int): Double

    /**
     * The number for two parts together. Neither the order of the two nor that of several calls may change a bit. A
     * maximum satisfies this; a plain sum does not.
     */
    public fun combine(one: Double, other: Double): Double

    /** @return the length of a step that starts with a population for which the number is [measured] */
    public fun next(measured: Double): Double

    override fun next(population: Population): Double = next(measure(population, InlineLoop))
}

/** The number for all of [population], measured by the threads of [loop]. */
public fun PerSphereTimeStep.measure(population: Population, loop: RangeLoop): Double {
    val lock = Any()
    var measured = measure(population, 0, 0)
    loop.run(population.size) { _, from, to ->
        val part = measure(population, from, to)
        synchronized(lock) { measured = combine(measured, part) }
    }
    return measured
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
    PerSphereTimeStep {
    init {
        require(fraction > 0 && fraction.isFinite()) { "fraction of a cell is $fraction; it must be > 0" }
        require(cell > 0 && cell.isFinite()) { "cell is $cell; it must be > 0" }
        require(longest > 0 && longest.isFinite()) { "longest dt is $longest; it must be > 0" }
    }

    /** The greatest velocity along any axis. */
    override fun measure(population: Population, from: Int, to: Int): Double {
        var fastest = 0.0
        for (k in from until to) {
            fastest = maxOf(fastest, maxOf(abs(population.vx[k]), abs(population.vy[k]), abs(population.vz[k])))
        }
        return fastest
    }

    override fun combine(one: Double, other: Double): Double = maxOf(one, other)

    override fun next(measured: Double): Double =
        if (measured * longest <= fraction * cell) longest else fraction * cell / measured
}

/**
 * Steps within which the fastest sphere moves by no more than [path] along any axis relative to the mean flow, for
 * systems in which no force acts: there the length of a step is no physics, and only decides how much work there is. A
 * system that cools gets longer steps.
 *
 * @property path a length, such as a part of the mean free path
 * @property longest a time that no step exceeds
 * @property flow the mean flow that a boundary drives; null for none
 */
public class FreePathTimeStep(
    public val path: Double,
    public val longest: Double,
    public val flow: MeanFlow?,
    override val stops: Stops,
) : PerSphereTimeStep,
    StoppingTimeStep {
    init {
        require(path > 0 && path.isFinite()) { "the path of a step is $path; it must be > 0" }
        require(longest > 0 && longest.isFinite()) { "longest dt is $longest; it must be > 0" }
    }

    /** The greatest velocity along any axis, relative to the mean flow. */
    override fun measure(population: Population, from: Int, to: Int): Double {
        var fastest = 0.0
        val across = flow?.let { population.position(it.normalAxis) }
        for (axis in 0..2) {
            val velocity = population.velocity(axis)
            val rate = if (across != null && axis == flow.flowAxis) flow.rate else 0.0
            for (k in from until to) {
                val mean = if (rate == 0.0) 0.0 else rate * across!![k]
                fastest = maxOf(fastest, abs(velocity[k] - mean))
            }
        }
        return fastest
    }

    override fun combine(one: Double, other: Double): Double = maxOf(one, other)

    override fun next(measured: Double): Double = minOf(longest, path / measured)

    override fun next(population: Population): Double = super.next(population)
}
