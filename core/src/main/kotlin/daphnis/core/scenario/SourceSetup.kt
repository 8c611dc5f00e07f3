package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.Box
import daphnis.core.boundary.isChanging
import daphnis.core.input.ValueCheck
import daphnis.core.source.Sources
import daphnis.core.source.Supply
import daphnis.core.space.Space

/** Makes the sources and sinks of a [scenario]; null where it has none. */
internal class SourceSetup(
    scenario: Scenario,
    around: Surroundings,
    boundary: BoundaryConditions,
    materials: Materials,
    check: ValueCheck,
) {
    val sources: Sources? = scenario.settledSources.takeIf { it.isNotEmpty() }?.let { specs ->
        fun need(isMet: Boolean, what: String) = check.must("sources", isMet) { "need $what" }
        need(scenario.bodies.isEmpty(), "spheres without bodies, which have the highest ids")
        need(scenario.interactions.isEmpty() && scenario.bonds == null, "spheres without interaction and bonds")
        need(scenario.growth == null, "spheres that do not grow, without growth")
        val duration = around.end - scenario.startTime
        Sources(
            specs.mapIndexed { k, spec ->
                spec.source(
                    SourcePlace("sources[$k]", scenario, around.box, boundary, materials.names, duration, check),
                )
            },
            scenario.seed,
        )
    }
}

/**
 * Where a source of a scenario is: what the scenario says besides it.
 *
 * @property key what messages call the source
 * @property duration of the run
 */
public class SourcePlace internal constructor(
    public val key: String,
    private val scenario: Scenario,
    private val placed: Box,
    private val boundary: BoundaryConditions,
    private val materials: List<String>,
    public val duration: Double,
    public val check: ValueCheck,
) {
    public val space: Space get() = boundary.space

    private fun need(isMet: Boolean, what: String) = check.must(key, isMet) { "needs $what" }

    /** Refuses what spheres cannot come into. */
    internal fun requireRoomToCome() {
        need(boundary.shear == null && boundary.meanFlow == null && !boundary.isChanging, "a box that is not sheared")
        need(boundary.walls.areKnownAhead, "walls that are no pistons")
    }

    /** Refuses what is no gas whose chemical potential is known. */
    internal fun requireGas() {
        need(scenario.forces.isEmpty() && scenario.frame == null, "spheres on which no force acts, and no frame")
        need(scenario.merging == null && scenario.breaking == null, "spheres that neither merge nor break")
    }

    /** The box of [region]. @param brings whether spheres come in it */
    internal fun box(region: RegionSpec, brings: Boolean): Box {
        val axes = space.dimensions
        val lower = DoubleArray(axes)
        val upper = DoubleArray(axes)
        for ((axis, range) in region.ranges.withIndex()) {
            val its = "$key.region.${"xyz"[axis]}"
            check.must(its, axis < axes || range == null) { "is given; with dimensions 2 there is no z" }
            if (axis >= axes) continue
            val all = if (brings && !boundary.box.length(axis).isFinite()) placed else boundary.box
            lower[axis] = range?.getOrNull(0) ?: all.lower(axis)
            upper[axis] = range?.getOrNull(1) ?: all.upper(axis)
            if (range == null) continue
            check.that(its, range, range.size == 2 && range[0] < range[1]) {
                "must be two numbers, the lower one first"
            }
            val isInside = range[0] >= boundary.box.lower(axis) && range[1] <= boundary.box.upper(axis)
            check.that(its, range, isInside && range.all { Math.abs(it) <= ValueCheck.MOST }) {
                "must be within the box, ${boundary.box.lower(axis)} to ${boundary.box.upper(axis)}"
            }
        }
        return if (space.isPlane) {
            Box.flat(lower[0], lower[1], upper[0], upper[1])
        } else {
            Box(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2])
        }
    }

    /** The number of the face that [name] names, through which a stream of [velocity] and [sigma] comes. */
    internal fun face(name: String, velocity: List<Double>, sigma: Double, region: RegionSpec): Int {
        val its = "$key.through"
        val face = WallFacesSpec.NAMES.indexOf(name)
        check.that(its, name, face in 0 until 2 * space.dimensions) {
            "must be one of ${WallFacesSpec.NAMES.take(2 * space.dimensions).joinToString()}"
        }
        val axis = face shr 1
        check.must(its, boundary.box.length(axis).isFinite()) { "is $name; the box is open there, and has no face" }
        check.must(its, boundary.walls[face]?.motion == null) { "is $name, which is a wall that moves" }
        check.must("$key.region", region.ranges[axis] == null) {
            "has ${"xyz"[axis]}; leave it out, since spheres come through $name"
        }
        val inward = if (face and 1 == 0) velocity[axis] else -velocity[axis]
        check.that("$key.velocity", velocity, inward >= 0 && inward + sigma > 0) {
            "must go inward through $name, or have no part across it and a sigma > 0"
        }
        return face
    }

    /** The spheres that are [given]. */
    internal fun supply(given: SupplySpec): Supply {
        val its = "$key.particles"
        given.material?.let { name ->
            check.that("$its.material", name, name in materials) {
                val known = if (materials.isEmpty()) "there is none" else "known: ${materials.joinToString()}"
                "must be a material of the scenario; $known"
            }
        }
        val sizes = given.sizes
            ?: check.fail("$its.sizes", "is missing; the scenario has no particles of which these could be some")
        check.must("$its.sizes", !sizes.isInOrder) { "are a list, which has an order; spheres that come are drawn" }
        val density = given.density ?: 1.0
        val kind = SphereKind.of(its, sizes, density, given.mass, space, check)
        return Supply(kind.sizes, kind.most, density, given.mass, maxOf(0, materials.indexOf(given.material)))
    }
}
