package daphnis.analysis.report

import daphnis.analysis.neighbour.Cluster
import daphnis.analysis.table.Column
import daphnis.analysis.table.Table

/** `tables/clusters.csv`: a row for each cluster of the last state, the largest first. */
internal class ClusterTable(private val study: Study) {
    private val units = study.units

    fun write(all: List<Cluster>) {
        fun of(name: String, unit: String, value: (Cluster) -> Double) =
            Column(name, unit, DoubleArray(all.size) { value(all[it]) })
        val columns = arrayListOf(
            of("members", "") { it.members.toDouble() },
            of("mass", units.mass) { it.mass },
            of("spanning", "") { if (it.isSpanning) 1.0 else 0.0 },
        )
        for ((axis, name) in listOf("x", "y", "z").withIndex()) {
            columns += of(name, units.length) { it.centre[axis] }
        }
        columns += of("gyration_radius", units.length) { it.gyrationRadius }
        columns += of("filling_factor", "") { it.fillingFactor }
        if (study.input.hasVelocities) {
            for ((axis, name) in listOf("vx", "vy", "vz").withIndex()) {
                columns += of(name, units.speed) { it.velocity[axis] }
            }
            for ((axis, name) in listOf("wx", "wy", "wz").withIndex()) {
                columns += of(name, units.rate) { it.spin[axis] }
            }
            columns += of("temperature", units.temperature) { it.temperature }
        }
        Table("clusters", columns).write(study.tables)
    }
}
