package daphnis.core.source

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.initial.SeededRandom
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.random.CounterRandom

/**
 * Spheres come into a simulation and leave it, at the end of each step, when forces have acted: first by the first of
 * [all], and so on. What is drawn follows from [seed], the place in the list and the time at the end of the step, and
 * nothing else, so it is the same in every engine, on every node and in a run that is resumed. Those that come get the
 * ids above the highest that is there.
 *
 * A simulation of its own needs its own: this holds the sums of the step under way.
 */
public class Sources(public val all: List<Source>, private val seed: Long) {
    private val random = CounterRandom(seed)

    /** What came and left in the last step; on a node, of its own spheres. */
    internal val sums = SourceSums(all.size)

    /** The greatest radius of what may come; 0 where nothing does. */
    public val largest: Double get() = all.maxOfOrNull { it.largest } ?: 0.0

    /**
     * All act on [population] at the [end] of a step of [duration] inside of [boundary].
     *
     * @param inertia moment of inertia of spheres over mass · radius²
     */
    internal fun act(
        population: Population,
        partition: Partition,
        boundary: BoundaryConditions,
        end: Double,
        duration: Double,
        inertia: Double,
    ) {
        sums.clear()
        for ((k, source) in all.withIndex()) {
            random.draw(k, end, STREAM)
            val drawn = SeededRandom(random.word(0).toLong() shl Int.SIZE_BITS or (random.word(1).toLong() and WORD))
            source.act(SourceStep(k, population, partition, boundary, end, duration, inertia, drawn, sums))
        }
    }

    private companion object {
        const val WORD = 0xffffffffL

        /** Keeps these numbers apart from those of thermal walls and of pieces. */
        const val STREAM = 3
    }
}
