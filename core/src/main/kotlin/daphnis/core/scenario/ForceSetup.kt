package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.force.BodyGravity
import daphnis.core.force.Force
import daphnis.core.force.UniformAcceleration
import daphnis.core.hill.HillFrame
import daphnis.core.hill.Satellite
import daphnis.core.hill.SatelliteSurface
import daphnis.core.input.ValueCheck
import daphnis.core.orbit.OrbitalFrequencies

/** Makes the forces of a scenario; a satellite with a radius also adds to the boundary conditions. */
internal class ForceSetup(
    private val scenario: Scenario,
    private val frequencies: OrbitalFrequencies?,
    private val check: ValueCheck,
) {
    /** The boundary conditions with what forces add to them; complete after [forces]. */
    lateinit var boundary: BoundaryConditions
        private set

    /** @param firstBody id of the first of the bodies */
    fun forces(boundary: BoundaryConditions, firstBody: Int): List<Force> {
        this.boundary = boundary
        val mutual = scenario.forces.indices.filter { scenario.forces[it] is ForceSpec.SelfGravity }
        check.must("forces[${mutual.getOrNull(1)}]", mutual.size < 2) {
            "is self-gravity of all spheres, as forces[${mutual[0]}] is; one is enough"
        }
        val forces = scenario.forces.mapIndexed { k, spec -> force(spec, k, firstBody) }
        return if (frequencies == null) forces else forces + HillFrame(frequencies)
    }

    private fun force(spec: ForceSpec, place: Int, firstBody: Int): Force {
        val key = "forces[$place]"
        check.must(key, !scenario.space.isPlane || spec is ForceSpec.UniformAcceleration || spec is ThermostatSpec) {
            "is a force in three dimensions; discs, with dimensions 2, know a uniform-acceleration and thermostats"
        }
        return when (spec) {
            is ForceSpec.UniformAcceleration -> uniformAcceleration(spec, key)
            is ForceSpec.Satellite -> satellite(spec, key)
            is ForceSpec.SelfGravity ->
                SelfGravitySetup(boundary, check).force(spec, key) { constant(spec.constant, key) }
            is ForceSpec.BodyGravity -> bodyGravity(spec, key, firstBody)
            is ThermostatSpec -> ThermostatSetup(scenario.seed, boundary, firstBody, check).force(spec, place)
        }
    }

    private fun uniformAcceleration(spec: ForceSpec.UniformAcceleration, key: String): Force {
        val a = spec.acceleration
        check.that("$key.acceleration", a, a.size == 3) { "must be three numbers" }
        requireInPlane(a, scenario.space, "$key.acceleration", check)
        return UniformAcceleration(a[0], a[1], a[2])
    }

    private fun bodyGravity(spec: ForceSpec.BodyGravity, key: String, firstBody: Int): Force {
        check.must(key, scenario.bodies.isNotEmpty()) { "is body-gravity; it needs bodies" }
        check.that("$key.softening", spec.softening, spec.softening >= 0) { "must be at least 0" }
        val ids = IntArray(scenario.bodies.size) { firstBody + it }
        return BodyGravity(ids, boundary, constant(spec.constant, key), spec.softening)
    }

    private fun constant(given: Double?, key: String): Double {
        if (given != null) {
            check.that("$key.constant", given, given >= 0) { "must be at least 0" }
            return given
        }
        val constant = scenario.units.gravitationalConstant
            ?: check.fail("$key.constant", "is missing; give it, or units.lengthInMetres, from which it follows")
        check.must("units", constant.isFinite()) { "make Newton's constant $constant; it must be finite" }
        return constant
    }

    private fun satellite(spec: ForceSpec.Satellite, key: String): Satellite {
        val orbits = frequencies ?: check.fail(key, "is a satellite; it needs a frame of type hill")
        check.must(key, (spec.massRatio == null) != (spec.mass == null)) { "needs exactly one of massRatio and mass" }
        val strength = if (spec.mass != null) {
            check.positive("$key.mass", spec.mass)
            spec.mass * constant(spec.constant, key)
        } else {
            check.positive("$key.massRatio", spec.massRatio!!)
            check.must("$key.constant", spec.constant == null) {
                "goes with mass; the pull of a massRatio follows from the planet"
            }
            val parameter = (scenario.frame as FrameSpec.Hill).gravitationalParameter(scenario.units)
                ?: check.fail("units.lengthInMetres", "is missing; the mass ratio of a satellite needs it")
            spec.massRatio * parameter
        }
        check.must(key, strength.isFinite()) { "has a mass that makes its gravity $strength; it must be finite" }
        check.that("$key.softening", spec.softening, spec.softening >= 0) { "must be at least 0" }
        check.that("$key.e", spec.e, spec.e >= 0) { "must be at least 0" }
        check.that("$key.radius", spec.radius, spec.radius >= 0) { "must be at least 0 (0 for a point)" }
        check.that("$key.inclination", spec.inclination, spec.inclination >= 0) { "must be at least 0" }
        val satellite = Satellite(strength, spec.orbit, orbits, spec.softening, circumference(spec, orbits, key))
        if (spec.radius > 0) boundary = SatelliteSurface(boundary, satellite, spec.radius)
        return satellite
    }

    /** Of the orbit along which the moon [spec] comes back; infinite when it does not. */
    private fun circumference(spec: ForceSpec.Satellite, orbits: OrbitalFrequencies, key: String): Double {
        if (!spec.returns) return Double.POSITIVE_INFINITY
        val distance = FrameSetup.distance(scenario, orbits)
            ?: check.fail("units.lengthInMetres", "is missing; $key returns along an orbit whose length it needs")
        val circumference = 2 * Math.PI * distance
        check.must("$key.returns", scenario.box.lengths[1] < circumference) {
            "needs a patch that is shorter than the orbit, $circumference"
        }
        return circumference
    }
}
