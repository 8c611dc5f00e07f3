package daphnis.core.scenario

import daphnis.core.boundary.BoundaryConditions
import daphnis.core.boundary.ContactFaces
import daphnis.core.initial.Obstacle
import daphnis.core.input.ValueCheck
import daphnis.core.population.MeanFlow
import daphnis.core.space.Space

/** The large spheres of a scenario as columns, checked. */
internal class Bodies(
    private val specs: List<BodySpec>,
    private val particles: ParticlesSpec,
    private val space: Space,
    private val check: ValueCheck,
) {
    init {
        specs.forEachIndexed { k, body ->
            val key = "bodies[$k]"
            check.extent("$key.radius", body.radius)
            check.that("$key.position", body.position, body.position.size == 3) { "must be three numbers" }
            body.velocity?.let { check.that("$key.velocity", it, it.size == 3) { "must be three numbers" } }
            check.inSpace("$key.position", body.position, space)
            body.velocity?.let { check.inSpace("$key.velocity", it, space) }
            check.must(key, body.mass == null || body.density == null) {
                "has a mass and a density; one of the two is enough"
            }
            body.mass?.let { check.mass("$key.mass", it) }
            body.density?.let { check.positive("$key.density", it) }
            check.must("$key.density", body.mass != null || density(body) != null) {
                "is missing; particles have materials, none of which says what this body weighs (or give mass)"
            }
            if (body.mass == null) {
                val density = density(body)!!
                check.mass("$key.density", density, body.radius, mass(density, body.radius))
            }
        }
    }

    /** Refuses those that have no room within [boundary]; along an open axis they may stick out of the box. */
    fun checkRoom(boundary: BoundaryConditions) {
        for (axis in 0 until space.dimensions) {
            val faces = boundary.contactFaces(axis)
            if (faces != ContactFaces.PERIODIC && faces != ContactFaces.WALL) continue
            val length = boundary.box.length(axis)
            specs.forEachIndexed { k, body ->
                check.that("bodies[$k].radius", body.radius, 2 * body.radius < length) {
                    "must be less than half of the edge of the box along ${"xyz"[axis]}, $length"
                }
            }
        }
    }

    val radius: DoubleArray get() = DoubleArray(specs.size) { specs[it].radius }

    val mass: DoubleArray get() = DoubleArray(specs.size) {
        specs[it].mass
            ?: mass(density(specs[it])!!, specs[it].radius)
    }

    /** Of spheres in the order of products that is in the bits of runs. */
    private fun mass(density: Double, r: Double) =
        if (space.isPlane) density * space.volume(r) else density * 4.0 / 3.0 * Math.PI * (r * r * r)

    /** Its own, else that of other spheres of its material, else, where there are no materials, that of all. */
    private fun density(body: BodySpec): Double? = body.density ?: particles.materials.let { all ->
        if (all == null) {
            particles.density
        } else {
            all.find { it.name == body.material }?.takeIf { it.mass == null }?.density
        }
    }

    val obstacles: List<Obstacle> get() = specs.map {
        Obstacle(it.position[0], it.position[1], it.position[2], it.radius)
    }

    fun position(axis: Int): DoubleArray = DoubleArray(specs.size) { specs[it].position[axis] }

    /** The given velocities, otherwise those of the mean flow. */
    fun velocity(axis: Int, flow: MeanFlow?): DoubleArray = DoubleArray(specs.size) {
        specs[it].velocity?.get(axis)
            ?: flow?.gradient(axis)?.takeIf { it != 0.0 }?.let { by -> by * specs[it].position[flow.normalAxis] } ?: 0.0
    }
}
