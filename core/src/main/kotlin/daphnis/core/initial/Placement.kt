@file:JvmName("FillingFactor")

package daphnis.core.initial

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box

/** Where spheres are put at the start. */
public fun interface Placement {
    /**
     * @param radii radius by sphere
     * @param box where to put them; finite
     * @param walled axes (x, y, z) whose faces are walls, where whole spheres must stay inside; the other axes are
     *   taken as periodic
     * @throws PlacementException when they do not fit
     */
    public fun place(radii: DoubleArray, box: Box, walled: BooleanArray, random: SeededRandom): Positions
}

/** Positions by sphere. */
public class Positions(public val x: DoubleArray, public val y: DoubleArray, public val z: DoubleArray)

/** The spheres do not fit into the box in the way asked for. */
public class PlacementException(message: String) : RuntimeException(message)

/** Filling factor: volume of the spheres over the volume of [box]; in a flat one the area fraction of discs. */
@JvmName("of")
public fun fillingFactor(radii: DoubleArray, box: Box): Double {
    var volume = 0.0
    for (r in radii) volume += box.space.volume(r)
    return volume / box.volume
}

/** The same in the room of [boundary]. */
@JvmName("of")
public fun fillingFactor(radii: DoubleArray, boundary: BoundaryConditions): Double {
    var volume = 0.0
    for (r in radii) volume += boundary.space.volume(r)
    return volume / boundary.volume
}
