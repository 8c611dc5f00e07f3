package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.isChanging
import daphnis.core.force.BodyGravitySpec
import daphnis.core.force.Force
import daphnis.core.force.ForcePlace
import daphnis.core.force.ForceSpec
import daphnis.core.force.SelfGravitySpec
import daphnis.core.force.UniformAccelerationSpec
import daphnis.core.force.thermostat.AndersenSpec
import daphnis.core.force.thermostat.RescalingSpec
import daphnis.core.force.thermostat.WhiteNoiseSpec
import daphnis.core.hill.HillFrame
import daphnis.core.hill.SatelliteSpec
import daphnis.core.input.Kind
import daphnis.core.input.Kinds
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies

/** The forces that a scenario can name. */
internal object ForceKinds : Kinds<ForceSpec>(
    ForceSpec::class,
    listOf(
        Kind(UniformAccelerationSpec::class, UniformAccelerationSpec.serializer()),
        Kind(SatelliteSpec::class, SatelliteSpec.serializer()),
        Kind(SelfGravitySpec::class, SelfGravitySpec.serializer()),
        Kind(BodyGravitySpec::class, BodyGravitySpec.serializer()),
        Kind(WhiteNoiseSpec::class, WhiteNoiseSpec.serializer()),
        Kind(AndersenSpec::class, AndersenSpec.serializer()),
        Kind(RescalingSpec::class, RescalingSpec.serializer()),
    ),
)

/**
 * Makes the forces of a scenario, each of which may add to the boundary conditions.
 *
 * @param around the boundary conditions without forces
 * @param firstBody id of the first of the bodies
 */
internal class ForceSetup(
    private val scenario: Scenario,
    private val orbits: OrbitalFrequencies?,
    around: BoundaryConditions,
    private val firstBody: Int,
    private val check: ValueCheck,
) {
    /** The boundary conditions with what forces add to them. */
    var boundary: BoundaryConditions = around
        private set

    /** Where each force of the scenario acts. */
    val places: List<ForcePlace>

    /** The forces of the scenario, and that of the frame. */
    val forces: List<Force>

    init {
        val among = scenario.forces.indices.filter { scenario.forces[it].isAmongAll }
        check.must("forces[${among.getOrNull(1)}]", among.size < 2) {
            "is self-gravity of all spheres, as forces[${among[0]}] is; one is enough"
        }
        val places = ArrayList<ForcePlace>()
        val made = scenario.forces.mapIndexed { k, spec ->
            val place = place(k).also { places += it }
            check.must(place.key, !scenario.space.isPlane || spec.actsOnDiscs) {
                "is a force in three dimensions; discs, with dimensions 2, know a uniform-acceleration and thermostats"
            }
            check.must(place.key, spec.allowsChangingBox || !around.isChanging) {
                "acts where images keep their distance; with boundary.perturbation > 0 there can be no force but the " +
                    "frame's and a uniform-acceleration"
            }
            spec.force(place).also { boundary = spec.boundary(place, it) }
        }
        this.places = places
        forces = if (orbits == null) made else made + HillFrame(orbits)
    }

    private fun place(k: Int): ForcePlace {
        val planet = scenario.frame?.gravitationalParameter(scenario.units)
        val distance = orbits?.let { FrameSetup.distance(scenario, it) }
        val bodies = scenario.bodies.size
        return ForcePlace(
            k, scenario.seed, scenario.units, boundary, orbits, planet, distance, bodies, firstBody, check,
        )
    }
}
