package daphnis.core.run

import daphnis.core.Simulation
import daphnis.core.force.SelfGravity
import daphnis.core.output.CollisionStatistics
import daphnis.core.population.VelocityMoments

/**
 * The rows of `transport.csv`: what viscosities, pressure and energy balance are computed from. Sums over collisions count from the start of the run.
 *
 * @param omega angular speed of Hill's frame, or null
 * @param leastBody id from which on spheres are bodies and not particles
 */
internal class TransportRows(private val omega: Double?, private val leastBody: Int, private val gravity: SelfGravity?) {
    fun append(simulation: Simulation, sums: CollisionStatistics, file: AppendedFile) {
        val p = simulation.population
        val moments = VelocityMoments.of(p, simulation.boundary.meanFlow, omega, leastBody)
        var mass = 0.0
        for (id in 0 until minOf(p.idBound, leastBody)) p.indexOf(id).let { if (it >= 0) mass += p.mass[it] }
        val line = file.line()
        line.append(simulation.step).append(',').append(simulation.time).append(',').append(p.size).append(',').append(mass)
        for (m in moments.moments) line.append(',').append(m)
        for (m in moments.mean) line.append(',').append(m)
        line.append(',').append(moments.centreZ).append(',').append(moments.scaleHeight).append(',').append(moments.guidingX)
        line.append(',').append(sums.count).append(',').append(sums.sumSpeed).append(',').append(sums.dissipated)
        for (e in VIRIAL) line.append(',').append(sums.virial[e])
        line.append(',').append(gravity?.stressXY(p) ?: 0.0)
        file.endLine()
    }

    companion object {
        /** xx, yy, zz, xy, xz, yz of the nine entries by row; the tensor is symmetric. */
        private val VIRIAL = intArrayOf(0, 4, 8, 1, 2, 5)
        const val HEADER =
            "step,time,particles,mass,c_xx,c_yy,c_zz,c_xy,c_xz,c_yz,mean_vx,mean_vy,mean_vz,centre_z,scale_height,guiding_x," +
                "collisions,sum_impact_speed,dissipated,virial_xx,virial_yy,virial_zz,virial_xy,virial_xz,virial_yz,gravity_xy"
    }
}
