package daphnis.core.population

import daphnis.core.growth.IntList

/** What a part of a population has to tell the other parts, and those that hold the whole. */
internal class PartNews {
    private val removed = IntList()
    private var born = NONE

    fun remove(id: Int): Unit = removed.add(id)

    /** Ids of the spheres that were removed in this step, once. */
    fun takeRemoved(): IntArray = removed.toArray().also { removed.clear() }

    /** Spheres with the id [first] and higher ones have come, which are on any node. */
    fun bear(first: Int) {
        born = minOf(born, first)
    }

    /** Spheres with this id or a higher one have come since the last call; [NONE] where none have. */
    fun takeBorn(): Int = born.also { born = NONE }

    companion object {
        const val NONE: Int = Int.MAX_VALUE
    }
}
