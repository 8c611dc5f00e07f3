package daphnis.core.engine.horizon

import daphnis.core.collision.StepRows
import daphnis.core.population.SphereColumns
import daphnis.core.population.optional

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
 * What rows are made from: the spheres before the step and, in a later window, the rows that groups had in the windows
 * before it.
 *
 * A later window sorts spheres into cells anew, so that slots change. What does not change within a step is the
 * **index** of a sphere in the columns to which the step is written, which is its slot in the first window.
 */
internal class RowSource {
    private lateinit var spheres: SphereColumns

    /** Index in [spheres] by index; null when the two are the same. */
    private var order: IntArray? = null

    /** Index by slot and slot by index; null when the two are the same. */
    private var indexAt: IntArray? = null
    private var slotAt: IntArray? = null

    /** Rows of windows before. */
    private val kept = StepRows()
    private val places = SlotPlaces()
    private var indexOfPlace = IntArray(INITIAL)

    /** Quantities that spheres have. */
    val optional: Int get() = spheres.optional

    /** Begins a step of [duration] of [spheres], of which [count] have an index. */
    fun begin(spheres: SphereColumns, count: Int, order: IntArray?, duration: Double, tracksLastCollision: Boolean) {
        this.spheres = spheres
        this.order = order
        indexAt = null
        slotAt = null
        for (place in 0 until kept.size) places.forget(indexOfPlace[place])
        places.reserve(count)
        kept.begin(duration, tracksLastCollision, spheres.optional)
    }

    /** Goes on in another window of the step. @param indexAt index by slot from now on, and [slotAt] the reverse */
    fun goOn(indexAt: IntArray, slotAt: IntArray) {
        this.indexAt = indexAt
        this.slotAt = slotAt
    }

    fun indexOf(slot: Int): Int = indexAt?.get(slot) ?: slot

    fun slotOf(index: Int): Int = slotAt?.get(index) ?: index

    /** Appends the row of [index] to [rows]. @return its place there */
    fun include(index: Int, rows: StepRows): Int {
        val place = places.of(index)
        if (place != SlotPlaces.NONE) return rows.take(kept, place)
        return rows.include(spheres, order?.get(index) ?: index)
    }

    /** Finds the state of [index]: calls [use] with an array and the entry there; [room] where it has none yet. */
    inline fun findState(index: Int, room: DoubleArray, use: (DoubleArray, Int) -> Unit) {
        val place = keptPlace(index)
        if (place != SlotPlaces.NONE) return use(keptState(), place * StepRows.STRIDE)
        copyState(index, room)
        use(room, 0)
    }

    fun keptPlace(index: Int): Int = places.of(index)

    fun keptState(): DoubleArray = kept.state

    fun copyState(index: Int, room: DoubleArray) {
        StepRows.copyState(spheres, order?.get(index) ?: index, room, 0)
    }

    /** The window is over: [rows] of the spheres with [indices] are those from which later ones are made. */
    fun keep(rows: StepRows, indices: IntArray) {
        for (k in 0 until rows.size) {
            val index = indices[k]
            val place = places.of(index)
            if (place != SlotPlaces.NONE) {
                kept.put(place, rows, k)
            } else {
                // Before the row, so that there is none without an index when the memory ends.
                if (kept.size == indexOfPlace.size) indexOfPlace = indexOfPlace.copyOf(kept.size * 2)
                val new = kept.take(rows, k)
                indexOfPlace[new] = index
                places.put(index, new)
            }
        }
    }

    private companion object {
        const val INITIAL = 64
    }
}
