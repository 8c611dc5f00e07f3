package daphnis.core.run

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.at
import daphnis.core.boundary.isChanging
import daphnis.core.force.ForceSpec
import daphnis.core.input.InputException
import daphnis.core.scenario.BoundarySpec
import daphnis.core.scenario.FrameSetup
import daphnis.core.scenario.GrowthSpec
import daphnis.core.scenario.Scenario
import daphnis.core.scenario.Surroundings
import daphnis.core.scenario.WallFacesSpec
import kotlin.math.abs

/**
 * Checks that [scenario] can go on from a state of another run: that both mean the same by space, time and bodies.
 * Whether the spheres are inside the box and apart is checked with every initial state.
 *
 * @param source what to call the scenario in messages
 */
internal class OriginCheck(private val scenario: Scenario, private val source: String, private val from: RunOrigin) {
    private val state = from.state
    private val said = "the state of ${from.name} after step ${state.step}"

    /**
     * The scenario that starts from the state.
     *
     * @throws InputException when it does not fit the state
     */
    fun start(): Scenario {
        val other = from.scenario
        val bodies = other?.bodies.orEmpty()
        must("bodies", scenario.bodies.size == bodies.size) {
            "has ${count(scenario.bodies.size)}; $said has ${count(bodies.size)}"
        }
        val start = scenario.copy(
            placement = from.placement().copy(materials = scenario.materials.ifEmpty { null }),
            particles = null,
            sources = scenario.settledSources,
            velocities = null,
            spins = scenario.spins.takeIf { !state.hasSpin },
            firstBody = other?.firstBody(state.size)?.takeIf { bodies.isNotEmpty() },
            growth = growth(other),
            boundary = boundary(other),
            forces = forces(other),
        )
        checkCount(bodies.size)
        if (other != null) checkUnits(other)
        checkFrame()
        checkBox(Surroundings.of(start, source).boundary.at(state.time))
        return start
    }

    /** At the rate of the other run radii go on as there; another rate is over those of the state. */
    private fun growth(other: Scenario?): GrowthSpec? {
        val here = scenario.growth ?: return null
        val there = other?.growth ?: return here
        if (here.since != null && here.since != there.since) return here
        return here.since(if (here.rate == there.rate) there.since ?: other.startTime else null)
    }

    /** What was a piston in the other run is where it was in the state. */
    private fun boundary(other: Scenario?): BoundarySpec {
        val before = RunOrigin.pistonsOf(other)
        val both = scenario.boundary.pistons.keys intersect before.keys
        if (both.isEmpty()) return scenario.boundary
        val states = if (state.step == 0L) before else from.pistons().orEmpty()
        for (face in both) {
            must("${WallFacesSpec.KEY}.${WallFacesSpec.NAMES[face]}.motion", face in states) {
                "is a piston, and nothing says where it was in $said; take a state after a step that has a row in " +
                    SeriesColumns.file
            }
        }
        return scenario.boundary.withPistons(states.filterKeys { it in both })
    }

    /** What a force carried in the other run it goes on with. */
    private fun forces(other: Scenario?): List<ForceSpec> {
        val goOn = from.goingOn(scenario.forces)
        if (other == null || goOn.isEmpty()) return scenario.forces
        val states = from.forces()
        return scenario.forces.mapIndexed { k, force ->
            val state = states[goOn[k] ?: return@mapIndexed force]
            must("forces[$k]", state != null) {
                "goes on, and nothing says where it was in $said; take a state after a step that has a row in " +
                    BodyColumns.file
            }
            force.beginningWith(state!!)
        }
    }

    /** The run's own scenario says how many there were at its start, which may have been more. */
    private fun checkCount(bodies: Int) {
        val count = scenario.particles?.count ?: return
        if (count == from.scenario?.particles?.count) return
        val there = state.size - bodies
        must("particles.count", count == there) { "is $count; $said has $there" }
    }

    private fun checkUnits(other: Scenario) {
        val here = scenario.units
        val there = other.units
        if (here.lengthInMetres == null || there.lengthInMetres == null) return
        fun same(key: String, here: Double, there: Double) {
            must("units.$key", here == there) { "is $here; $said is in units of $there" }
        }
        same("lengthInMetres", here.lengthInMetres, there.lengthInMetres)
        same("speedInCmPerSecond", here.speedInCmPerSecond, there.speedInCmPerSecond)
        same("massInKg", here.massInKg, there.massInKg)
    }

    /** Velocities are those in the frame. */
    private fun checkFrame() {
        val there = from.around ?: return
        val here = FrameSetup.frequencies(scenario, source)
        val omega = here?.omega
        must("frame", (omega == null) == (there.angularSpeed == null)) {
            if (omega == null) "is missing; $said is in Hill's frame" else "is given; $said is in none"
        }
        if (omega == null) return
        must("frame", omega == there.angularSpeed) {
            "turns with an angular speed of $omega; $said is in one with ${there.angularSpeed}"
        }
        val (radial, former) = listOf(here, there.frequencies).map { it?.radialFactor }
        must("frame", radial == former) { "has κ/Ω $radial; $said is in one with $former" }
    }

    /** Of the [boundary] as it is at the time of the state. */
    private fun checkBox(boundary: BoundaryConditions) {
        // One that changes is computed anew: only round-off may differ.
        val most = if (boundary.isChanging) SAME else 0.0
        for (axis in 0..2) {
            val length = state.lengths[axis]
            if (length.isNaN() || !state.periodic[axis] || !boundary.repeats(axis)) continue
            val here = boundary.box.length(axis)
            must("box.lengths[$axis]", abs(here - length) <= most * length) {
                val time = if (boundary.isChanging) " at time ${state.time}" else ""
                "is $here$time; $said is of a periodic box of $length there"
            }
        }
        checkImages(boundary)
    }

    /** At a boundary whose images begin elsewhere the surroundings of every sphere near it would change at once. */
    private fun checkImages(boundary: BoundaryConditions) {
        val shear = boundary.shear
        if (shear == null && (state.shearOffset == 0.0 || !boundary.repeats(state.normalAxis))) return
        val isAcross = shear == null ||
            state.shearOffset == 0.0 ||
            (shear.normalAxis == state.normalAxis && shear.slideAxis == state.slideAxis)
        val offset = shear?.offset(state.time) ?: 0.0
        val length = boundary.box.length(shear?.slideAxis ?: state.slideAxis)
        val off = abs(offset - state.shearOffset).let { minOf(it, length - it) }
        must("boundary", isAcross && off <= SAME * length) {
            "puts images off by $offset at time ${state.time}; in $said they are off by ${state.shearOffset}" +
                shear?.takeUnless { boundary.isChanging }?.let { mend(it.velocity) }.orEmpty()
        }
    }

    /** The same state at a time at which the images are where they were. */
    private fun mend(velocity: Double): String {
        if (velocity == 0.0) return ""
        val time = state.shearOffset / velocity
        return "; placement.path with placement.time $time takes a snapshot of it at a time with the same images"
    }

    private fun count(bodies: Int) = if (bodies == 1) "1 entry" else "$bodies entries"

    private inline fun must(key: String, ok: Boolean, problem: () -> String) {
        if (!ok) throw InputException(source, key, problem())
    }

    private companion object {
        /** Round-off of the time in places of images and in the box, relative to the box. */
        const val SAME = 1e-9
    }
}
