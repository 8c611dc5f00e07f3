package daphnis.core.compression

/**
 * The mean of the reduced pressure of growing spheres over their last collisions: steps are weighted by their growth,
 * and one counts e times less after [collisions] more.
 */
internal class PressureWindow(private val collisions: Double) {
    private var weighted = 0.0
    private var weight = 0.0
    private var counted = 0.0

    /** NaN before the first step that tells one. */
    val mean: Double get() = weighted / weight

    /** Whether there have been so many collisions that the mean is worth something. */
    val isFull: Boolean get() = counted > FULL * collisions

    /**
     * Takes in a step with [count] collisions in which radii grew by the part [growth] at the [pressure]; NaN is left
     * out.
     */
    fun add(pressure: Double, growth: Double, count: Long) {
        if (pressure.isNaN()) return
        val fade = StrictMath.exp(-count / collisions)
        weighted = weighted * fade + pressure * growth
        weight = weight * fade + growth
        counted = counted * fade + count
    }

    private companion object {
        const val FULL = 0.6
    }
}
