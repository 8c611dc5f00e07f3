package daphnis.core.population

import daphnis.core.parallel.RangeBody
import daphnis.core.parallel.RangeLoop
import java.nio.ByteBuffer

/**
 * Some exact sums over the spheres of a population that threads and machines take in parts, in any order, and merge.
 * Made once; allocates nothing of its own once warm.
 *
 * @param add adds the terms of a range of spheres to sums
 */
internal class PartialSums(count: Int, private val add: PartialTerms) {
    private val sums = Array(count) { ExactSum() }

    // Worker 0 adds to the sums, each other one to sums of its own.
    private val blocks = Workers { SphereSum() }
    private val others = Workers { Array(count) { ExactSum() } }
    private val addRange = RangeBody { worker, from, to ->
        add.add(from, to, if (worker == 0) sums else others[worker - 1], blocks[worker])
    }

    /** Number of sums. */
    val count: Int get() = sums.size

    /** The sum number [k]. */
    fun value(k: Int): Double = sums[k].value()

    /** Makes these the sums of no spheres. */
    fun clear() {
        for (sum in sums) sum.clear()
    }

    /** Takes the sums over [size] spheres on the threads of [loop]. */
    fun take(size: Int, loop: RangeLoop) {
        clear()
        blocks.upTo(loop.workers)
        others.upTo(loop.workers - 1)
        for (k in 0 until others.count) for (sum in others[k]) sum.clear()
        if (sums.isNotEmpty()) loop.run(size, body = addRange)
        for (k in 0 until others.count) for (e in sums.indices) sums[e].add(others[k][e])
    }

    /** Adds the sums of [other], which are as many. */
    fun merge(other: PartialSums) {
        check(other.count == count) { "$count sums, and ${other.count}" }
        for (k in sums.indices) sums[k].add(other.sums[k])
    }

    /** Makes these the sums over all parts of [partition], each of which does so. */
    fun mergeAll(partition: Partition) = partition.merge(sums)

    /** Bytes of the longest that are written. */
    val mostBytes: Int get() = count * ExactSum.MOST_BYTES

    /** Writes the sums in at most [mostBytes], for [read] by one of as many. */
    fun write(into: ByteBuffer) {
        for (sum in sums) sum.write(into)
    }

    /**
     * Makes these the sums that [write] has written.
     *
     * @throws IllegalArgumentException for bytes that are no such sums; then these are the sums of no spheres
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

/** What spheres add to [PartialSums]. */
internal fun interface PartialTerms {
    /** Adds the terms of the spheres at the indices [from] until [to] to [into], with [block] of the worker's own. */
    fun add(from: Int, to: Int, into: Array<ExactSum>, block: SphereSum)
}
