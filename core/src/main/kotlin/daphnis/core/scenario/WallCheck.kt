package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.WallMotion
import daphnis.core.boundary.WallSurface
import daphnis.core.boundary.leastRoom
import daphnis.core.boundary.pistons
import daphnis.core.boundary.planesApart
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import kotlin.math.abs
import kotlin.math.sqrt

/** Checks that walls and spheres can go on together until [end]: room, cycles and falls in a step, masses of pistons. */
internal class WallCheck(
    private val scenario: Scenario,
    private val population: Population,
    private val boundary: BoundaryConditions,
    private val check: ValueCheck,
    private val end: Double,
) {
    /** The walls across [axis], in a step of [duration], with spheres of radius [largest]. */
    fun check(axis: Int, largest: Double, duration: Double) {
        checkMotion(axis, largest, duration)
        checkFall(axis, duration)
    }

    private fun checkMotion(axis: Int, largest: Double, duration: Double) {
        val motions = (0..1).mapNotNull { boundary.wallMotion(2 * axis + it) }
        if (motions.isEmpty()) return
        for (motion in motions) checkCycles(motion, duration, "a wall across ${"xyz"[axis]}")
        checkRoom(axis, largest)
    }

    /** The motions of surfaces in a step of [duration]. */
    fun checkSurfaceMotions(duration: Double) {
        for ((n, surface) in boundary.surfaces.withIndex()) {
            surface.face.motion?.let { checkCycles(it, duration, "$SURFACES[$n]") }
        }
    }

    /** The distance of a sphere from [surface] at [key] is a small difference of large numbers where that is far. */
    fun checkDigits(key: String, surface: WallSurface) {
        val radius = if (surface.radius.isFinite()) surface.radius else 0.0
        val farthest = maxOf(radius, surface.origin.maxOf { abs(it) })
        val least = population.radius.minOrNull() ?: return
        check.must(key, Math.ulp(farthest) <= StartCheck.TOLERANCE * least) {
            "a $surface, has lengths of $farthest, to which distances are known to ${Math.ulp(
                farthest,
            )} only; that must " +
                "be at most ${StartCheck.TOLERANCE} of the smallest radius, $least; take nearer points, or a plane"
        }
    }

    private fun checkCycles(motion: WallMotion, duration: Double, wall: String) {
        val cycles = ((motion as? WallMotion.Periodic)?.frequency ?: 0.0) * duration
        check.must("timeStep", cycles <= MOST_CYCLES) {
            "is so long that $wall has $cycles cycles in a step; take a smaller dt"
        }
    }

    /** What a run that goes on needs too, as it may go on for longer than was checked at its start. */
    fun checkRooms() {
        checkPistons()
        val largest = population.radius.maxOrNull() ?: return
        for (axis in 0 until boundary.space.dimensions) checkRoom(axis, largest)
        checkPlanes(largest)
    }

    /** Planes that come near to each other. */
    fun checkPlanes(largest: Double) {
        for (walls in boundary.planesApart(scenario.startTime, end)) {
            check.must(walls.first, walls.apart > 2 * largest) {
                "comes as near to ${walls.second} as ${walls.apart}; that must exceed the diameter of the largest " +
                    "sphere, ${2 * largest}"
            }
        }
    }

    /** A piston that is as light as a sphere would have to recoil within the step. */
    fun checkPistons() {
        val heaviest = population.mass.maxOrNull() ?: return
        for ((face, piston) in boundary.pistons) {
            check.that(
                "${WallFacesSpec.KEY}.${WallFacesSpec.NAMES[face]}.motion.mass",
                piston.mass,
                piston.mass >= LIGHTEST * heaviest,
            ) {
                "must be $LIGHTEST times the mass of the heaviest sphere, $heaviest, or more"
            }
        }
    }

    private fun checkRoom(axis: Int, largest: Double) {
        if (boundary.wallMotion(2 * axis) == null && boundary.wallMotion(2 * axis + 1) == null) return
        val room = boundary.leastRoom(axis, scenario.startTime, end)
        check.must("boundary.faces", room > 2 * largest) {
            "lets the walls across ${"xyz"[axis]} come as near to each other as $room; " +
                "that must exceed the diameter of the largest sphere, ${2 * largest}"
        }
    }

    /** A sphere that falls through the room and bounces needs √(8 l/g) to be back. */
    fun checkFall(axis: Int, duration: Double) {
        val forces = scenario.forces.mapNotNull { it.acceleration }
        if (forces.isEmpty() || scenario.frame != null) return
        val acceleration = abs(forces.sumOf { it[axis] })
        val falls = duration * sqrt(acceleration / (8 * boundary.box.length(axis)))
        check.must("timeStep", falls <= MOST_CYCLES) {
            "is so long that spheres fall $falls times through the room across ${"xyz"[axis]} in a step; " +
                "take a smaller dt"
        }
    }

    private companion object {
        /** Of a wall or a bouncing sphere in a step. More would still be right, but there are contacts in each. */
        const val MOST_CYCLES = 1000

        /** Mass of a piston over that of a sphere, at least. */
        const val LIGHTEST = 10.0
    }
}
