package daphnis.core.engine.horizon

import daphnis.core.collision.StepRows
import daphnis.core.collision.storeAt
import daphnis.core.population.Population
import daphnis.core.population.PopulationColumns
import daphnis.core.queue.BucketEventQueue

/** The place of the row of a sphere, by slot. Groups whose slots differ can share one. */
internal class SlotPlaces {
    private var places = IntArray(0)

    /** Makes room for [spheres]. */
    fun reserve(spheres: Int) {
        if (places.size < spheres) places = IntArray(spheres) { NONE }
    }

    /** The place of [slot]; [NONE] when it has no row. */
    fun of(slot: Int): Int = places[slot]

    fun put(slot: Int, place: Int) {
        places[slot] = place
    }

    /** [slot], which may be one of a larger population before, has no row any more. */
    fun forget(slot: Int) {
        if (slot < places.size) places[slot] = NONE
    }

    companion object {
        const val NONE = -1
    }
}

/**
 * The rows of the few spheres that may collide in the present step. The **place** of a sphere is that of its row here;
 * its slot is that in the epoch. Collisions see rows, and so the same numbers as in every other engine.
 */
internal class EpochBodies(private val places: SlotPlaces) {
    val rows = StepRows()

    /** Potential collisions of the step, by place. */
    val queue = BucketEventQueue()
    private var slotOfPlace = IntArray(INITIAL)
    private lateinit var population: Population

    /** Index in the population by slot; null when the two are the same. */
    private var order: IntArray? = null

    /** Begins a step of [duration], without rows. */
    fun begin(population: Population, order: IntArray?, duration: Double, tracksLastCollision: Boolean) {
        this.population = population
        this.order = order
        for (place in 0 until rows.size) places.forget(slotOfPlace[place])
        rows.begin(duration, tracksLastCollision)
        queue.reset(duration, rows.id, 0)
    }

    /** The slot of the sphere at [place]. */
    fun slotOf(place: Int): Int = slotOfPlace[place]

    /** The place of the sphere in [slot]; its row is made if there is none. */
    fun placeOf(slot: Int): Int {
        val place = places.of(slot)
        return if (place != SlotPlaces.NONE) place else include(slot)
    }

    /** Whether the sphere in [slot] has a row, here or where places are shared. */
    fun has(slot: Int): Boolean = places.of(slot) != SlotPlaces.NONE

    /** Calls [use] with each slot that has a row. */
    inline fun forEachSlot(use: (Int) -> Unit) {
        for (place in 0 until rows.size) use(slotOf(place))
    }

    private fun include(slot: Int): Int {
        // Before the row, so that there is none without a slot when the memory ends.
        if (rows.size == slotOfPlace.size) slotOfPlace = slotOfPlace.copyOf(rows.size * 2)
        val place = rows.include(population, order?.get(slot) ?: slot)
        slotOfPlace[place] = slot
        places.put(slot, place)
        queue.include(place, rows.id)
        return place
    }

    /** Writes the spheres with rows, as they are at the end of a step of [duration], to [columns]. */
    fun store(columns: PopulationColumns, duration: Double) {
        rows.storeAt(columns, duration, slotOfPlace)
    }

    private companion object {
        const val INITIAL = 64
    }
}
