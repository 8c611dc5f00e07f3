package daphnis.core.run

import daphnis.core.population.Population

/** A copy of all that a checkpoint holds of the spheres of [population], in the order of their ids. */
internal class SpheresById(population: Population) {
    private val order = population.indicesById()
    val ids: IntArray = IntArray(order.size) { population.id[order[it]] }
    val columns: List<DoubleArray> = population.run {
        listOf(x, y, z, vx, vy, vz, radius, mass, lastCollision)
    }.map { column -> DoubleArray(order.size) { column[order[it]] } }

    /** Boxes crossed along x, y, z. */
    val boxes: List<IntArray> = List(3) { axis -> IntArray(order.size) { population.boxesCrossed(ids[it], axis) } }

    companion object {
        /** Bytes for each sphere. */
        const val BYTES: Long = 92
    }
}
