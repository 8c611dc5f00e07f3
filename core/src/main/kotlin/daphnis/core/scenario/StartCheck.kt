package daphnis.core.scenario

import daphnis.core.FixedTimeStep
import daphnis.core.TimeStep
import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.boundary.ShearedPeriodic
import daphnis.core.boundary.isChanging
import daphnis.core.boundary.prepare
import daphnis.core.boundary.roomAt
import daphnis.core.force.ForcePlace
import daphnis.core.input.ValueCheck
import daphnis.core.population.Population
import daphnis.core.potential.PairInteractions
import daphnis.core.search.Overlap
import daphnis.core.search.Reach
import daphnis.core.space.Images
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * Checks that a population can start in its box, with its [boundary] as it is then: all spheres are inside, the box is wide enough for its images, and no
 * spheres overlap.
 *
 * @param largestToCome the greatest radius of what sources bring; 0 where they bring nothing
 */
internal class StartCheck(
    private val scenario: Scenario,
    private val population: Population,
    private val boundary: BoundaryConditions,
    private val places: List<ForcePlace>,
    private val check: ValueCheck,
    end: Double,
    private val interactions: PairInteractions?,
    private val largestToCome: Double,
) {
    private val walls = WallCheck(scenario, population, boundary, check, end)

    /** @param isPlaced false where spheres placed at random are not where they will be */
    fun check(timeStep: TimeStep, isPlaced: Boolean = true) {
        // A length of step that follows from speeds is not known before the flow at the places is in them.
        val isKnown = isPlaced || timeStep is FixedTimeStep
        val box = boundary.box
        val largest = maxOf(population.radius.max(), largestToCome)
        for (axis in 0 until boundary.space.dimensions) {
            val length = box.length(axis)
            val key = "box.lengths[$axis]"
            when (boundary.contactFaces(axis)) {
                ContactFaces.PERIODIC -> {
                    val least = leastLength(axis, length)
                    check.that(key, scenario.box.lengths[axis], least > 2 * largest) {
                        "${narrowed(axis, least)}must exceed the diameter of the largest sphere, ${2 * largest}, " +
                            "or it would touch its own image"
                    }
                    checkReach(key, least, largest)
                    if (isKnown) checkCrossings(axis, largest, timeStep)
                }
                ContactFaces.WALL -> {
                    check.that(key, length, length > 2 * largest) {
                        "must exceed the diameter of the largest sphere, ${2 * largest}"
                    }
                    walls.check(axis, largest, if (isKnown) timeStep.next(population) else 0.0)
                }
                // Moonlets may stick out of the slab in which particles are placed.
                ContactFaces.OPEN, ContactFaces.WRAPPING -> {
                    // Of an axis that a surface closes.
                    if (isKnown &&
                        boundary.walls.surfaces.isNotEmpty()
                    ) {
                        walls.checkFall(axis, timeStep.next(population))
                    }
                    val hasRoom = scenario.bodies.isNotEmpty() || length > 2 * largest
                    check.must(key, hasRoom) { "is $length; it is thinner than the largest sphere, ${2 * largest}" }
                }
            }
            if (boundary.contactFaces(axis) != ContactFaces.OPEN) checkInside(axis)
        }
        walls.checkPistons()
        checkSurfaces()
        if (isKnown) walls.checkSurfaceMotions(timeStep.next(population))
        walls.checkPlanes(largest)
        if (isKnown) {
            checkSlide(timeStep)
            checkJumps(timeStep)
            val duration = timeStep.next(population)
            scenario.forces.forEachIndexed { k, force -> force.checkStart(places[k], population, duration) }
        }
        if (isPlaced) checkBonds()
        if (!isPlaced) return
        computable("velocities") { Reach().measure(population, boundary, timeStep.next(population)) }
        // After mergers, and while pieces leave one another, spheres overlap in states of runs too.
        if (interactions?.areHard == false || scenario.merging != null || scenario.breaking != null) return
        val overlap = computable("box") {
            Overlap.deepest(population, boundary, scenario.startTime, scenario.engine.threadsAtStart)
        }
        val isOfFile = scenario.placement.file != null
        check.must(if (isOfFile) "placement.path" else "placement", overlap.depth <= TOLERANCE) {
            val wayOut = if (isOfFile && overlap.depth <= OverlapRepair.DEEPEST) "; ${OverlapRepair.WAY_OUT}" else ""
            "particles ${overlap.first} and ${overlap.second} overlap by ${overlap.depth} of the sum of their radii; " +
                "spheres must not overlap at the start$wayOut"
        }
    }

    /** What a run that goes on needs too, as it may go on for longer than was checked at its start. */
    fun checkRooms(): Unit = walls.checkRooms()

    /** An error of the search about sizes that it cannot compute becomes an error in the scenario. */
    private inline fun <T> computable(key: String, work: () -> T): T = try {
        work()
    } catch (e: IllegalArgumentException) {
        check.fail(key, e.message.orEmpty())
    }

    /** The least length along [axis] of a box that is [now] so long. */
    private fun leastLength(axis: Int, now: Double): Double =
        if (axis == 0 && boundary.isChanging) scenario.box.lengths[0] * (1 - scenario.boundary.narrowing) else now

    private fun narrowed(axis: Int, least: Double) =
        if (axis == 0 && boundary.isChanging) "of a box that narrows to $least " else ""

    private fun checkSurfaces() {
        for ((n, surface) in boundary.walls.surfaces.withIndex()) {
            val key = "$SURFACES[$n]"
            walls.checkDigits(key, surface)
            for (k in 0 until population.size) {
                val p = population
                val free = surface.distance(p.x[k], p.y[k], p.z[k], scenario.startTime)
                check.must(placedBy(k), free >= p.radius[k] * (1 - TOLERANCE)) {
                    "particle ${p.id[k]} at (${p.x[k]} ${p.y[k]} ${p.z[k]}) with radius ${p.radius[k]} reaches out " +
                        "of the room, beyond $key, a $surface"
                }
            }
        }
    }

    private fun checkInside(axis: Int) {
        val p = population.position(axis)
        val box = boundary.roomAt(scenario.startTime)
        val wall = boundary.contactFaces(axis) == ContactFaces.WALL
        for (k in 0 until population.size) {
            val margin = if (wall) population.radius[k] * (1 - TOLERANCE) else 0.0
            val inside = p[k] - margin >= box.lower(axis) && p[k] + margin <= box.upper(axis)
            val name = "xyz"[axis]
            check.must(placedBy(k), inside) {
                "particle ${population.id[k]} at $name = ${p[k]} is outside the box, " +
                    "$name from ${box.lower(axis)} to ${box.upper(axis)}"
            }
        }
    }

    /** The key that says where sphere [k] is at the start: bodies are the last. */
    private fun placedBy(k: Int): String {
        val body = k - (population.size - scenario.bodies.size)
        return if (body >= 0) "bodies[$body].position" else "placement"
    }

    /** Each pair has one state, so only one image may be within reach. */
    private fun checkReach(key: String, length: Double, largest: Double) {
        val reach = interactions?.reach ?: return
        check.that(key, length, length > 2 * (2 * largest * reach) * (1 + IMAGE)) {
            "must exceed twice the distance up to which the largest spheres interact, ${2 * largest * reach}, " +
                "or two images would be within reach of one sphere"
        }
    }

    /** Neighbours in chains are as far apart as their tether lets them be. */
    private fun checkBonds() {
        val chains = interactions?.chains ?: return
        val p = population
        check.must("bonds.length", p.size % chains.length == 0) {
            "is ${chains.length}, and ${p.size} spheres make no whole number of chains"
        }
        val images = Images().also { it.prepare(boundary, scenario.startTime) }
        for (place in 0 until p.places) {
            val k = p.indexAt(place)
            val j = if (k < 0) -1 else p.indexOf(p.id[k] + 1)
            if (j < 0 || !chains.areTied(p.id[k], p.id[j])) continue
            val d = DoubleArray(3) { axis -> p.position(axis)[j] - p.position(axis)[k] }
            images.toNearest(d)
            val ratio = sqrt(d.sumOf { it * it }) / (p.radius[k] + p.radius[j])
            check.must(placedBy(k), ratio in chains.tether.least * (1 - TOLERANCE)..chains.tether.greatest) {
                "puts particles ${p.id[k]} and ${p.id[j]} of a chain $ratio sums of radii apart; bonds has them " +
                    "${chains.tether.least} to ${chains.tether.greatest} apart"
            }
        }
    }

    private fun checkCrossings(axis: Int, largest: Double, timeStep: TimeStep) {
        var fastest = 0.0
        for (u in population.velocity(axis)) fastest = maxOf(fastest, abs(u))
        val range = 2 * largest + 2.2 * fastest * timeStep.next(population)
        check.must("timeStep", range < boundary.box.length(axis) * MOST_BOXES) {
            "is so long that the fastest sphere passes more than once through the box " +
                "along ${"xyz"[axis]} in a step; take a smaller dt"
        }
    }

    /** If images slid by many boxes in a step, each would have to be searched. */
    private fun checkSlide(timeStep: TimeStep) {
        val shear = boundary.shear ?: return
        val slide = abs(shear.velocity) * timeStep.next(population)
        check.must("timeStep", slide < boundary.box.length(shear.slideAxis) * MOST_SLIDE) {
            "is so long that images slide by $slide in a step; take a smaller dt or shear rate"
        }
    }

    /** A sphere that passes many boxes in a step changes its speed by as many jumps. */
    private fun checkJumps(timeStep: TimeStep) {
        val jump = abs((boundary as? ShearedPeriodic ?: return).velocityJump)
        var fastest = 0.0
        for (u in population.vy) fastest = maxOf(fastest, abs(u))
        val boxes = fastest * timeStep.next(population) / boundary.box.length(1)
        check.must("timeStep", boxes * jump <= ValueCheck.MOST) {
            "is so long that the fastest sphere passes $boxes boxes along y in a step; take a smaller dt"
        }
    }

    internal companion object {
        /** The part of a size by which spheres may overlap. */
        const val TOLERANCE = Overlap.TOLERANCE
        private const val MOST_SLIDE = 4

        /** More than what a pair may be beyond an edge by rounding, see [daphnis.core.collision.PairStates]. */
        private const val IMAGE = 1e-5

        /**
         * Bound on the paths of two spheres in a step, in boxes. Longer ones would still be right, but every image in
         * between would be searched.
         */
        private const val MOST_BOXES = 3
    }
}
