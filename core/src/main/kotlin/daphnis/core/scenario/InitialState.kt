package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.RoomSide
import daphnis.core.boundary.hasMovingWalls
import daphnis.core.boundary.roomAt
import daphnis.core.boundary.roomIn
import daphnis.core.compression.GrownPlacement
import daphnis.core.compression.GrownSpheres
import daphnis.core.format.Snapshot
import daphnis.core.initial.Crowding
import daphnis.core.initial.Lattice
import daphnis.core.initial.LatticePlacement
import daphnis.core.initial.PlacementException
import daphnis.core.initial.Positions
import daphnis.core.initial.RandomPlacement
import daphnis.core.initial.SeededRandom
import daphnis.core.initial.fillingFactor
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population

/**
 * Makes the population from which a scenario starts. Sizes, places and velocities are drawn from separate streams, so
 * that changing one does not change the others.
 *
 * @param start the state to start from, in place of the placement's file
 */
internal class InitialState(
    private val scenario: Scenario,
    private val box: Box,
    private val boundary: BoundaryConditions,
    private val check: ValueCheck,
    private val materials: Materials,
    private val start: Snapshot? = null,
) {
    /** Where spheres can be at the start: walls that move may not be at the faces of the box then. */
    private val room = if (boundary.hasMovingWalls) roomAtStart() else box

    private fun roomAtStart(): Box = try {
        boundary.roomAt(scenario.startTime)
    } catch (e: IllegalArgumentException) {
        check.fail(WallFacesSpec.KEY, "puts walls beyond one another at the start: ${e.message}")
    }

    /** What a user should know about the state made, one line each. */
    val notices = ArrayList<String>()

    /** @param isPlaced false for spheres that are placed at random to be all in the middle, which costs nothing */
    fun population(isPlaced: Boolean = true): Population {
        val placement = scenario.placement
        if (placement is PlacementSpec.File) {
            return FileState(scenario, boundary, placement, check, materials.names, start).population(notices) {
                stream(SPINS)
            }
        }
        val spec =
            scenario.particles ?: check.fail("particles", "is missing; it is needed unless the placement is a file")
        val kinds = SphereKind.of(spec, box.space, check)
        val areProportions = (placement as? PlacementSpec.Grown)?.pressure != null
        val drawn = DrawnRadii(spec, kinds, box, check, areProportions, boundary.roomIn(box)) { stream(SIZES) }.draw()
        var radii = drawn.radii
        val bodies = Bodies(scenario.bodies, spec, box.space, check).apply { checkRoom(boundary) }
        val positions = try {
            check.must("placement", boundary.surfaces.isEmpty() || placement is PlacementSpec.Random) {
                "must be random, or a file, in a room with boundary.surfaces"
            }
            checkRadii(radii)
            if (placement is PlacementSpec.Lattice) {
                check.must("bodies", scenario.bodies.isEmpty()) { "need random placement, which goes around them" }
                val lattice = lattice(placement)
                val places = lattice.place(radii, room, walled(), stream(PLACES))
                lattice.remark(radii, room, walled())?.let { notices += "placement: $it" }
                places
            } else if (placement is PlacementSpec.Grown) {
                check.must("bodies", scenario.bodies.isEmpty()) { "need random placement, which goes around them" }
                val grown = GrownPlacement(scenario.engine.threadsAtStart)
                val pressure = placement.pressure
                if (pressure != null) {
                    val spheres = atPressure(grown, pressure, spec.amount(radii.size), radii, isPlaced)
                    radii = DoubleArray(radii.size) { radii[it] * spheres.factor }
                    spheres.positions
                } else if (isPlaced) {
                    grown.place(
                        radii,
                        room,
                        walled(),
                        stream(PLACES),
                    )
                } else {
                    grown.middle(radii, room, walled())
                }
            } else if (!isPlaced) {
                Crowding.check(radii, room, walled())
                Positions(DoubleArray(radii.size), DoubleArray(radii.size), DoubleArray(radii.size))
            } else {
                RandomPlacement(
                    obstacles = bodies.obstacles,
                    threads = scenario.engine.threadsAtStart,
                ).within(boundary.surfaces, scenario.startTime).place(radii, room, walled(), stream(PLACES))
            }
        } catch (e: PlacementException) {
            val (key, value) = spec.amount(radii.size)
            check.fail("particles.$key", "is $value; ${e.message}")
        }
        for (kind in kinds) kind.checkMass()
        val masses = DoubleArray(radii.size) { kinds[drawn.kinds[it]].mass(radii[it]) }
        val velocities = InitialVelocities(scenario, boundary, check).draw(masses, positions, stream(VELOCITIES))
        val flow = boundary.meanFlow
        val smooth = Population(
            positions.x + bodies.position(0),
            positions.y + bodies.position(1),
            positions.z + bodies.position(2),
            velocities[0] + bodies.velocity(0, flow),
            velocities[1] + bodies.velocity(1, flow),
            velocities[2] + bodies.velocity(2, flow),
            radii + bodies.radius,
            masses + bodies.mass,
        )
        val made = if (materials.names.isEmpty()) {
            smooth
        } else {
            smooth.withMaterial(drawn.kinds + materials.ofBodies(), materials.names)
        }
        return InitialSpins(scenario, boundary, check).drawn(made, scenario.bodies.size, stream(SPINS))
    }

    private fun checkRadii(radii: DoubleArray) {
        for ((k, surface) in boundary.surfaces.withIndex()) {
            val most = radii.max()
            val fits = surface.side == RoomSide.OUTSIDE || surface.radius > most
            check.that("${WallSurfaceSpec.KEY}[$k].radius", surface.radius, fits) {
                "must exceed that of the largest sphere, $most"
            }
        }
    }

    /** Spheres that have grown to [pressure], or without being placed some that have not begun to. */
    private fun atPressure(
        grown: GrownPlacement,
        pressure: Double,
        amount: Pair<String, Any>,
        radii: DoubleArray,
        isPlaced: Boolean,
    ): GrownSpheres {
        check.that("placement.pressure", pressure, pressure > 1 && pressure < MOST_PRESSURE) {
            "must be > 1, that of an ideal gas, and < $MOST_PRESSURE"
        }
        check.must("particles.${amount.first}", amount.first == "count" || amount.first == "materials") {
            "follows from placement.pressure, at which radii are not known before; give count"
        }
        if (!isPlaced) return GrownSpheres(grown.middle(radii.size), grown.looseFor(pressure, radii, room))
        val spheres = grown.placeAtPressure(pressure, radii, room, walled(), stream(PLACES))
        val filling = fillingFactor(DoubleArray(radii.size) { radii[it] * spheres.factor }, room)
        notices += "placement.pressure is $pressure: radii are ${spheres.factor} times those of particles.sizes, and " +
            "the filling factor is $filling"
        return spheres
    }

    private fun ParticlesSpec.amount(all: Int): Pair<String, Any> = when {
        fillingFactor != null -> "fillingFactor" to fillingFactor
        opticalDepth != null -> "opticalDepth" to opticalDepth
        surfaceDensity != null -> "surfaceDensity" to surfaceDensity
        count != null -> "count" to count
        else -> "materials" to "$all spheres"
    }

    private fun stream(purpose: Long) = SeededRandom(scenario.seed * STREAMS + purpose)

    private fun lattice(spec: PlacementSpec.Lattice): LatticePlacement {
        check.that("placement.vacancies", spec.vacancies, spec.vacancies >= 0 && spec.vacancies < 1) {
            "must be a share of the sites, at least 0 and less than 1"
        }
        val lattice = (spec.lattice ?: densestLattice(box.space)).lattice
        check.must("placement.lattice", lattice.isPlane == box.space.isPlane) {
            if (lattice.isPlane) {
                "is of discs, which need dimensions 2"
            } else {
                "is of spheres; with dimensions 2 it must be hexagonal or square"
            }
        }
        return LatticePlacement(lattice, spec.vacancies)
    }

    /** Along axes on which the box does not repeat, a sphere is placed wholly inside. */
    private fun walled(): BooleanArray = BooleanArray(3) { !boundary.repeats(it) }

    companion object {
        const val STREAMS = 4L

        /** Spheres that grow take long to come to it, and nothing changes on the way. */
        private const val MOST_PRESSURE = 1000.0
        private const val SIZES = 0L
        const val PLACES = 1L
        private const val VELOCITIES = 2L
        private const val SPINS = 3L
    }
}
