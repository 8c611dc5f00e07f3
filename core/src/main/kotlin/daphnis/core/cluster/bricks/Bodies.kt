package daphnis.core.cluster.bricks

import daphnis.core.cluster.bricks.Cuts.Companion.AXES
import daphnis.core.population.SphereColumns

/**
 * The few spheres that are much larger than the others: moonlets. A cut through what a moonlet touches needs a halo as
 * wide as the moonlet. So cuts keep away from bodies, and where they do, halos need room only for the radii of ordinary
 * spheres.
 */
internal class Bodies {
    private var spheres: SphereColumns? = null

    /** Largest radius of the other spheres. */
    var ordinary = 0.0
        private set

    /** Number of bodies. */
    var size = 0
        private set

    fun position(body: Int, axis: Int): Double = spheres!!.position(axis)[body]

    fun radius(body: Int): Double = spheres!!.radius[body]

    /** Takes over the [bodies], at most [MOST]; other spheres have at most the radius [ordinary]. */
    fun take(bodies: SphereColumns, ordinary: Double) {
        spheres = bodies
        size = bodies.size
        this.ordinary = ordinary
    }

    /**
     * By brick of [territory]: how far beyond its end, along an axis that is cut, the surface of one of its spheres can
     * be at the start of the step. That is the largest radius of its ordinary spheres, or the part of a body that
     * sticks out, if that is more.
     */
    fun edges(territory: Territory): DoubleArray {
        val edges = DoubleArray(territory.size) { ordinary }
        for (body in 0 until size) {
            val brick = territory.ownerOf(position(body, 0), position(body, 1), position(body, 2))
            for (axis in 0 until AXES) {
                if (!territory.cuts.isCut(axis)) continue
                val out = radius(body) - depth(territory, brick, axis, position(body, axis))
                if (out > edges[brick]) edges[brick] = out
            }
        }
        return edges
    }

    /** How far [x] is from the nearer end of [brick] along [axis]. */
    private fun depth(territory: Territory, brick: Int, axis: Int, x: Double): Double {
        val lower = territory.lower(axis, brick)
        val upper = territory.upper(axis, brick)
        // In a part that goes on across the face, positions behind the face are a box lower.
        val here = if (x < lower) x + territory.length(axis) else x
        return minOf(here - lower, upper - here)
    }

    companion object {
        /** In mean radii. */
        const val FACTOR = 3.0

        /** With more of them, they are not bodies but the large ones of a distribution of sizes. */
        const val MOST = 64
    }
}
