package daphnis.core.run

import daphnis.core.population.Bonds
import daphnis.core.population.Population
import daphnis.core.population.SphereQuantity
import daphnis.core.population.optional

/** A copy of all that a checkpoint holds of the spheres of [population], in the order of their ids. */
internal class SpheresById(population: Population) {
    private val order = population.indicesById()
    val ids: IntArray = IntArray(order.size) { population.id[order[it]] }

    /** By place, those that spheres have. */
    val columns: Map<Int, DoubleArray> = SphereQuantity.present(population.optional).associateWith { place ->
        val column = population.column(place)
        DoubleArray(order.size) { column[order[it]] }
    }

    /** See [Bonds.pairs]. */
    val pairs: IntArray = Bonds.pairs(population, order)
    val havePairs: Boolean = population.bonds !== Bonds.NONE

    /** Names of materials, none where spheres have none. */
    val materials: List<String> = population.materials

    /** Boxes crossed along x, y, z. */
    val boxes: List<IntArray> = List(3) { axis -> IntArray(order.size) { population.boxesCrossed(ids[it], axis) } }

    companion object {
        /** Bytes of a copy of [population]. */
        fun bytes(population: Population): Long =
            population.size * (SphereQuantity.present(population.optional).size * 8L + INTEGERS * 4L)

        /** Of each sphere: its index, its id and boxes crossed along three axes. */
        private const val INTEGERS = 5
    }
}
