package daphnis.core.engine.bricks

import daphnis.core.engine.bricks.Cuts.Companion.AXES
import kotlin.math.ln

/**
 * Estimates how long a step takes with a division of space, and chooses the best. It decides only how long a step
 * takes.
 *
 * A sphere costs the more the more rows a brick has, since they leave the cache: measured at φ = 0.45, 0.8 µs per
 * collision in bricks of 5e4 spheres and fewer, 1.5 in one of 1e5, 3.1 in one of 4e5; in dilute systems the search goes
 * through memory in order, and half as much is lost. Spheres in halos are computed twice.
 *
 * @param spheres number of all
 * @param threads that compute
 * @param collisionsPerSphere in a step
 * @param shares by axis, the part of the spheres within one halo's width of one plane; 0 or less where it cannot be cut
 * @param periodic by axis
 */
internal class BrickCost(
    private val spheres: Int,
    private val threads: Int,
    private val collisionsPerSphere: Double,
    private val shares: DoubleArray,
    private val periodic: BooleanArray,
) {
    /** The division with the least [time]; [BrickDivision.ONE] when none is clearly better than one brick. */
    fun best(): BrickDivision {
        var best = BrickDivision.ONE
        var least = time(best) * CLEARLY
        for (x in choices(0)) {
            for (y in choices(1)) {
                for (z in choices(2)) {
                    if (!isSensible(x * y * z)) continue
                    val division = BrickDivision(x, y, z)
                    val time = time(division)
                    if (time < least) {
                        least = time
                        best = division
                    }
                }
            }
        }
        return best
    }

    private fun choices(axis: Int): IntArray = if (shares[axis] > 0) COUNTS else IntArray(1) { 1 }

    private fun isSensible(bricks: Int): Boolean =
        bricks in 2..MOST_BRICKS && (bricks <= threads || spheres / bricks >= LEAST_SPHERES)

    /** Estimated time of a step, in units of that of a sphere in a small system. */
    fun time(division: BrickDivision): Double {
        var copies = 1.0
        for (axis in 0 until AXES) copies *= copies(axis, division.along(axis))
        val bricks = division.bricks
        val rows = spheres * copies / bricks
        // The busiest thread; with several bricks for each, a free one takes the next.
        val turns = (bricks + threads - 1) / threads
        return turns * rows * (1 + slowdown() * maxOf(0.0, ln(rows / CACHED) / ln(2.0))) + bricks * rows * HAND_OVER
    }

    /** In how many bricks a sphere is on average, along [axis] alone. */
    private fun copies(axis: Int, parts: Int): Double {
        if (parts == 1) return 1.0
        val planes = if (periodic[axis]) parts else parts - 1
        return minOf(parts.toDouble(), 1 + 2 * planes * shares[axis])
    }

    /** How much more a sphere costs with each doubling of the rows. */
    private fun slowdown(): Double = DILUTE + (DENSE - DILUTE) * minOf(1.0, collisionsPerSphere)

    private companion object {
        val COUNTS = intArrayOf(1, 2, 3, 4, 5, 6, 8, 10, 12, 16)
        const val MOST_BRICKS = 128
        const val LEAST_SPHERES = 4000

        /** Rows that the cache holds well enough. */
        const val CACHED = 25_000.0
        const val DILUTE = 0.25
        const val DENSE = 0.5

        /** Cost of what is not done in parallel, or twice, as a part of that of a sphere. */
        const val HAND_OVER = 0.01
        const val CLEARLY = 0.95
    }
}
