package daphnis.core.cluster.bricks

/**
 * How much wider than its sight the halo of each brick is: room for chains of collisions. A chain reaches about a
 * diameter for each collision of a sphere, measured in gases and rings of every density. The estimate decides only how
 * often a step is redone.
 *
 * A brick starts with [DIAMETERS] mean diameters and [PER_COLLISION] for each collision of a sphere in a step. After a
 * redo it keeps the wider halo, which then shrinks by two per cent per step, not below the start. A redo costs a step
 * of the brick, which is more than some per cent of halo, so too wide is better than too narrow.
 *
 * @param diameters least width in mean diameters
 * @param perCollision the same for each collision of a sphere in a step
 */
internal class HaloMargins(
    private val diameters: Double = DIAMETERS,
    private val perCollision: Double = PER_COLLISION,
) {
    private var extra = DoubleArray(0)

    /** Mean diameter of the spheres, in units of length. */
    var diameter = 0.0

    /** Collisions per sphere in the last step. */
    var collisionsPerSphere = 0.0

    /** What a brick starts with. */
    val least: Double get() = diameter * (diameters + perCollision * collisionsPerSphere)

    /** Forgets what [bricks] bricks needed: there is another territory. */
    fun reset(bricks: Int) {
        extra = DoubleArray(bricks)
    }

    /** The extra widths with which the next step begins, by brick. */
    fun next(): DoubleArray {
        val least = least
        for (k in extra.indices) extra[k] = maxOf(least, extra[k] * SHRINK)
        return extra.copyOf()
    }

    /** Keeps the extra widths with which a step ended. */
    fun keep(widths: HaloWidths) {
        for (k in extra.indices) extra[k] = widths.extra(k)
    }

    /** The extra width to try after [extra] was too small in [attempt]. It grows fast, so that there is an end. */
    fun widened(extra: Double, attempt: Int): Double = maxOf(extra * if (attempt == 0) WIDER else MUCH_WIDER, diameter)

    companion object {
        const val DIAMETERS = 3.0
        const val PER_COLLISION = 1.35
        private const val SHRINK = 0.98
        private const val WIDER = 1.5
        private const val MUCH_WIDER = 3.0
    }
}
