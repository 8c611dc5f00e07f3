package daphnis.core.population

/** The means around which second moments are taken, weighted by mass, and the slabs across the flow. */
internal class Means {
    /** Mean position. */
    val position = DoubleArray(3)

    /** Mean velocity without the straight flow of the boundary's rate. */
    val velocity = DoubleArray(3)

    /** Number of slabs. */
    var slabCount = 1
        private set
    private var least = 0.0
    private var perSlab = 0.0

    /** Slabs for [count] particles between [least] and [greatest]. */
    fun setSlabs(count: Int, least: Double, greatest: Double) {
        slabCount = (count / FlowFit.SPHERES_A_SLAB).coerceIn(1, FlowFit.MOST_SLABS)
        this.least = least
        perSlab = if (greatest > least) slabCount / (greatest - least) else 0.0
    }

    /** The slab of a particle at [position] across the flow. */
    fun slab(position: Double): Int = minOf(slabCount - 1, ((position - least) * perSlab).toInt())
}
