package daphnis.core.engine.horizon

import daphnis.core.collision.StepRows
import daphnis.core.collision.storeAt
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.queue.BucketEventQueue

/**
 * The rows of the few spheres that may collide in the present step. The **place** of a sphere is that of its row here;
 * its slot is that in the epoch. Collisions see rows, and so the same numbers as in every other engine.
 */
internal class EpochBodies {
    val rows = StepRows()

    /** Potential collisions of the step, by place. */
    val queue = BucketEventQueue()
    private var placeOfSlot = IntArray(0)
    private var slotOfPlace = IntArray(INITIAL)
    private lateinit var population: Population

    /** Index in the population by slot; null when the two are the same. */
    private var order: IntArray? = null

    /** Begins a step of [duration], without rows. */
    fun begin(population: Population, order: IntArray?, duration: Double, tracksLastCollision: Boolean) {
        this.population = population
        this.order = order
        for (place in 0 until rows.size) {
            val slot = slotOfPlace[place]
            if (slot < placeOfSlot.size) placeOfSlot[slot] = NONE
        }
        if (placeOfSlot.size < population.size) placeOfSlot = IntArray(population.size) { NONE }
        rows.begin(duration, tracksLastCollision)
        queue.reset(duration, rows.id, 0)
    }

    /** The slot of the sphere at [place]. */
    fun slotOf(place: Int): Int = slotOfPlace[place]

    /** The place of the sphere in [slot]; its row is made if there is none. */
    fun placeOf(slot: Int): Int {
        val place = placeOfSlot[slot]
        return if (place != NONE) place else include(slot)
    }

    private fun include(slot: Int): Int {
        // Before the row, so that there is none without a slot when the memory ends.
        if (rows.size == slotOfPlace.size) slotOfPlace = slotOfPlace.copyOf(rows.size * 2)
        val place = rows.include(population, order?.get(slot) ?: slot)
        slotOfPlace[place] = slot
        placeOfSlot[slot] = place
        queue.include(place, rows.id)
        return place
    }

    /** Writes the spheres with rows, as they are at the end of a step of [duration], to [columns]. */
    fun store(columns: PopulationColumns, duration: Double) {
        rows.storeAt(columns, duration, slotOfPlace)
    }

    private companion object {
        const val NONE = -1
        const val INITIAL = 64
    }
}
