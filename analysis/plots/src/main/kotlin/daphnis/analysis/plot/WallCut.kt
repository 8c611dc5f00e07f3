package daphnis.analysis.plot

import daphnis.analysis.insitu.State

/**
 * What lies behind the surfaces around a [state], in a cut through the middle of its box along the line of sight. The
 * picture has the axis [across] to the right and [up] up.
 */
internal class WallCut(private val state: State, private val across: Int, private val up: Int) {
    private val surfaces = state.boundary.walls.surfaces
    private val at = state.boundary.box.let { box -> DoubleArray(3) { (box.lower(it) + box.upper(it)) / 2 } }

    /** Whether there are none. */
    val isEmpty: Boolean get() = surfaces.isEmpty()

    /** Whether a place of the picture, in lengths, is behind one. Not for two threads at once. */
    fun isBehind(right: Double, above: Double): Boolean {
        at[across] = right
        at[up] = above
        return surfaces.any { it.distance(at[0], at[1], at[2], state.time) < 0 }
    }
}
