package daphnis.core.boundary

import daphnis.core.hill.Epicycle
import daphnis.core.hill.HillSheet
import daphnis.core.hill.Satellite
import daphnis.core.hill.SatelliteSurface
import daphnis.core.population.MeanFlow

/** A boundary of a user's own, as short as they come: walls across z, Lees–Edwards in the plane. */
class ShearedChannel(override val box: Box, rate: Double) : PerSphereBoundary {
    override val meanFlow = MeanFlow(normalAxis = 1, flowAxis = 0, rate = rate)
    override val shear = ImageShear(box, meanFlow)

    override val walls = Walls.faces(box, 1.0, 2)

    override fun contactFaces(axis: Int) = if (axis == 2) ContactFaces.WALL else ContactFaces.PERIODIC
}

/** A boundary that is held against the contract. */
class Contracted(val name: String, val conditions: BoundaryConditions) {
    /** Axes whose faces bring spheres back. */
    val wrapped = (0..2).filter { conditions.repeats(it) }

    override fun toString() = name
}

/** Every boundary there is, each in boxes around the origin, beside it, at its corner, tiny and huge. */
fun everyBoundary(): List<Contracted> = listOf(
    "centred" to Box.centred(10.0, 8.0, 6.0),
    "away from the origin" to Box(-3.25, 1.5, -20.0, 7.5, 9.0, -14.0),
    "from the origin" to Box(0.0, 0.0, 0.0, 10.0, 8.0, 6.0),
    "to the origin" to Box(-10.0, -8.0, -6.0, 0.0, 0.0, 0.0),
    "tiny" to Box.centred(1e-30, 2e-30, 3e-30),
    "huge" to Box.centred(3e30, 1e30, 2e30),
).flatMap { (place, box) -> boundariesOf(box).map { Contracted("${it.name}, box $place", it.conditions) } }

private fun boundariesOf(box: Box): List<Contracted> {
    val moon = Satellite(1.0, Epicycle(1e40, 0.0, 0.0, 0.0), 0.31)
    return listOf(
        Contracted("open", Open),
        Contracted("walls", Walls(box)),
        Contracted("walls across y", Walls(box, 0.5, booleanArrayOf(false, true, false))),
        Contracted("periodic", Periodic(box)),
        Contracted("periodic along y alone", Periodic(box, periodicX = false, periodicZ = false)),
        Contracted("sheared periodic", ShearedPeriodic(box, 0.4 * box.length(1))),
        Contracted("Lees–Edwards", LeesEdwards(box, 0.5)),
        Contracted("Lees–Edwards, backward", LeesEdwards(box, -1.3)),
        Contracted("Lees–Edwards at rest", LeesEdwards(box, 0.0)),
        Contracted("Hill's sheet", HillSheet(box, 0.31)),
        Contracted("Hill's sheet, radially open", HillSheet(box, 0.31, radiallyOpen = true)),
        Contracted("Hill's sheet with a moon", SatelliteSurface(HillSheet(box, 0.31), moon, radius = 1e-40)),
        Contracted("a user's channel", ShearedChannel(box, 0.7)),
    )
}
