package daphnis.core.initial

import daphnis.core.boundary.Box
import daphnis.core.parallel.FixedPool
import daphnis.core.parallel.InlineLoop
import daphnis.core.parallel.LoopStrategy
import daphnis.core.parallel.ParallelLoop
import daphnis.core.parallel.RangeLoop
import daphnis.core.space.Space
import daphnis.core.wall.Wall

/**
 * Random sequential addition: spheres, the largest first, go to uniform random places until one is free. Reaches
 * filling factors near 0.35 for equal spheres (the process jams at 0.384, and the tries per sphere grow fast below
 * that), and 0.52 for discs in a flat box (0.547).
 *
 * Places are drawn and judged in blocks, see [CandidateBlock]. The result is that of one try after the other, bit for
 * bit, for any number of threads and any size of block.
 *
 * A search ends if it finds no place for one sphere, or too few for all. Impossible fillings are refused before, see
 * [Crowding], others after a bounded number of tries.
 *
 * @param mostTries tries for one sphere before giving up
 * @param obstacles spheres that are already placed
 * @param threads threads to look for free places on, the caller's included; the others are told to end before
 *   [place] returns, and not waited for
 */
public class RandomPlacement internal constructor(
    private val mostTries: Int,
    private val obstacles: List<Obstacle>,
    private val threads: Int,
    private val blockSize: Int?,
    private val leastForThreads: Int,
    private val vainPerSphere: Long = VAIN_PER_SPHERE,
) : Placement {
    @JvmOverloads
    public constructor(mostTries: Int = MOST_TRIES, obstacles: List<Obstacle> = emptyList(), threads: Int = 1) :
        this(mostTries, obstacles, threads, null, LEAST_FOR_THREADS)

    private var surfaces: List<Wall> = emptyList()
    private var time = 0.0

    /** From now on whole spheres stay inside of [surfaces] too, as these are at [time]. @return this */
    @JvmOverloads
    public fun within(surfaces: List<Wall>, time: Double = 0.0): RandomPlacement {
        this.surfaces = surfaces
        this.time = time
        return this
    }

    /**
     * @throws PlacementException also when the largest sphere does not fit between walls, or the filling is one that no
     *   random placement has
     */
    override fun place(radii: DoubleArray, box: Box, walled: BooleanArray, random: SeededRandom): Positions {
        Crowding.check(radii, box, walled)
        val order = largestFirst(radii)
        val space = OccupiedSpace(radii, order, box, walled, obstacles)
        val size = blockSize ?: (radii.size / BLOCKS).coerceIn(SMALLEST_BLOCK, LARGEST_BLOCK)
        val block = CandidateBlock(space, box, walled, minOf(size, maxOf(1, radii.size)))
        if (threads == 1 || radii.size < leastForThreads) {
            fill(space, block, size, radii.size, random, InlineLoop, box.space)
        } else {
            FixedPool(threads).use {
                fill(space, block, size, radii.size, random, ParallelLoop(it, LoopStrategy.DYNAMIC), box.space)
            }
        }
        val positions = Positions(DoubleArray(radii.size), DoubleArray(radii.size), DoubleArray(radii.size))
        for (rank in order.indices) {
            positions.x[order[rank]] = space.coordinate(rank, 0)
            positions.y[order[rank]] = space.coordinate(rank, 1)
            positions.z[order[rank]] = space.coordinate(rank, 2)
        }
        return positions
    }

    private fun fill(
        space: OccupiedSpace,
        block: CandidateBlock,
        size: Int,
        spheres: Int,
        random: SeededRandom,
        loop: RangeLoop,
        within: Space,
    ) {
        var rank = 0
        var tries = 0
        var vain = 0L
        val mostVain = vainPerSphere * maxOf(spheres, FEW)
        while (rank < spheres) {
            // Never more candidates than spheres left: otherwise numbers would be drawn that one try after the other
            // would not draw.
            val count = sameOctave(space, rank, minOf(size, spheres - rank))
            block.draw(count, random)
            block.judge(rank, count, loop)
            for (c in 0 until count) {
                if (accept(space, block, c, rank)) {
                    rank++
                    tries = 0
                } else {
                    if (++tries == mostTries) {
                        refuse(
                            "no free place found for a sphere of radius ${space.radius(rank)} in $mostTries tries",
                            within,
                        )
                    }
                    if (++vain == mostVain) {
                        refuse("$rank of $spheres spheres found a place in $mostVain tries and more", within)
                    }
                }
            }
        }
    }

    private fun refuse(what: String, space: Space): Nothing {
        val reached = "random placement reaches a filling factor of about ${Crowding.reached(space)}"
        // Lattices are of whole boxes.
        val around = listOfNotNull(
            "between the walls".takeIf { surfaces.isNotEmpty() },
            "around bodies".takeIf { obstacles.isNotEmpty() },
        )
        val wayOut = if (around.isEmpty()) {
            "$reached, use a lattice above that"
        } else {
            "the room ${around.joinToString(" and ")} has no place for more; $reached, take fewer or smaller ones"
        }
        throw PlacementException("$what; $wayOut")
    }

    /** How many spheres from [rank] on, at most [limit], share an octave. */
    private fun sameOctave(space: OccupiedSpace, rank: Int, limit: Int): Int {
        val largest = space.octaveFor(space.radius(rank)).largest
        var count = limit
        while (largest > 2 * space.radius(rank + count - 1)) count--
        return count
    }

    /** Puts the sphere of [rank] where candidate [c] is, if that is free. */
    private fun accept(space: OccupiedSpace, block: CandidateBlock, c: Int, rank: Int): Boolean {
        val verdict = block.verdict(c)
        if (verdict == Verdict.TAKEN) return false
        val radius = space.radius(rank)
        val x = block.coordinate(c, 0, radius)
        val y = block.coordinate(c, 1, radius)
        val z = block.coordinate(c, 2, radius)
        for (k in surfaces.indices) if (surfaces[k].distance(x, y, z, time) < radius) return false
        if (verdict == Verdict.OPEN && !space.isFree(x, y, z, radius)) return false
        space.add(rank, x, y, z)
        return true
    }

    private companion object {
        const val MOST_TRIES = 200_000

        /**
         * Failed tries per sphere, averaged over all: a bound on the work. Equal spheres at 0.35 take 610, power laws
         * at 0.55 take 30.
         */
        const val VAIN_PER_SPHERE = 1000L

        /** Fewer spheres may take as many tries as these. */
        const val FEW = 10_000

        /** Least number of blocks in a placement: the larger a block, the more of its candidates overlap each other. */
        const val BLOCKS = 32
        const val SMALLEST_BLOCK = 256
        const val LARGEST_BLOCK = 8192

        /** Below some ten milliseconds of work the threads are not worth their start. */
        const val LEAST_FOR_THREADS = 20_000
    }
}

/** A sphere that others are placed around; its images along axes without walls count too. */
public class Obstacle(public val x: Double, public val y: Double, public val z: Double, public val radius: Double)
