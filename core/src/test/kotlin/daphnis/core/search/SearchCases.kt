package daphnis.core.search

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.LeesEdwards
import daphnis.core.boundary.Open
import daphnis.core.boundary.Periodic
import daphnis.core.boundary.Walls
import daphnis.core.initial.SeededRandom
import daphnis.core.space.Images

/** One of five boundaries, around a box whose sides are at most [longest]. */
internal fun drawnBoundary(random: SeededRandom, longest: Double): BoundaryConditions {
    val box = Box.centred(
        random.nextDouble(4.0, longest),
        random.nextDouble(4.0, longest),
        random.nextDouble(2.1, longest),
    )
    val all = listOf(
        Open,
        Periodic(box),
        Periodic(box, true, true, false),
        Walls(box),
        LeesEdwards(box, random.nextDouble(-1.0, 1.0)),
    )
    return all[random.nextInt(all.size)]
}

/** The images of a sphere through the periodic faces of [boundary], up to [far] boxes away along each axis. */
internal fun imagesWithin(far: Int, boundary: BoundaryConditions): List<Int> {
    val range = List(3) { axis -> if (boundary.contactFaces(axis) == ContactFaces.PERIODIC) -far..far else 0..0 }
    return range[0].flatMap { x -> range[1].flatMap { y -> range[2].map { z -> Images.code(x, y, z) } } }
}
