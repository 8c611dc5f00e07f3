package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.facing
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import daphnis.core.wall.Wall
import daphnis.core.wall.WallMotion
import daphnis.core.wall.WallSet
import daphnis.core.wall.pistons
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
        val motions = (0..1).mapNotNull { boundary.walls[2 * axis + it]?.motion }
        if (motions.isEmpty()) return
        for (motion in motions) checkCycles(motion, duration, "a wall across ${"xyz"[axis]}")
        checkRoom(axis, largest)
    }

    /** The motions of surfaces in a step of [duration]. */
    fun checkSurfaceMotions(duration: Double) {
        for ((n, surface) in boundary.walls.surfaces.withIndex()) {
            surface.motion?.let { checkCycles(it, duration, "$SURFACES[$n]") }
        }
    }

    /** The distance of a sphere from [surface] at [key] is a small difference of large numbers where that is far. */
    fun checkDigits(key: String, surface: Wall) {
        val farthest = surface.farthest
        val least = population.radius.minOrNull() ?: return
        check.must(key, Math.ulp(farthest) <= StartCheck.TOLERANCE * least) {
            "a $surface, has lengths of $farthest, to which distances are known to ${Math.ulp(
                farthest,
            )} only; that must " +
                "be at most ${StartCheck.TOLERANCE} of the smallest radius, $least; take nearer points, or a plane"
        }
    }

    private fun checkCycles(motion: WallMotion, duration: Double, wall: String) {
        val cycles = motion.frequency * duration
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
        for (walls in boundary.walls.facing(scenario.startTime, end)) {
            val (plane, other) =
                if (walls.first < WallSet.FACES) walls.second to walls.first else walls.first to walls.second
            check.must(name(plane), walls.areFaces || walls.apart > 2 * largest) {
                "comes as near to ${name(other)} as ${walls.apart}; that must exceed the diameter of the largest " +
                    "sphere, ${2 * largest}"
            }
        }
    }

    private fun name(wall: Int) = if (wall < WallSet.FACES) {
        "the wall ${WallFacesSpec.NAMES[wall]}"
    } else {
        "$SURFACES[${wall - WallSet.FACES}]"
    }

    /** A piston that is as light as a sphere would have to recoil within the step. */
    fun checkPistons() {
        val heaviest = population.mass.maxOrNull() ?: return
        for ((face, piston) in boundary.walls.pistons) {
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
        val room =
            boundary.walls.facing(scenario.startTime, end).find { it.areFaces && it.first shr 1 == axis } ?: return
        check.must("boundary.faces", room.apart > 2 * largest) {
            "lets the walls across ${"xyz"[axis]} come as near to each other as ${room.apart}; " +
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
