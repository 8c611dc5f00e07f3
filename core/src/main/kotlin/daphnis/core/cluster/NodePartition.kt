package daphnis.core.cluster

import daphnis.core.population.ExactSum
import daphnis.core.population.Partition
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.SphereQuantity
import java.nio.ByteBuffer

/** The spheres that the nodes of a crew hold together. */
internal class NodePartition(private val turns: Turns) : Partition {
    override val isFirst: Boolean get() = turns.rank == 0

    override fun find(population: Population, ids: IntArray, place: DoubleArray) {
        Partition.Whole.find(population, ids, place)
        for (theirs in turns.gather(place.copyOf())) {
            for (k in place.indices) if (!theirs[k].isNaN()) place[k] = theirs[k]
        }
    }

    override fun merge(sums: Array<ExactSum>) {
        val mine = sums.map { it.parts().toDoubleArray() }
        turns.tell({ for (parts in mine) int(parts.size).doubles(parts) }) { _, message ->
            for (sum in sums) sum.addAll(message.doubles(message.int))
        }
    }

    override fun add(numbers: DoubleArray) {
        val mine = numbers.copyOf()
        turns.tell({ doubles(mine) }) { _, message ->
            val theirs = message.doubles(numbers.size)
            for (k in numbers.indices) numbers[k] += theirs[k]
        }
    }

    override fun max(numbers: DoubleArray) = turns.max(numbers)

    override fun gather(own: IntArray): IntArray {
        var all = own
        turns.tell({ int(own.size).ints(own) }) { _, message -> all += message.ints(message.int) }
        return all
    }

    override fun everyone(population: Population, places: IntArray): SphereColumns {
        if (turns.size == 1) return population
        val heard = ArrayList<ByteBuffer>()
        turns.tell({ writeColumns(population, places) }) { _, message -> heard += message }
        val size = population.size + heard.sumOf { it.getInt(it.position()) }
        val columns = Array(SphereQuantity.WIDTH) { if (it in places) DoubleArray(size) else SphereQuantity.NONE }
        val ids = IntArray(size)
        for (place in places) population.column(place).copyInto(columns[place], 0, 0, population.size)
        population.id.copyInto(ids, 0, 0, population.size)
        var at = population.size
        for (message in heard) {
            val count = message.int
            for (place in places) message.doubles(count, columns[place], at)
            message.ints(count, ids, at)
            at += count
        }
        return PopulationColumns(columns, ids)
    }

    private fun MessageWriter.writeColumns(population: Population, places: IntArray) {
        room(HEAD + population.size.toLong() * (places.size * Double.SIZE_BYTES + Int.SIZE_BYTES))
        int(population.size)
        for (place in places) doubles(population.column(place), 0, population.size)
        ints(population.id, 0, population.size)
    }

    private companion object {
        const val HEAD = Int.SIZE_BYTES
    }
}
