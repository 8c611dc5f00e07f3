package daphnis.core.initial

import daphnis.core.boundary.Box
import daphnis.core.space.Space
import kotlin.math.sqrt

/** Refuses spheres that no search for free places can bring into a box, before a search begins. */
internal object Crowding {
    /**
     * @param walled axes across which whole spheres stay inside
     * @throws PlacementException when [radii] do not fit between walls, or not at random
     */
    fun check(radii: DoubleArray, box: Box, walled: BooleanArray) {
        if (radii.isEmpty()) return
        val largest = radii.max()
        val space = box.space
        for (axis in 0 until space.dimensions) {
            if (walled[axis] && box.length(axis) <= 2 * largest) {
                val name = "xyz"[axis]
                throw PlacementException("a sphere of radius $largest does not fit between the walls along $name")
            }
        }
        val filling = fillingFactor(radii, box)
        if (filling >=
            space.closestPacking
        ) {
            refuse(filling, "${what(space)} fill ${space.closestPacking} at most", space)
        }
        if (radii.any { it != largest }) return
        for (axis in 0..2) if (walled[axis] && !space.isPlane) layer(radii, largest, axis, box, walled)
        val shortest = (0 until space.dimensions).minOf { box.length(it) }
        val isLarge = radii.size >= MANY && shortest >= WIDE * largest
        if (isLarge && filling > if (space.isPlane) JAMMED_DISCS else JAMMED) {
            val jam = if (space.isPlane) "0.547" else "0.384"
            refuse(filling, "equal ${what(space)} at random jam at $jam or before", space)
        }
    }

    /**
     * Between walls less than two diameters apart equal spheres lie beside each other: seen along [axis] they are
     * discs that hardly overlap.
     */
    private fun layer(radii: DoubleArray, radius: Double, axis: Int, box: Box, walled: BooleanArray) {
        val play = box.length(axis) - 2 * radius
        if (play >= 2 * radius) return
        val apart = sqrt(4 * radius * radius - play * play)
        // The margin of half a diameter at walls across the other axes counts too, because discs stick out there.
        val sides = (0..2).filter { it != axis }.map { box.length(it) + if (walled[it]) 2 * radius else 0.0 }
        val covered = radii.size * Math.PI * apart * apart / 4 / (sides[0] * sides[1])
        if (covered >= CLOSEST_DISCS) {
            throw PlacementException(
                "in a layer ${box.length(axis)} thin spheres lie beside each other, and would cover $covered of it; " +
                    "$CLOSEST_DISCS is the most; take fewer, or a thicker box",
            )
        }
    }

    private fun what(space: Space) = if (space.isPlane) "discs" else "spheres"

    private fun refuse(filling: Double, limit: String, space: Space): Nothing = throw PlacementException(
        "the ${if (space.isPlane) "area fraction" else "filling factor"} would be $filling; $limit, " +
            "and random placement reaches about ${reached(space)}; use placement grown or a lattice above that",
    )

    /** What random placement reaches, of equal spheres or discs. */
    fun reached(space: Space): Double = if (space.isPlane) 0.52 else 0.35

    private val CLOSEST_DISCS = Space.PLANE.closestPacking

    /**
     * Random sequential addition jams at 0.384; with the tries allowed here it ends at 0.356 to 0.358. This holds in
     * boxes so large that their sides do not matter.
     */
    private const val JAMMED = 0.365

    /** Discs jam at 0.547 (Torquato, Uche & Stillinger 2006, Phys. Rev. E 74, 061308). */
    private const val JAMMED_DISCS = 0.54
    private const val MANY = 1000
    private const val WIDE = 16
}
