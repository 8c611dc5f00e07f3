package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.isChanging
import daphnis.core.boundary.roomAt
import daphnis.core.boundary.roomIn
import daphnis.core.format.Snapshot
import daphnis.core.initial.PlacementException
import daphnis.core.initial.SeededRandom
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import daphnis.core.wall.RoomSide

/**
 * Makes the population from which a scenario starts. Sizes, places and velocities are drawn from separate streams, so
 * that changing one does not change the others.
 *
 * @param boundary what it is at the start
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
    /**
     * Where spheres can be at the start: walls that move may not be at the faces of the box then, and a box that changes
     * is not what it is on average.
     */
    private val room = when {
        boundary.walls.any { it.motion != null } -> roomAtStart()
        boundary.isChanging -> boundary.box
        else -> box
    }

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
        placement.file?.let { file ->
            return FileState(scenario, boundary, file, check, materials.names, start).population(notices) {
                stream(SPINS)
            }
        }
        val spec =
            scenario.particles ?: check.fail("particles", "is missing; it is needed unless the placement is a file")
        val kinds = SphereKind.of(spec, box.space, check)
        val areProportions = placement.pressure != null
        val drawn = DrawnRadii(spec, kinds, box, check, areProportions, boundary.roomIn(box)) { stream(SIZES) }.draw()
        var radii = drawn.radii
        check.must("bodies[0]", scenario.bodies.isEmpty() || !boundary.isChanging) {
            "is a body; with boundary.perturbation > 0 there can be none, as a body would meet its images as they breathe"
        }
        val bodies = Bodies(scenario.bodies, spec, box.space, check).apply { checkRoom(boundary) }
        val placed = try {
            checkRadii(radii)
            val amount = spec.amount(radii.size)
            val all = SpheresToPlace(
                scenario, boundary, room, bodies, radii, isPlaced, amount, check, notices,
            ) { stream(PLACES) }
            placement.place(all)
        } catch (e: PlacementException) {
            val (key, value) = spec.amount(radii.size)
            check.fail("particles.$key", "is $value; ${e.message}")
        }
        val positions = placed.positions
        if (placement.pressure != null) radii = DoubleArray(radii.size) { radii[it] * placed.factor }
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
        for ((k, surface) in boundary.walls.surfaces.withIndex()) {
            val most = radii.max()
            val fits = surface.fits(most)
            check.that("$SURFACES[$k].radius", surface.radius, fits) {
                "must exceed that of the largest sphere, $most"
            }
        }
    }

    private fun ParticlesSpec.amount(all: Int): Pair<String, Any> = when {
        fillingFactor != null -> "fillingFactor" to fillingFactor
        opticalDepth != null -> "opticalDepth" to opticalDepth
        surfaceDensity != null -> "surfaceDensity" to surfaceDensity
        count != null -> "count" to count
        else -> "materials" to "$all spheres"
    }

    private fun stream(purpose: Long) = SeededRandom(scenario.seed * STREAMS + purpose)

    companion object {
        const val STREAMS = 4L

        private const val SIZES = 0L
        const val PLACES = 1L
        private const val VELOCITIES = 2L
        private const val SPINS = 3L
    }
}
