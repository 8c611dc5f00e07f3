package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.hill.Epicycle
import daphnis.core.hill.Satellite
import daphnis.core.orbit.OrbitalFrequencies

/** Something heavy whose orbit `bodies.csv` follows. */
internal interface Traced {
    /** Of its rows. */
    val id: Int

    /** Of orbits; null without Hill's frame. */
    val orbits: OrbitalFrequencies?

    /** Mass, after the step of [simulation]. */
    fun mass(simulation: Simulation): Double

    /** Position and velocity x y z v_x v_y v_z then; null when it is gone. Allocates. */
    fun state(simulation: Simulation): DoubleArray?

    /** Its epicycle then; null without Hill's frame, and when it is gone. */
    fun orbit(simulation: Simulation): Epicycle?

    /** X as if no face had been crossed. NaN without Hill's frame, and when it is gone. */
    fun guidingX(simulation: Simulation): Double
}

/** A body of the scenario, which is a sphere. */
internal class TracedSphere(override val id: Int, override val orbits: OrbitalFrequencies?) : Traced {
    override fun mass(simulation: Simulation) = simulation.population.let { it.mass[it.indexOf(id)] }

    override fun state(simulation: Simulation): DoubleArray? {
        val p = simulation.population
        val k = p.indexOf(id)
        return if (k < 0) null else doubleArrayOf(p.x[k], p.y[k], p.z[k], p.vx[k], p.vy[k], p.vz[k])
    }

    override fun orbit(simulation: Simulation): Epicycle? {
        val s = state(simulation) ?: return null
        return orbits?.let { Epicycle.of(s[0], s[1], s[2], s[3], s[4], s[5], it) }
    }

    override fun guidingX(simulation: Simulation): Double {
        val p = simulation.population
        val k = p.indexOf(id)
        if (k < 0) return Double.NaN
        val width = if (simulation.boundary.repeats(0)) simulation.boundary.box.length(0) else 0.0
        return orbits?.let { it.guidingX(p.x[k], p.vy[k]) + p.boxesCrossed(id, 0) * width } ?: Double.NaN
    }
}

/** A satellite that feels the ring. */
internal class TracedMoon(
    override val id: Int,
    private val satellite: Satellite,
    override val orbits: OrbitalFrequencies,
) : Traced {
    override fun mass(simulation: Simulation) = satellite.mass

    override fun state(simulation: Simulation): DoubleArray = satellite.state(simulation.time)

    override fun orbit(simulation: Simulation): Epicycle = satellite.orbit(simulation.time)

    override fun guidingX(simulation: Simulation) = satellite.orbit.guidingX

    companion object {
        /** Those of [simulation], the first of all satellites being −1, the second −2; none without [orbits]. */
        fun all(simulation: Simulation, orbits: OrbitalFrequencies?): List<TracedMoon> {
            if (orbits == null) return emptyList()
            return simulation.forces.filterIsInstance<Satellite>()
                .mapIndexed { k, satellite -> TracedMoon(-1 - k, satellite, orbits) }
                .filter { it.satellite.isFree }
        }
    }
}
