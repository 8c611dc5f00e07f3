package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.force.SelfGravity
import daphnis.core.population.PopulationSums

/**
 * The rows of `transport.csv`: what viscosities, pressure and energy balance are computed from. Sums over collisions
 * count from the start of the run.
 */
internal class TransportRows(private val gravity: SelfGravity?) {
    /** @param sums of the simulation's population as it stands */
    fun append(simulation: Simulation, sums: PopulationSums, collisions: CollisionStatistics, file: AppendedFile) {
        val line = file.line()
        line.append(simulation.step).append(',').append(simulation.time)
        line.append(',').append(sums.count).append(',').append(sums.particleMass)
        for (m in sums.moments) line.append(',').append(m)
        for (m in sums.mean) line.append(',').append(m)
        line.append(',').append(sums.centreZ).append(',').append(sums.scaleHeight).append(',').append(sums.guidingX)
        line.append(',').append(collisions.count)
        line.append(',').append(collisions.sumSpeed).append(',').append(collisions.dissipated)
        for (e in VIRIAL) line.append(',').append(collisions.virial[e])
        line.append(',').append(gravity?.stressXY(simulation.population, simulation.time) ?: 0.0)
        for (m in sums.kinetic) line.append(',').append(m)
        file.endLine()
    }

    companion object {
        /** xx, yy, zz, xy, xz, yz of the nine entries by row; the tensor is symmetric. */
        private val VIRIAL = intArrayOf(0, 4, 8, 1, 2, 5)
        const val HEADER =
            "step,time,particles,mass,c_xx,c_yy,c_zz,c_xy,c_xz,c_yz,mean_vx,mean_vy,mean_vz,centre_z,scale_height,guiding_x," +
                "collisions,sum_impact_speed,dissipated," +
                "virial_xx,virial_yy,virial_zz,virial_xy,virial_xz,virial_yz,gravity_xy," +
                "kinetic_xx,kinetic_yy,kinetic_zz,kinetic_xy,kinetic_xz,kinetic_yz"
    }
}
