package daphnis.core.scenario

import daphnis.core.initial.Obstacle
import daphnis.core.population.MeanFlow

/** The large spheres of a scenario as columns, checked. */
internal class Bodies(private val specs: List<BodySpec>, private val particles: ParticlesSpec, check: ValueCheck) {
    init {
        specs.forEachIndexed { k, body ->
            val key = "bodies[$k]"
            check.extent("$key.radius", body.radius)
            check.that("$key.position", body.position, body.position.size == 3) { "must be three numbers" }
            body.velocity?.let { check.that("$key.velocity", it, it.size == 3) { "must be three numbers" } }
            check.must(key, body.mass == null || body.density == null) {
                "has a mass and a density; one of the two is enough"
            }
            body.mass?.let { check.mass("$key.mass", it) }
            body.density?.let { check.positive("$key.density", it) }
            check.must("$key.density", body.mass != null || density(body) != null) {
                "is missing; particles have materials, none of which says what this body weighs (or give mass)"
            }
        }
    }

    val radius: DoubleArray get() = DoubleArray(specs.size) { specs[it].radius }

    val mass: DoubleArray get() = DoubleArray(specs.size) {
        specs[it].mass
            ?: (density(specs[it])!! * 4.0 / 3.0 * Math.PI * cube(specs[it].radius))
    }

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
            ?: if (flow != null && flow.flowAxis == axis) flow.rate * specs[it].position[flow.normalAxis] else 0.0
    }

    private fun cube(r: Double) = r * r * r
}
