package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.PartialSums
import daphnis.core.population.Population
import java.nio.ByteBuffer

/**
 * The potential energies of a population in those of [forces] that are a [PerSphereEnergy], as exact sums: threads and
 * machines take parts, in any order, and merge them. Made once; allocates nothing of its own once warm.
 */
internal class EnergySums(forces: List<Force>, private val boundary: BoundaryConditions) {
    // In the order in which a simulation has them.
    private val all = forces.filterIsInstance<PerSphereEnergy>().sortedBy { it is Drift }
    private val summed = all.filter { it.hasPotentialEnergy(boundary) }
    private val sums = PartialSums(summed.size) { from, to, into, block ->
        for (e in summed.indices) {
            block.addBlocks(from, to, into[e]) { start, end, terms ->
                summed[e].potentialEnergies(population!!, time, start, end, terms)
            }
        }
    }
    private var population: Population? = null
    private var time = 0.0

    /** Whether the energy in [force] is among these. */
    fun have(force: Force): Boolean = all.any { it === force }

    /** The energy in [force], which these [have]; NaN where it has none. */
    fun of(force: Force): Double {
        for (k in summed.indices) if (summed[k] === force) return sums.value(k)
        return Double.NaN
    }

    /** Makes these the energies of no spheres. */
    fun clear() = sums.clear()

    /** Takes the sums over [population] at [time] on the threads of [loop]. */
    fun take(population: Population, time: Double, loop: RangeLoop) {
        this.population = population
        this.time = time
        try {
            sums.take(population.size, loop)
        } finally {
            this.population = null
        }
    }

    /** Adds the sums of [other], which are of the same forces, or of as many others like them. */
    fun merge(other: EnergySums) = sums.merge(other.sums)

    /** Bytes of the longest that are written. */
    val mostBytes: Int get() = sums.mostBytes

    /** Writes the sums in at most [mostBytes], for [read] by one made of the same forces. */
    fun write(into: ByteBuffer) = sums.write(into)

    /**
     * Makes these the sums that [write] has written.
     *
     * @throws IllegalArgumentException for bytes that are no such sums; then these are the energies of no spheres
     */
    fun read(from: ByteBuffer) = sums.read(from)
}
