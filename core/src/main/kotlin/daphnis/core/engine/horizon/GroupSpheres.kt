package daphnis.core.engine.horizon

import daphnis.core.collision.StepRows
import daphnis.core.collision.contactTime
import daphnis.core.collision.storeAt
import daphnis.core.population.PopulationColumns
import daphnis.core.population.SphereColumns
import daphnis.core.population.optional
import daphnis.core.queue.BucketEventQueue
import daphnis.core.space.Images

/** The place of the row of a sphere, by index in the columns of the step. Groups of different spheres can share one. */
internal class SlotPlaces {
    private var places = IntArray(0)

    /** Makes room for [spheres]. */
    fun reserve(spheres: Int) {
        if (places.size < spheres) places = IntArray(spheres) { NONE }
    }

    /** The place of [index]; [NONE] when it has no row. */
    fun of(index: Int): Int = places[index]

    fun put(index: Int, place: Int) {
        places[index] = place
    }

    /** [index], which may be one of a larger population before, has no row any more. */
    fun forget(index: Int) {
        if (index < places.size) places[index] = NONE
    }

    companion object {
        const val NONE = -1
    }
}

/**
 * The rows of the few spheres that touch another in the present step, or would if nothing came between, and of those
 * that are near walls. The **place** of a sphere is that of its row here; its slot is that in the cells. Collisions see
 * rows, and so the same numbers as in every other engine.
 *
 * A later window sorts spheres into cells anew, so that slots change. What does not change within a step is the
 * **index** of a sphere in the columns to which the step is written, which is its slot in the first window.
 */
internal class GroupSpheres(private val places: SlotPlaces) {
    val rows = StepRows()

    /** Potential collisions of the step, by place. */
    val queue = BucketEventQueue()
    private var indexOfPlace = IntArray(INITIAL)
    private lateinit var spheres: SphereColumns

    /** For the states of two spheres without rows, and that which was found last. */
    private val first = DoubleArray(StepRows.STRIDE)
    private val second = DoubleArray(StepRows.STRIDE)
    var found = first
        private set

    /** Index in [spheres] by index; null when the two are the same. */
    private var order: IntArray? = null

    /** Index by slot and slot by index; null when the two are the same. */
    private var indexAt: IntArray? = null
    private var slotAt: IntArray? = null

    /** Begins a step of [duration], without rows; there will be collisions until the time [end] of it. */
    fun begin(spheres: SphereColumns, order: IntArray?, duration: Double, end: Double, tracksLastCollision: Boolean) {
        this.spheres = spheres
        this.order = order
        indexAt = null
        slotAt = null
        for (place in 0 until rows.size) places.forget(indexOfPlace[place])
        rows.begin(duration, tracksLastCollision, spheres.optional)
        queue.reset(0.0, end, rows.id, 0)
    }

    /**
     * Goes on in a window from [start] to [end] of the step, before whose collisions the queue is empty. Rows stay.
     *
     * @param indexAt the index by slot from now on, and [slotAt] the reverse
     */
    fun goOn(start: Double, end: Double, indexAt: IntArray, slotAt: IntArray) {
        this.indexAt = indexAt
        this.slotAt = slotAt
        queue.reset(start, end, rows.id, rows.size)
    }

    /** The slot of the sphere at [place]. */
    fun slotOf(place: Int): Int {
        val index = indexOfPlace[place]
        return slotAt?.get(index) ?: index
    }

    private fun indexOf(slot: Int): Int = indexAt?.get(slot) ?: slot

    /** The place of the sphere in [slot]; its row is made if there is none. */
    fun placeOf(slot: Int): Int {
        val index = indexOf(slot)
        val place = places.of(index)
        return if (place != SlotPlaces.NONE) place else include(index)
    }

    /** Whether the sphere in [slot] has a row, here or where places are shared. */
    fun has(slot: Int): Boolean = places.of(indexOf(slot)) != SlotPlaces.NONE

    /**
     * The [contactTime] of the spheres in the slots [i] and [j], the second at its image [code]. Makes no rows: most
     * spheres that are due do not touch.
     */
    fun contactTime(i: Int, j: Int, code: Int, images: Images): Double {
        val p = findState(i, first)
        val a = found
        val q = findState(j, second)
        return contactTime(a, p, found, q, code, images)
    }

    /** Makes [found] the array with the state of the sphere in [slot], [room] where it has no row. @return its entry */
    fun findState(slot: Int, room: DoubleArray): Int {
        val index = indexOf(slot)
        val place = places.of(index)
        if (place != SlotPlaces.NONE) {
            found = rows.state
            return place * StepRows.STRIDE
        }
        StepRows.copyState(spheres, order?.get(index) ?: index, room, 0)
        found = room
        return 0
    }

    /** Calls [use] with each slot that has a row. */
    inline fun forEachSlot(use: (Int) -> Unit) {
        for (place in 0 until rows.size) use(slotOf(place))
    }

    private fun include(index: Int): Int {
        // Before the row, so that there is none without an index when the memory ends.
        if (rows.size == indexOfPlace.size) indexOfPlace = indexOfPlace.copyOf(rows.size * 2)
        val place = rows.include(spheres, order?.get(index) ?: index)
        indexOfPlace[place] = index
        places.put(index, place)
        queue.include(place, rows.id)
        return place
    }

    /** Writes the spheres with rows, as they are at the end of a step of [duration], to [columns]. */
    fun store(columns: PopulationColumns, duration: Double) {
        rows.storeAt(columns, duration, indexOfPlace)
    }

    private companion object {
        const val INITIAL = 64
    }
}
