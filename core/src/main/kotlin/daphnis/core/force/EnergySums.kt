package daphnis.core.force

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import daphnis.core.population.ExactSum
import daphnis.core.population.Population
import daphnis.core.population.SphereSum
import daphnis.core.population.Workers
import java.nio.ByteBuffer

/**
 * The potential energies of a population in those of [forces] that are a [PerSphereEnergy], as exact sums: threads and
 * machines take parts, in any order, and merge them. Made once; allocates nothing of its own once warm.
 */
internal class EnergySums(forces: List<Force>, private val boundary: BoundaryConditions) {
    // In the order in which a simulation has them.
    private val all = forces.filterIsInstance<PerSphereEnergy>().sortedBy { it is Drift }
    private val summed = all.filter { it.hasPotentialEnergy(boundary) }
    private val sums = Array(summed.size) { ExactSum() }

    // Worker 0 adds to the sums, each other one to sums of its own.
    private val blocks = Workers { SphereSum() }
    private val others = Workers { Array(summed.size) { ExactSum() } }
    private var population: Population? = null
    private var time = 0.0
    private val add = RangeBody { worker, from, to -> addRange(worker, from, to) }

    /** Whether the energy in [force] is among these. */
    fun have(force: Force): Boolean = all.any { it === force }

    /** The energy in [force], which these [have]; NaN where it has none. */
    fun of(force: Force): Double {
        for (k in summed.indices) if (summed[k] === force) return sums[k].value()
        return Double.NaN
    }

    /** Makes these the energies of no spheres. */
    fun clear() {
        for (sum in sums) sum.clear()
    }

    /** Takes the sums over [population] at [time] on the threads of [loop]. */
    fun take(population: Population, time: Double, loop: RangeLoop) {
        clear()
        blocks.upTo(loop.workers)
        others.upTo(loop.workers - 1)
        for (k in 0 until others.count) for (sum in others[k]) sum.clear()
        this.population = population
        this.time = time
        try {
            if (summed.isNotEmpty()) loop.run(population.size, body = add)
        } finally {
            this.population = null
        }
        for (k in 0 until others.count) for (e in sums.indices) sums[e].add(others[k][e])
    }

    private fun addRange(worker: Int, from: Int, to: Int) {
        val into = if (worker == 0) sums else others[worker - 1]
        for (e in summed.indices) {
            blocks[worker].addBlocks(from, to, into[e]) { start, end, terms ->
                summed[e].potentialEnergies(population!!, time, start, end, terms)
            }
        }
    }

    /** Adds the sums of [other], which are of the same forces, or of as many others like them. */
    fun merge(other: EnergySums) {
        check(other.sums.size == sums.size) { "energies in ${other.sums.size} forces, and in ${sums.size}" }
        for (k in sums.indices) sums[k].add(other.sums[k])
    }

    /** Bytes of the longest that are written. */
    val mostBytes: Int get() = sums.size * ExactSum.MOST_BYTES

    /** Writes the sums in at most [mostBytes], for [read] by one made of the same forces. */
    fun write(into: ByteBuffer) {
        for (sum in sums) sum.write(into)
    }

    /**
     * Makes these the sums that [write] has written.
     *
     * @throws IllegalArgumentException for bytes that are no such sums; then these are the energies of no spheres
     */
    fun read(from: ByteBuffer) {
        try {
            for (sum in sums) sum.read(from)
        } catch (e: IllegalArgumentException) {
            clear()
            throw e
        }
    }
}
