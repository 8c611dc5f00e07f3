package daphnis.core.engine.horizon

import daphnis.core.collision.StepRows
import daphnis.core.collision.contactTime
import daphnis.core.collision.storeAt
import daphnis.core.population.PopulationColumns
import daphnis.core.queue.BucketEventQueue
import daphnis.core.space.Images

/**
 * The rows of the few spheres that touch another in the present step, or would if nothing came between, and of those
 * that are near walls. The **place** of a sphere is that of its row here; its slot is that in the cells. Collisions see
 * rows, and so the same numbers as in every other engine.
 *
 * @param places where groups of different spheres can look for the row of a sphere
 * @param source what rows are made from
 */
internal class GroupSpheres(private val places: SlotPlaces, private val source: RowSource) {
    val rows = StepRows()

    /** Potential collisions of the step, by place. */
    val queue = BucketEventQueue()
    private var indexOfPlace = IntArray(INITIAL)

    /** For the states of two spheres without rows, and that which was found last. */
    private val first = DoubleArray(StepRows.STRIDE)
    private val second = DoubleArray(StepRows.STRIDE)
    var found = first
        private set

    /** Begins a window from [start] to [end] in a step of [duration], without rows. */
    fun begin(duration: Double, start: Double, end: Double, tracksLastCollision: Boolean) {
        for (place in 0 until rows.size) places.forget(indexOfPlace[place])
        rows.begin(duration, tracksLastCollision, source.optional)
        queue.reset(start, end, rows.id, 0)
    }

    /** Goes on in a window from [start] to [end], before whose collisions the queue is empty. Rows stay. */
    fun goOn(start: Double, end: Double) {
        queue.reset(start, end, rows.id, rows.size)
    }

    /** The slot of the sphere at [place]. */
    fun slotOf(place: Int): Int = source.slotOf(indexOfPlace[place])

    /** The place of the sphere in [slot]; its row is made if there is none. */
    fun placeOf(slot: Int): Int {
        val index = source.indexOf(slot)
        val place = places.of(index)
        return if (place != SlotPlaces.NONE) place else include(index)
    }

    /** The place of the sphere in [slot], here or where places are shared; [SlotPlaces.NONE] where it has no row. */
    fun presentPlaceOf(slot: Int): Int = places.of(source.indexOf(slot))

    fun has(slot: Int): Boolean = presentPlaceOf(slot) != SlotPlaces.NONE

    /** Nobody finds the row at [place] any more. */
    fun forget(place: Int) {
        places.forget(indexOfPlace[place])
    }

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
        val index = source.indexOf(slot)
        val place = places.of(index)
        if (place != SlotPlaces.NONE) {
            found = rows.state
            return place * StepRows.STRIDE
        }
        source.findState(index, room) { state, p ->
            found = state
            return p
        }
        return 0
    }

    /** Calls [use] with each slot that has a row. */
    inline fun forEachSlot(use: (Int) -> Unit) {
        for (place in 0 until rows.size) use(slotOf(place))
    }

    private fun include(index: Int): Int {
        // Before the row, so that there is none without an index when the memory ends.
        if (rows.size == indexOfPlace.size) indexOfPlace = indexOfPlace.copyOf(rows.size * 2)
        val place = source.include(index, rows)
        indexOfPlace[place] = index
        places.put(index, place)
        queue.include(place, rows.id)
        return place
    }

    /** Writes the spheres with rows, as they are at the end of a step of [duration], to [columns]. */
    fun store(columns: PopulationColumns, duration: Double) {
        rows.storeAt(columns, duration, indexOfPlace)
    }

    /** Makes later rows from these. */
    fun keep() {
        source.keep(rows, indexOfPlace)
    }

    private companion object {
        const val INITIAL = 64
    }
}
