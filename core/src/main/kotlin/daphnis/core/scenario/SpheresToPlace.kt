package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.compression.GrownPlacement
import daphnis.core.compression.GrownSpheres
import daphnis.core.initial.ChainPlacement
import daphnis.core.initial.Crowding
import daphnis.core.initial.Lattice
import daphnis.core.initial.LatticePlacement
import daphnis.core.initial.Positions
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.initial.fillingFactor
import daphnis.core.input.ValueCheck
import daphnis.core.space.Space

/** Spheres and where they are; their radii are [factor] times those that were to be placed. */
public class PlacedSpheres @JvmOverloads constructor(public val positions: Positions, public val factor: Double = 1.0)

/**
 * Spheres of [radii] for which a placement finds places in the [room] of a [scenario].
 *
 * @property isPlaced false for spheres that are placed at random to be all in the middle, which costs nothing
 * @param amount the key that says how many spheres there are, and its value
 */
public class SpheresToPlace internal constructor(
    private val scenario: Scenario,
    private val boundary: BoundaryConditions,
    private val room: Box,
    private val bodies: Bodies,
    public val radii: DoubleArray,
    public val isPlaced: Boolean,
    private val amount: Pair<String, Any>,
    public val check: ValueCheck,
    private val notices: MutableList<String>,
    private val random: () -> SeededRandom,
) {
    /** Space in which they are. */
    public val space: Space get() = room.space

    /** Along axes on which the box does not repeat, a sphere is placed wholly inside. */
    private val walled = BooleanArray(3) { !boundary.repeats(it) }
    private val grown by lazy { GrownPlacement(scenario.engine.threadsAtStart) }

    /** For a placement that goes neither around bodies nor within surfaces. */
    internal fun refuseObstacles() {
        check.must("placement", boundary.walls.surfaces.isEmpty()) {
            "must be random, or a file, in a room with boundary.surfaces"
        }
        check.must("bodies", scenario.bodies.isEmpty()) { "need random placement, which goes around them" }
    }

    internal fun atRandom(): Positions {
        if (!isPlaced) {
            Crowding.check(radii, room, walled)
            return grown.middle(radii.size)
        }
        scenario.bonds?.let { bonds ->
            refuseObstacles()
            return ChainPlacement(bonds.length, bonds.middle).place(radii, room, walled, random())
        }
        val placement = RandomPlacement(obstacles = bodies.obstacles, threads = scenario.engine.threadsAtStart)
        return placement.within(boundary.walls.surfaces, scenario.startTime).place(radii, room, walled, random())
    }

    internal fun onLattice(lattice: Lattice, vacancies: Double): Positions {
        check.must("placement.lattice", lattice.isPlane == space.isPlane) {
            if (lattice.isPlane) {
                "is of discs, which need dimensions 2"
            } else {
                "is of spheres; with dimensions 2 it must be hexagonal or square"
            }
        }
        val placement = LatticePlacement(lattice, vacancies)
        val places = placement.place(radii, room, walled, random())
        placement.remark(radii, room, walled)?.let { notices += "placement: $it" }
        return places
    }

    internal fun grown(): Positions =
        if (isPlaced) grown.place(radii, room, walled, random()) else grown.middle(radii, room, walled)

    /** Spheres that have grown to [pressure], or without being placed some that have not begun to. */
    internal fun grownTo(pressure: Double): PlacedSpheres {
        check.that("placement.pressure", pressure, pressure > 1 && pressure < MOST_PRESSURE) {
            "must be > 1, that of an ideal gas, and < $MOST_PRESSURE"
        }
        check.must("particles.${amount.first}", amount.first == "count" || amount.first == "materials") {
            "follows from placement.pressure, at which radii are not known before; give count"
        }
        if (!isPlaced) return PlacedSpheres(grown.middle(radii.size), grown.looseFor(pressure, radii, room))
        val spheres: GrownSpheres = grown.placeAtPressure(pressure, radii, room, walled, random())
        val filling = fillingFactor(DoubleArray(radii.size) { radii[it] * spheres.factor }, room)
        notices += "placement.pressure is $pressure: radii are ${spheres.factor} times those of particles.sizes, and " +
            "the filling factor is $filling"
        return PlacedSpheres(spheres.positions, spheres.factor)
    }

    private companion object {
        /** Spheres that grow take long to come to it, and nothing changes on the way. */
        const val MOST_PRESSURE = 1000.0
    }
}
