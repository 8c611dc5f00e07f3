package daphnis.core.engine.islands

/**
 * How many potential collisions a window should hold: many, so that there are few barriers, but so few that islands
 * seldom grow into one another. Learnt from how many islands had to be processed again. Any length gives the same bits.
 *
 * @param least the smallest window, as a share of all spheres
 * @param most the largest one, as a share; beyond it islands have to be compared with too many other islands
 * @param leastSeeds potential collisions that a window may hold whatever the share
 */
internal class WindowLength(
    private val least: Double = 0.001,
    private val most: Double = 0.015,
    private val leastSeeds: Int = 16,
) {
    private var share = FIRST_SHARE.coerceIn(least, most)

    /** Potential collisions for a window among [spheres] spheres. */
    fun seeds(spheres: Int): Int = maxOf(leastSeeds, (share * spheres).toInt())

    /** To be told that [redone] of the [islands] processed in a window had to be processed again. */
    fun learn(islands: Int, redone: Int) {
        if (redone > islands * MOST_REDONE) {
            share = maxOf(share * SHORTER, least)
        } else if (redone < islands * FEW_REDONE) {
            share = minOf(share * LONGER, most)
        }
    }

    private companion object {
        const val FIRST_SHARE = 0.01
        const val MOST_REDONE = 0.1
        const val FEW_REDONE = 0.03
        const val SHORTER = 0.7
        const val LONGER = 1.1
    }
}
