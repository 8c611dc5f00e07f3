package daphnis.core.cluster

import daphnis.core.population.ExactSum
import daphnis.core.population.Partition
import daphnis.core.population.Population

/** The spheres that the nodes of a crew hold together. */
internal class NodePartition(private val turns: Turns) : Partition {
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
}
